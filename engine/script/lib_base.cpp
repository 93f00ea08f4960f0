// The operators that rewrite.cpp turns into calls, ordered walks, and tostring without addresses.
#include "engine/script/state.h"

#include "engine/core/log.h"
#include "engine/math/trig.h"

#include <algorithm>
#include <cmath>

namespace brittle::script {
namespace {

int orderOf(int type) {
  return type == LUA_TNUMBER ? 0 : (type == LUA_TSTRING ? 1 : 2);
}

[[gnu::noinline]] int refuseKey(lua_State* lua, const char* who) {
  return raise(lua, "%s: a table or function used as a key has no place in the order of keys", who);
}

/// The next key after the one given, by comparison: a walk with next alone costs the square of the size, and is charged
/// so.
int nextKey(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  lua_settop(lua, 2);
  Key after{}, best{}, key{};
  const bool first = lua_isnil(lua, 2);
  if (!first && !readKey(lua, 2, after)) return refuseKey(lua, "next");
  bool found = false;
  int seen = 0;
  for (lua_pushnil(lua); lua_next(lua, 1) != 0; ++seen) {
    lua_pop(lua, 1);
    if (!readKey(lua, -1, key)) return refuseKey(lua, "next");
    if ((!first && !(after < key)) || (found && !(key < best))) continue;
    best = key;
    found = true;
  }
  charge(lua, seen / 4);
  if (!found) {
    lua_pushnil(lua);
    return 1;
  }
  pushKey(lua, best);
  lua_pushvalue(lua, -1);
  lua_rawget(lua, 1);
  return 2;
}

/// Upvalues: the keys in order, how many, how many are done. What was set to nil since the walk began is passed over.
int walkStep(lua_State* lua) {
  lua_settop(lua, 1);
  const int size = static_cast<int>(lua_tointeger(lua, lua_upvalueindex(2)));
  int at = static_cast<int>(lua_tointeger(lua, lua_upvalueindex(3)));
  while (at < size) {
    lua_rawgeti(lua, lua_upvalueindex(1), ++at);
    lua_pushvalue(lua, -1);
    lua_rawget(lua, 1);
    if (!lua_isnil(lua, -1)) break;
    lua_pop(lua, 2);
  }
  lua_pushinteger(lua, at);
  lua_replace(lua, lua_upvalueindex(3));
  if (lua_gettop(lua) == 1) lua_pushnil(lua);
  return lua_gettop(lua) - 1;
}

int pairsInOrder(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  if (!sortKeys(lua, 1)) return refuseKey(lua, "pairs");
  const std::vector<Key>& keys = SandboxState::of(lua).keys;
  const int size = static_cast<int>(keys.size());
  charge(lua, size);
  lua_createtable(lua, size, 0);
  for (int i = 0; i < size; ++i) {
    pushKey(lua, keys[static_cast<std::size_t>(i)]);
    lua_rawseti(lua, -2, i + 1);
  }
  lua_pushinteger(lua, size);
  lua_pushinteger(lua, 0);
  lua_pushcclosure(lua, walkStep, 3);
  lua_pushvalue(lua, 1);
  return 2;
}

int toText(lua_State* lua) {
  luaL_checkany(lua, 1);
  lua_settop(lua, 1);
  pushText(lua, 1);
  return 1;
}

void logLine(SandboxState& state, const char* text, std::size_t size) {
  const std::pair<int, int> place = state.place();
  logInfo(state.withFiles("~" + std::to_string(place.first) + ":" + std::to_string(place.second) + ": ") +
          std::string(text, size));
}

int print(lua_State* lua) {
  charge(lua, 1000);  // a line of log costs more than an instruction
  const int count = lua_gettop(lua);
  luaL_Buffer line;
  luaL_buffinit(lua, &line);
  for (int i = 1; i <= count; ++i) {
    if (i > 1) luaL_addchar(&line, ' ');
    pushText(lua, i);
    luaL_addvalue(&line);
  }
  luaL_pushresult(&line);
  std::size_t size = 0;
  const char* text = lua_tolstring(lua, -1, &size);
  logLine(SandboxState::of(lua), text, size);
  return 0;
}

double operand(lua_State* lua, int index) {
  int isNumber = 0;
  const double value = lua_tonumberx(lua, index, &isNumber);
  if (isNumber == 0) raise(lua, "attempt to perform arithmetic on a %s value", luaL_typename(lua, index));
  return value;
}

}  // namespace

bool operator<(const Key& a, const Key& b) {
  const int orderA = orderOf(a.type);
  const int orderB = orderOf(b.type);
  if (orderA != orderB) return orderA < orderB;
  return a.type == LUA_TSTRING ? a.text < b.text : a.number < b.number;
}

bool readKey(lua_State* lua, int index, Key& key) {
  key = {lua_type(lua, index), 0.0, {}};
  if (key.type == LUA_TNUMBER) {
    key.number = lua_tonumber(lua, index);
  } else if (key.type == LUA_TBOOLEAN) {
    key.number = lua_toboolean(lua, index);
  } else if (key.type == LUA_TSTRING) {
    std::size_t size = 0;
    const char* text = lua_tolstring(lua, index, &size);
    key.text = {text, size};
  } else {
    return false;
  }
  return true;
}

bool sortKeys(lua_State* lua, int index) {
  const int table = lua_absindex(lua, index);
  std::vector<Key>& keys = SandboxState::of(lua).keys;
  keys.clear();
  luaL_checkstack(lua, 4, "walk");
  for (lua_pushnil(lua); lua_next(lua, table) != 0; lua_pop(lua, 1)) {
    Key key{};
    if (!readKey(lua, -2, key)) {
      lua_pop(lua, 2);
      return false;
    }
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());  // keys differ, so this is a total order
  return true;
}

void pushKey(lua_State* lua, const Key& key) {
  if (key.type == LUA_TNUMBER) {
    lua_pushnumber(lua, key.number);
  } else if (key.type == LUA_TBOOLEAN) {
    lua_pushboolean(lua, key.number != 0.0 ? 1 : 0);
  } else {
    lua_pushlstring(lua, key.text.data(), key.text.size());
  }
}

int lengthOf(lua_State* lua, int index) {
  const auto isNilAt = [lua, index](int i) {
    lua_rawgeti(lua, index, i);
    const bool isNil = lua_isnil(lua, -1);
    lua_pop(lua, 1);
    return isNil;
  };
  int filled = 0;
  int empty = 1;
  while (!isNilAt(empty)) {
    filled = empty;
    if (empty > (1 << 29)) break;
    empty *= 2;
  }
  while (empty - filled > 1) {
    const int middle = (filled + empty) / 2;
    (isNilAt(middle) ? empty : filled) = middle;
  }
  return filled;
}

void pushText(lua_State* lua, int index) {
  switch (lua_type(lua, index)) {
    case LUA_TSTRING:
      lua_pushvalue(lua, index);
      break;
    case LUA_TNUMBER:
      // the sign of a NaN differs between processors
      if (const double value = lua_tonumber(lua, index); value != value) {
        lua_pushliteral(lua, "nan");
      } else {
        lua_pushvalue(lua, index);
        lua_tolstring(lua, -1, nullptr);
      }
      break;
    case LUA_TBOOLEAN:
      lua_pushstring(lua, lua_toboolean(lua, index) != 0 ? "true" : "false");
      break;
    default:
      lua_pushstring(lua, luaL_typename(lua, index));
      break;
  }
}

int applyOperator(lua_State* lua) {
  lua_settop(lua, 3);
  std::size_t size = 0;
  const char* name = lua_tolstring(lua, 1, &size);
  if (size == 1 && *name == '#') {
    if (lua_type(lua, 2) == LUA_TSTRING) {
      lua_pushinteger(lua, static_cast<lua_Integer>(lua_rawlen(lua, 2)));
    } else if (lua_istable(lua, 2)) {
      lua_pushinteger(lua, lengthOf(lua, 2));
    } else {
      return raise(lua, "attempt to get length of a %s value", luaL_typename(lua, 2));
    }
    return 1;
  }
  if (size != 1 || (*name != '^' && *name != '%')) return raise(lua, "attempt to call a string value");
  const double a = operand(lua, 2);
  const double b = operand(lua, 3);
  lua_pushnumber(lua, *name == '^' ? power(a, b) : a - std::floor(a / b) * b);
  return 1;
}

void addBase(lua_State* lua) {
  const luaL_Reg functions[] = {
      {"next", nextKey}, {"pairs", pairsInOrder}, {"tostring", toText}, {"print", print}, {nullptr, nullptr}};
  luaL_setfuncs(lua, functions, 0);
}

}  // namespace brittle::script
