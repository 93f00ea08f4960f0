#include "engine/script/numbering.h"

#include "engine/script/state.h"

namespace brittle::script {
namespace {

// Keys of the registry. kNumbers: function or built-in table -> number; kNumbered: the reverse; kBuiltins: name ->
// value.
constexpr const char* kNumbers = "numbers";
constexpr const char* kNumbered = "numbered";
constexpr const char* kBuiltins = "builtins";

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

void pushNumberingTables(lua_State* lua) {
  lua_settop(lua, 0);
  getRegistered(lua, kNumbers);
  getRegistered(lua, kNumbered);
}

void pushBuiltins(lua_State* lua) {
  getRegistered(lua, kBuiltins);
}

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
  pushBuiltins(lua);
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

}  // namespace brittle::script
