// Saving and restoring. What a script can reach is a graph of tables and functions. Functions are code: those that
// exist after the sources were loaded have the same numbers in every sandbox that loaded the same sources, so a number
// stands for one, and what is saved of it are the variables it shares with others (its upvalues). Tables are written
// breadth first, each once, keys in order, so the bytes depend on the contents alone and may be hashed.
#include "engine/script/sandbox.h"

#include "engine/script/state.h"

#include <algorithm>
#include <cmath>

namespace brittle::script {
namespace {

// Keys of the registry. kNumbers: function or built-in table -> number; kNumbered: the reverse; kBuiltins: name ->
// value.
constexpr const char* kNumbers = "numbers";
constexpr const char* kNumbered = "numbered";
constexpr const char* kBuiltins = "builtins";

constexpr std::uint32_t kFormat = 0x53524232;  // "BRS2"

/// Tables that are filled one by one end up to twice as large as a constructor makes them, and are copied as they grow.
constexpr std::size_t kRestoreSlack = 4;

enum class Tag : std::uint8_t { Nil, False, True, Number, Text, Table, Numbered };

void getRegistered(lua_State* lua, const char* name) {
  lua_getfield(lua, LUA_REGISTRYINDEX, name);
}

/// Gives the value on top of the stack the next number, unless it has one. Stack: numbers at 1, numbered at 2.
bool giveNumber(lua_State* lua) {
  lua_pushvalue(lua, -1);
  lua_rawget(lua, 1);
  const bool isNew = lua_isnil(lua, -1);
  lua_pop(lua, 1);
  if (!isNew) return false;
  const int number = static_cast<int>(lua_rawlen(lua, 2)) + 1;
  lua_pushvalue(lua, -1);
  lua_pushinteger(lua, number);
  lua_rawset(lua, 1);
  lua_pushvalue(lua, -1);
  lua_rawseti(lua, 2, number);
  return true;
}

void pushNumberingTables(lua_State* lua) {
  lua_settop(lua, 0);
  getRegistered(lua, kNumbers);
  getRegistered(lua, kNumbered);
}

/// Puts the value on top into the list at 3 if it is a table or function met for the first time (4: those met). Pops
/// it.
void visit(lua_State* lua, int& listed) {
  if (lua_istable(lua, -1) || (lua_isfunction(lua, -1) && lua_iscfunction(lua, -1) == 0)) {
    lua_pushvalue(lua, -1);
    lua_rawget(lua, 4);
    const bool met = !lua_isnil(lua, -1);
    lua_pop(lua, 1);
    if (!met) {
      lua_pushvalue(lua, -1);
      lua_pushboolean(lua, 1);
      lua_rawset(lua, 4);
      lua_rawseti(lua, 3, ++listed);
      return;
    }
  }
  lua_pop(lua, 1);
}

void visitContents(lua_State* lua, int& listed) {
  const int object = lua_gettop(lua);
  if (lua_istable(lua, object)) {
    if (!sortKeys(lua, object)) return;
    const std::vector<Key>& keys = SandboxState::of(lua).keys;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      pushKey(lua, keys[i]);
      lua_rawget(lua, object);
      visit(lua, listed);
    }
  } else {
    for (int i = 1; lua_getupvalue(lua, object, i) != nullptr; ++i) visit(lua, listed);
  }
}

}  // namespace

void rememberBuiltins(lua_State* lua) {
  lua_settop(lua, 0);
  for (const char* name : {kNumbers, kNumbered, kBuiltins}) {
    lua_createtable(lua, name == kNumbered ? 256 : 0, name == kNumbered ? 0 : 256);
    lua_pushvalue(lua, -1);
    lua_setfield(lua, LUA_REGISTRYINDEX, name);
  }
  lua_pushglobaltable(lua);  // 4
  sortKeys(lua, 4);
  std::vector<Key>& names = SandboxState::of(lua).outerKeys;
  names = SandboxState::of(lua).keys;
  for (const Key& key : names) {
    pushKey(lua, key);
    pushKey(lua, key);
    lua_rawget(lua, 4);
    const bool isLibrary = lua_istable(lua, -1) && !lua_rawequal(lua, -1, 4);
    if (isLibrary || lua_isfunction(lua, -1)) giveNumber(lua);
    if (isLibrary) {
      sortKeys(lua, -1);
      const int table = lua_gettop(lua);
      for (const Key& inner : SandboxState::of(lua).keys) {
        pushKey(lua, inner);
        lua_rawget(lua, table);
        if (lua_isfunction(lua, -1)) giveNumber(lua);
        lua_pop(lua, 1);
      }
    }
    lua_rawset(lua, 3);
  }
  SandboxState::of(lua).builtins = static_cast<int>(lua_rawlen(lua, 2));
  lua_settop(lua, 0);
}

bool isBuiltin(lua_State* lua, const char* name) {
  getRegistered(lua, kBuiltins);
  lua_getfield(lua, -1, name);
  const bool same = lua_rawequal(lua, -1, -3) != 0;
  lua_pop(lua, 2);
  return same;
}

void numberFunctions(lua_State* lua) {
  pushNumberingTables(lua);
  lua_newtable(lua);  // 3: what is reached, in order
  lua_newtable(lua);  // 4: what is in 3
  int listed = 0;
  lua_pushglobaltable(lua);
  visit(lua, listed);
  for (int at = 1; at <= listed; ++at) {
    lua_rawgeti(lua, 3, at);
    if (lua_isfunction(lua, -1)) {
      giveNumber(lua);
      visitContents(lua, listed);
    } else {
      lua_pushvalue(lua, -1);
      lua_rawget(lua, 1);
      const bool isLibrary = !lua_isnil(lua, -1);
      lua_pop(lua, 1);
      if (!isLibrary) visitContents(lua, listed);
    }
    lua_settop(lua, 4);
  }
  lua_settop(lua, 0);
}

namespace {

/// Stack: 1 numbers, 2 numbered, 3 tables in the order they are met, 4 table -> place in 3, 5 built-ins, 6 the globals.
class Saver {
 public:
  Saver(lua_State* lua, ByteWriter& out) : lua_(lua), out_(out) {}

  void run() {
    pushNumberingTables(lua_);
    lua_newtable(lua_);
    lua_newtable(lua_);
    getRegistered(lua_, kBuiltins);
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
    getRegistered(lua_, kBuiltins);
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

Status Sandbox::save(ByteWriter& out) const {
  SandboxState& state = *state_;
  ByteWriter written;
  written.write(kFormat);
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

Status Sandbox::restore(ByteReader& in) {
  SandboxState& state = *state_;
  if (in.read<std::uint32_t>() != kFormat) return Error{"this is no saved script state"};
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
