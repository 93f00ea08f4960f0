// table: every length is lengthOf, and sort is a stable merge sort that no comparison function can lead astray.
#include "engine/script/state.h"

#include <algorithm>

namespace brittle::script {
namespace {

constexpr int kMostResults = 1000;

int insert(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  const int end = lengthOf(lua, 1) + 1;
  const int count = lua_gettop(lua);
  if (count != 2 && count != 3) return raise(lua, "table.insert: 2 or 3 arguments are expected, got %d", count);
  const int position = count == 3 ? luaL_checkint(lua, 2) : end;
  if (position < 1 || position > end) return raise(lua, "table.insert: position %d is not in 1 to %d", position, end);
  charge(lua, (end - position) / 4);
  for (int i = end; i > position; --i) {
    lua_rawgeti(lua, 1, i - 1);
    lua_rawseti(lua, 1, i);
  }
  lua_pushvalue(lua, count);
  lua_rawseti(lua, 1, position);
  return 0;
}

int removeAt(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  const int size = lengthOf(lua, 1);
  const int position = luaL_optint(lua, 2, size);
  if (!lua_isnoneornil(lua, 2) && (position < 1 || position > size + 1) && !(size == 0 && position == 0))
    return raise(lua, "table.remove: position %d is not in 1 to %d", position, size + 1);
  charge(lua, (size - position) / 4);
  lua_rawgeti(lua, 1, position);
  for (int i = position; i < size; ++i) {
    lua_rawgeti(lua, 1, i + 1);
    lua_rawseti(lua, 1, i);
  }
  lua_pushnil(lua);
  lua_rawseti(lua, 1, std::max(position, size));
  return 1;
}

int concatenate(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  lua_settop(lua, 4);
  std::size_t separatorSize = 0;
  const char* separator = luaL_optlstring(lua, 2, "", &separatorSize);
  const int first = luaL_optint(lua, 3, 1);
  const int last = lua_isnil(lua, 4) ? lengthOf(lua, 1) : luaL_checkint(lua, 4);
  luaL_Buffer text;
  luaL_buffinit(lua, &text);
  for (std::int64_t i = first; i <= last; ++i) {
    charge(lua, 1);
    lua_rawgeti(lua, 1, static_cast<int>(i));
    if (lua_isstring(lua, -1) == 0)
      return raise(lua, "table.concat: the value at index %d is a %s", static_cast<int>(i), luaL_typename(lua, -1));
    luaL_addvalue(&text);
    if (i < last) luaL_addlstring(&text, separator, separatorSize);
  }
  luaL_pushresult(&text);
  return 1;
}

int unpack(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  const int first = luaL_optint(lua, 2, 1);
  const int last = lua_isnoneornil(lua, 3) ? lengthOf(lua, 1) : luaL_checkint(lua, 3);
  const std::int64_t count = static_cast<std::int64_t>(last) - first + 1;
  if (count > kMostResults) return raise(lua, "table.unpack: at most %d values", kMostResults);
  if (count <= 0) return 0;
  charge(lua, count);
  luaL_checkstack(lua, static_cast<int>(count), "table.unpack");
  for (std::int64_t i = first; i <= last; ++i) lua_rawgeti(lua, 1, static_cast<int>(i));
  return static_cast<int>(count);
}

int pack(lua_State* lua) {
  const int count = lua_gettop(lua);
  charge(lua, count);
  lua_createtable(lua, count, 1);
  lua_insert(lua, 1);
  for (int i = count; i >= 1; --i) lua_rawseti(lua, 1, i);
  lua_pushinteger(lua, count);
  lua_setfield(lua, 1, "n");
  return 1;
}

/// Whether the value at stack index `b` comes strictly before the one at `a`.
bool comesBefore(lua_State* lua, int b, int a) {
  charge(lua, 2);
  if (lua_isnil(lua, 2)) return lua_compare(lua, b, a, LUA_OPLT) != 0;
  lua_pushvalue(lua, 2);
  lua_pushvalue(lua, b);
  lua_pushvalue(lua, a);
  lua_call(lua, 2, 1);
  const bool before = lua_toboolean(lua, -1) != 0;
  lua_pop(lua, 1);
  return before;
}

/// Merges [low, middle) and [middle, high) of the table at `from` into the table at `to`.
void merge(lua_State* lua, int from, int to, int low, int middle, int high) {
  int a = low;
  int b = middle;
  for (int i = low; i < high; ++i) {
    lua_rawgeti(lua, from, a < middle ? a : b);
    const bool choose = a < middle && b < high;
    if (choose) lua_rawgeti(lua, from, b);
    if (choose && comesBefore(lua, 6, 5)) {
      ++b;
    } else {
      lua_settop(lua, 5);
      ++(a < middle ? a : b);
    }
    lua_rawseti(lua, to, i);
    lua_settop(lua, 4);
  }
}

int sort(lua_State* lua) {
  luaL_checktype(lua, 1, LUA_TTABLE);
  lua_settop(lua, 2);
  if (!lua_isnil(lua, 2)) luaL_checktype(lua, 2, LUA_TFUNCTION);
  const int size = lengthOf(lua, 1);
  lua_createtable(lua, size, 0);  // 3 and 4: two copies that take turns, so that an error half-way loses nothing
  lua_createtable(lua, size, 0);
  for (int i = 1; i <= size; ++i) {
    lua_rawgeti(lua, 1, i);
    lua_rawseti(lua, 3, i);
  }
  int from = 3;
  for (int width = 1; width < size; width *= 2, from = 7 - from)
    for (int low = 1; low <= size; low += 2 * width)
      merge(lua, from, 7 - from, low, std::min(low + width, size + 1), std::min(low + 2 * width, size + 1));
  for (int i = 1; i <= size; ++i) {
    lua_rawgeti(lua, from, i);
    lua_rawseti(lua, 1, i);
  }
  return 0;
}

}  // namespace

void addTables(lua_State* lua) {
  const luaL_Reg functions[] = {{"insert", insert}, {"remove", removeAt}, {"concat", concatenate}, {"unpack", unpack},
                                {"pack", pack},     {"sort", sort},       {nullptr, nullptr}};
  lua_newtable(lua);
  luaL_setfuncs(lua, functions, 0);
  lua_getfield(lua, -1, "unpack");  // where Lua 5.1 had it
  lua_setfield(lua, -3, "unpack");
  lua_setfield(lua, -2, "table");
}

}  // namespace brittle::script
