#include "engine/script/numbering.h"
#include "engine/script/sandbox.h"
#include "engine/script/snapshot.h"
#include "engine/script/state.h"

#include <algorithm>

namespace brittle::script {
namespace {

/// Stack: 1 numbers, 2 numbered, 3 tables in the order they are met, 4 table -> place in 3, 5 built-ins, 6 the globals.
class Saver {
 public:
  Saver(lua_State* lua, ByteWriter& out) : lua_(lua), out_(out) {}

  void run() {
    pushNumberingTables(lua_);
    lua_newtable(lua_);
    lua_newtable(lua_);
    pushBuiltins(lua_);
    lua_pushglobaltable(lua_);
    const int functions = static_cast<int>(lua_rawlen(lua_, 2));
    out_.write(static_cast<std::uint32_t>(functions));
    lua_pushvalue(lua_, 6);
    writeTop(nullptr);
    for (int i = SandboxState::of(lua_).builtins + 1; i <= functions; ++i) writeUpvalues(i);
    for (int i = 1; i <= tables_; ++i) writeTable(i);
  }

 private:
  void writeUpvalues(int number) {
    lua_rawgeti(lua_, 2, number);
    const int function = lua_gettop(lua_);
    if (lua_isfunction(lua_, -1) && lua_iscfunction(lua_, -1) == 0)
      for (int i = 1; const char* name = lua_getupvalue(lua_, function, i); ++i) writeTop(name);
    lua_pop(lua_, 1);
  }

  void writeTable(int place) {
    lua_rawgeti(lua_, 3, place);
    const int table = lua_gettop(lua_);
    const bool isGlobals = lua_rawequal(lua_, table, 6) != 0;
    if (isGlobals) writeRemovedBuiltins(table);
    if (!(isGlobals ? sortChangedGlobals(table) : sortKeys(lua_, table)))
      raise(lua_, "a table or function used as a key cannot be saved");
    const std::vector<Key>& keys = SandboxState::of(lua_).keys;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      pushKey(lua_, keys[i]);
      lua_pushvalue(lua_, -1);
      lua_rawget(lua_, table);
      lua_insert(lua_, -2);
      writeTop(nullptr);
      writeTop(keys[i].type == LUA_TSTRING ? keys[i].text.data() : "a table");
    }
    out_.write(Tag::Nil);
    lua_pop(lua_, 1);
  }

  /// sortKeys for the globals: without the built-in ones, which are most.
  bool sortChangedGlobals(int table) {
    std::vector<Key>& keys = SandboxState::of(lua_).keys;
    keys.clear();
    for (lua_pushnil(lua_); lua_next(lua_, table) != 0; lua_pop(lua_, 1)) {
      Key key{};
      if (!readKey(lua_, -2, key)) return false;
      if (!isUnchanged()) keys.push_back(key);
    }
    std::sort(keys.begin(), keys.end());
    return true;
  }

  /// Whether the value on top is the built-in of the name below it.
  bool isUnchanged() {
    lua_pushvalue(lua_, -2);
    lua_rawget(lua_, 5);
    const bool same = lua_rawequal(lua_, -1, -2) != 0;
    lua_pop(lua_, 1);
    return same;
  }

  bool isABuiltinRemoved(int table) {
    for (lua_pushnil(lua_); lua_next(lua_, 5) != 0;) {
      lua_pop(lua_, 1);
      lua_pushvalue(lua_, -1);
      lua_rawget(lua_, table);
      const bool removed = lua_isnil(lua_, -1);
      lua_pop(lua_, removed ? 2 : 1);
      if (removed) return true;
    }
    return false;
  }

  void writeRemovedBuiltins(int table) {
    if (!isABuiltinRemoved(table)) return;
    sortKeys(lua_, 5);
    for (const Key& key : SandboxState::of(lua_).keys) {
      pushKey(lua_, key);
      lua_pushvalue(lua_, -1);
      lua_rawget(lua_, table);
      if (lua_isnil(lua_, -1)) {
        lua_insert(lua_, -2);
        writeTop(nullptr);
        writeTop(nullptr);
      } else {
        lua_pop(lua_, 2);
      }
    }
  }

  /// Writes and pops the value on top. `where` names it if it cannot be written.
  void writeTop(const char* where) {
    switch (lua_type(lua_, -1)) {
      case LUA_TNIL:
        out_.write(Tag::Nil);
        break;
      case LUA_TBOOLEAN:
        out_.write(lua_toboolean(lua_, -1) != 0 ? Tag::True : Tag::False);
        break;
      case LUA_TNUMBER:
        writeNumber(lua_tonumber(lua_, -1));
        break;
      case LUA_TSTRING:
        writeText();
        break;
      case LUA_TTABLE:
        if (!writeNumbered()) writeTableReference();
        break;
      default:
        if (!writeNumbered())
          raise(lua_, "'%s': a function made while running cannot be saved", where != nullptr ? where : "?");
    }
    lua_pop(lua_, 1);
  }

  void writeNumber(double value) {
    out_.write(Tag::Number);
    out_.write(value == value ? value : __builtin_nan(""));
  }

  void writeText() {
    std::size_t size = 0;
    const char* text = lua_tolstring(lua_, -1, &size);
    out_.write(Tag::Text);
    out_.write(static_cast<std::uint32_t>(size));
    out_.writeBytes(text, size);
  }

  bool writeNumbered() {
    lua_pushvalue(lua_, -1);
    lua_rawget(lua_, 1);
    const auto number = static_cast<std::uint32_t>(lua_tointeger(lua_, -1));
    lua_pop(lua_, 1);
    if (number == 0) return false;
    out_.write(Tag::Numbered);
    out_.write(number);
    return true;
  }

  void writeTableReference() {
    lua_pushvalue(lua_, -1);
    lua_rawget(lua_, 4);
    auto place = static_cast<std::uint32_t>(lua_tointeger(lua_, -1));
    lua_pop(lua_, 1);
    if (place == 0) {
      place = static_cast<std::uint32_t>(++tables_);
      lua_pushvalue(lua_, -1);
      lua_rawseti(lua_, 3, tables_);
      lua_pushvalue(lua_, -1);
      lua_pushinteger(lua_, tables_);
      lua_rawset(lua_, 4);
    }
    out_.write(Tag::Table);
    out_.write(place);
  }

  lua_State* lua_;
  ByteWriter& out_;
  int tables_ = 0;
};

}  // namespace

Status Sandbox::save(ByteWriter& out) const {
  SandboxState& state = *state_;
  ByteWriter written;
  written.write(kSnapshotFormat);
  written.write(state.random.state());
  written.write(state.random.increment());
  written.write(state.price);
  state.beginRun(0);
  state.unlimited = true;
  const int status = state.protect([&written](lua_State* lua) {
    Saver(lua, written).run();
    lua_settop(lua, 0);
  });
  state.unlimited = false;
  if (status != LUA_OK) return state.takeError(status);
  out.writeBytes(written.bytes().data(), written.bytes().size());
  return Done{};
}

}  // namespace brittle::script
