#include "engine/script/numbering.h"
#include "engine/script/sandbox.h"
#include "engine/script/snapshot.h"
#include "engine/script/state.h"

#include <algorithm>
#include <cmath>

namespace brittle::script {
namespace {

/// Tables that are filled one by one end up to twice as large as a constructor makes them, and are copied as they grow.
constexpr std::size_t kRestoreSlack = 4;

/// Stack: 1 numbers, 2 numbered, 3 tables by place, 4 the globals.
class Restorer {
 public:
  Restorer(lua_State* lua, ByteReader& in) : lua_(lua), in_(in) {}

  void run() {
    pushNumberingTables(lua_);
    lua_newtable(lua_);
    lua_pushglobaltable(lua_);
    const int functions = static_cast<int>(lua_rawlen(lua_, 2));
    if (in_.read<std::uint32_t>() != static_cast<std::uint32_t>(functions))
      return refuse("it was saved with other scripts");
    resetGlobals();
    lua_pushvalue(lua_, 4);
    lua_rawseti(lua_, 3, 1);
    tables_ = 1;
    readValue();  // the globals themselves
    lua_pop(lua_, 1);
    for (int i = SandboxState::of(lua_).builtins + 1; i <= functions; ++i) readUpvalues(i);
    for (int i = 1; i <= tables_; ++i) readTable(i);
    if (!in_.ok()) refuse("it is cut short or damaged");
  }

 private:
  void refuse(const char* why) { raise(lua_, "a saved script state cannot be restored: %s", why); }

  void resetGlobals() {
    sortKeys(lua_, 4);
    for (const Key& key : SandboxState::of(lua_).keys) {
      pushKey(lua_, key);
      lua_pushnil(lua_);
      lua_rawset(lua_, 4);
    }
    pushBuiltins(lua_);
    for (lua_pushnil(lua_); lua_next(lua_, 5) != 0; lua_pop(lua_, 1)) {
      lua_pushvalue(lua_, -2);
      lua_pushvalue(lua_, -2);
      lua_rawset(lua_, 4);
    }
    lua_settop(lua_, 4);
  }

  void readUpvalues(int number) {
    lua_rawgeti(lua_, 2, number);
    const int function = lua_gettop(lua_);
    if (lua_isfunction(lua_, -1) && lua_iscfunction(lua_, -1) == 0) {
      for (int i = 1; lua_getupvalue(lua_, function, i) != nullptr; ++i) {
        lua_pop(lua_, 1);
        readValue();
        lua_setupvalue(lua_, function, i);
      }
    }
    lua_settop(lua_, 4);
  }

  void readTable(int place) {
    lua_rawgeti(lua_, 3, place);
    while (readValue()) {
      readValue();
      const bool isUsable =
          !lua_isnil(lua_, -2) && !(lua_type(lua_, -2) == LUA_TNUMBER && std::isnan(lua_tonumber(lua_, -2)));
      if (!isUsable) return refuse("it is damaged");
      lua_rawset(lua_, -3);
    }
    lua_settop(lua_, 4);
  }

  /// Pushes a value; false if it is nil.
  bool readValue() {
    const auto tag = in_.read<Tag>();
    if (!in_.ok()) refuse("it is cut short or damaged");
    switch (tag) {
      case Tag::Nil:
        lua_pushnil(lua_);
        return false;
      case Tag::False:
        lua_pushboolean(lua_, 0);
        return true;
      case Tag::True:
        lua_pushboolean(lua_, 1);
        return true;
      case Tag::Number:
        lua_pushnumber(lua_, in_.read<double>());
        return true;
      case Tag::Text:
        readText();
        return true;
      case Tag::Table:
        readTableReference();
        return true;
      case Tag::Numbered:
        readNumbered();
        return true;
    }
    refuse("it is damaged");
    return false;
  }

  void readText() {
    const auto size = in_.read<std::uint32_t>();
    if (size > in_.remaining()) return refuse("it is cut short or damaged");
    luaL_Buffer text;
    char* room = luaL_buffinitsize(lua_, &text, size);
    in_.readBytes(room, size);
    luaL_pushresultsize(&text, size);
  }

  void readTableReference() {
    const auto place = in_.read<std::uint32_t>();
    const auto known = static_cast<std::uint32_t>(tables_);
    if (place == 0 || place > known + 1) return refuse("it is damaged");
    if (place == known + 1) {
      lua_newtable(lua_);
      lua_rawseti(lua_, 3, ++tables_);
    }
    lua_rawgeti(lua_, 3, static_cast<int>(place));
  }

  void readNumbered() {
    const auto number = in_.read<std::uint32_t>();
    if (number == 0 || number > lua_rawlen(lua_, 2)) return refuse("it is damaged");
    lua_rawgeti(lua_, 2, static_cast<int>(number));
  }

  lua_State* lua_;
  ByteReader& in_;
  int tables_ = 0;
};

}  // namespace

Status Sandbox::restore(ByteReader& in) {
  SandboxState& state = *state_;
  if (in.read<std::uint32_t>() != kSnapshotFormat) return Error{"this is no saved script state"};
  const auto position = in.read<std::uint64_t>();
  const auto increment = in.read<std::uint64_t>();
  const auto price = in.read<std::uint32_t>();
  state.beginRun(0);
  state.slack = kRestoreSlack;
  const int status = state.protect([&in](lua_State* lua) {
    Restorer(lua, in).run();
    lua_settop(lua, 0);
  });
  state.slack = 1;
  if (status != LUA_OK) return state.takeError(status);
  state.random.restore(position, increment);
  state.price = std::max(price, 1u);
  return Done{};
}

}  // namespace brittle::script
