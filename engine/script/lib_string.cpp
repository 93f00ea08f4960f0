// string: what searches or repeats is ours and pays by the character; the rest of the library is kept.
#include "engine/script/state.h"

#include "engine/script/pattern.h"

#include <algorithm>
#include <cstring>

namespace brittle::script {
namespace {

struct Text {
  const char* data;
  std::size_t size;
};

Text checkText(lua_State* lua, int index) {
  Text text{};
  text.data = luaL_checklstring(lua, index, &text.size);
  return text;
}

/// Where a search starts, counted from 0: `position` counts from 1, or from the end if negative.
std::size_t startOf(double position, std::size_t size) {
  if (position > 0.0)
    return position - 1.0 > static_cast<double>(size) ? size + 1 : static_cast<std::size_t>(position - 1.0);
  if (position == 0.0 || !(position >= -static_cast<double>(size))) return 0;
  return size - static_cast<std::size_t>(-position);
}

void checkError(lua_State* lua, const Pattern& pattern) {
  if (pattern.error() != nullptr) raise(lua, "%s", pattern.error());
}

/// Pushes capture `index`; the whole match if the pattern has none.
void pushCapture(lua_State* lua, const Pattern& pattern, int index, const char* start, const char* end) {
  if (index >= pattern.captures()) {
    if (index > 0) raise(lua, "invalid capture index");
    lua_pushlstring(lua, start, static_cast<std::size_t>(end - start));
    return;
  }
  const Pattern::Capture& capture = pattern.capture(index);
  if (capture.size == Pattern::kUnfinished) raise(lua, "unfinished capture");
  if (capture.size == Pattern::kPosition) {
    lua_pushinteger(lua, capture.start - pattern.subject() + 1);
  } else {
    lua_pushlstring(lua, capture.start, static_cast<std::size_t>(capture.size));
  }
}

int pushCaptures(lua_State* lua, const Pattern& pattern, const char* start, const char* end, bool wholeIfNone) {
  const int count = pattern.captures() == 0 && wholeIfNone ? 1 : pattern.captures();
  luaL_checkstack(lua, count, "too many captures");
  for (int i = 0; i < count; ++i) pushCapture(lua, pattern, i, start, end);
  return count;
}

const char* findPlain(lua_State* lua, Text subject, std::size_t start, Text wanted) {
  for (std::size_t at = start; at + wanted.size <= subject.size; ++at) {
    charge(lua, 1 + static_cast<std::int64_t>(wanted.size / 16));
    if (std::memcmp(subject.data + at, wanted.data, wanted.size) == 0) return subject.data + at;
  }
  return nullptr;
}

int pushRange(lua_State* lua, Text subject, const char* start, const char* end) {
  lua_pushinteger(lua, start - subject.data + 1);
  lua_pushinteger(lua, end - subject.data);
  return 2;
}

template <bool IsFind>
int search(lua_State* lua) {
  const Text subject = checkText(lua, 1);
  Text wanted = checkText(lua, 2);
  const std::size_t start = startOf(luaL_optnumber(lua, 3, 1.0), subject.size);
  if (start > subject.size) {
    lua_pushnil(lua);
    return 1;
  }
  if (IsFind && lua_toboolean(lua, 4) != 0) {
    const char* found = findPlain(lua, subject, start, wanted);
    if (found != nullptr) return pushRange(lua, subject, found, found + wanted.size);
    lua_pushnil(lua);
    return 1;
  }
  const bool anchored = wanted.size > 0 && wanted.data[0] == '^';
  if (anchored) wanted = {wanted.data + 1, wanted.size - 1};
  Pattern pattern(subject.data, subject.size, wanted.data, wanted.size, SandboxState::of(lua).left);
  for (const char* from = subject.data + start; from <= pattern.subjectEnd(); ++from) {
    charge(lua, 1);
    const char* end = pattern.matchAt(from);
    checkError(lua, pattern);
    if (end != nullptr) {
      const int range = IsFind ? pushRange(lua, subject, from, end) : 0;
      return range + pushCaptures(lua, pattern, from, end, !IsFind);
    }
    if (anchored) break;
  }
  lua_pushnil(lua);
  return 1;
}

/// Upvalues: subject, pattern, where to go on from.
int nextMatch(lua_State* lua) {
  Text subject{}, wanted{};
  subject.data = lua_tolstring(lua, lua_upvalueindex(1), &subject.size);
  wanted.data = lua_tolstring(lua, lua_upvalueindex(2), &wanted.size);
  Pattern pattern(subject.data, subject.size, wanted.data, wanted.size, SandboxState::of(lua).left);
  const char* from = subject.data + lua_tointeger(lua, lua_upvalueindex(3));
  for (; from <= pattern.subjectEnd(); ++from) {
    charge(lua, 1);
    const char* end = pattern.matchAt(from);
    checkError(lua, pattern);
    if (end == nullptr) continue;
    lua_pushinteger(lua, end - subject.data + (end == from ? 1 : 0));
    lua_replace(lua, lua_upvalueindex(3));
    return pushCaptures(lua, pattern, from, end, true);
  }
  return 0;
}

int everyMatch(lua_State* lua) {
  checkText(lua, 1);
  checkText(lua, 2);
  lua_settop(lua, 2);
  lua_pushinteger(lua, 0);
  lua_pushcclosure(lua, nextMatch, 3);
  return 1;
}

/// Adds what a replacement string says, with %0 to %9 filled in.
void addReplacement(lua_State* lua, luaL_Buffer& out, const Pattern& pattern, const char* start, const char* end) {
  const Text text = checkText(lua, 3);
  for (std::size_t i = 0; i < text.size; ++i) {
    if (text.data[i] != '%') {
      luaL_addchar(&out, text.data[i]);
    } else if (++i < text.size && text.data[i] == '%') {
      luaL_addchar(&out, '%');
    } else if (i < text.size && text.data[i] == '0') {
      luaL_addlstring(&out, start, static_cast<std::size_t>(end - start));
    } else if (i < text.size && text.data[i] >= '1' && text.data[i] <= '9') {
      pushCapture(lua, pattern, text.data[i] - '1', start, end);
      luaL_addvalue(&out);
    } else {
      raise(lua, "invalid use of '%%' in replacement string");
    }
  }
}

void addReplaced(lua_State* lua, luaL_Buffer& out, const Pattern& pattern, const char* start, const char* end) {
  const int kind = lua_type(lua, 3);
  if (kind == LUA_TSTRING || kind == LUA_TNUMBER) return addReplacement(lua, out, pattern, start, end);
  if (kind == LUA_TFUNCTION) {
    lua_pushvalue(lua, 3);
    lua_call(lua, pushCaptures(lua, pattern, start, end, true), 1);
  } else {
    pushCapture(lua, pattern, 0, start, end);
    lua_rawget(lua, 3);
  }
  if (lua_toboolean(lua, -1) == 0) {
    lua_pop(lua, 1);
    lua_pushlstring(lua, start, static_cast<std::size_t>(end - start));
  } else if (lua_isstring(lua, -1) == 0) {
    raise(lua, "invalid replacement value (a %s)", luaL_typename(lua, -1));
  }
  luaL_addvalue(&out);
}

int substitute(lua_State* lua) {
  const Text subject = checkText(lua, 1);
  Text wanted = checkText(lua, 2);
  const int kind = lua_type(lua, 3);
  luaL_argcheck(lua, kind == LUA_TSTRING || kind == LUA_TNUMBER || kind == LUA_TFUNCTION || kind == LUA_TTABLE, 3,
                "string, function or table expected");
  const double most = luaL_optnumber(lua, 4, 1e15);
  const bool anchored = wanted.size > 0 && wanted.data[0] == '^';
  if (anchored) wanted = {wanted.data + 1, wanted.size - 1};
  Pattern pattern(subject.data, subject.size, wanted.data, wanted.size, SandboxState::of(lua).left);
  luaL_Buffer out;
  luaL_buffinit(lua, &out);
  const char* from = subject.data;
  int count = 0;
  while (count < most) {
    charge(lua, 1);
    const char* end = pattern.matchAt(from);
    checkError(lua, pattern);
    if (end != nullptr) {
      ++count;
      addReplaced(lua, out, pattern, from, end);
    }
    if (end != nullptr && end > from) {
      from = end;
    } else if (from < pattern.subjectEnd()) {
      luaL_addchar(&out, *from++);
    } else {
      break;
    }
    if (anchored) break;
  }
  luaL_addlstring(&out, from, static_cast<std::size_t>(pattern.subjectEnd() - from));
  luaL_pushresult(&out);
  lua_pushinteger(lua, count);
  return 2;
}

int repeat(lua_State* lua) {
  const Text text = checkText(lua, 1);
  const double times = luaL_checknumber(lua, 2);
  std::size_t separatorSize = 0;
  const char* separator = luaL_optlstring(lua, 3, "", &separatorSize);
  const double total = times * static_cast<double>(text.size + separatorSize);
  const double most = static_cast<double>(SandboxState::of(lua).limits.longestString);
  if (!(total <= most)) return raise(lua, "string.rep: the result is longer than %f bytes", most);
  luaL_Buffer out;
  luaL_buffinitsize(lua, &out, total > 0.0 ? static_cast<std::size_t>(total) : 0);
  if (total > 0.0) {
    charge(lua, static_cast<std::int64_t>(times / 4.0 + total / 16.0));
    for (int i = 0; i < static_cast<int>(times); ++i) {
      if (i > 0) luaL_addlstring(&out, separator, separatorSize);
      luaL_addlstring(&out, text.data, text.size);
    }
  }
  luaL_pushresult(&out);
  return 1;
}

/// string.format of the library, which prints addresses for %s of a table: such arguments are made texts first.
int format(lua_State* lua) {
  luaL_checkstring(lua, 1);
  const int count = lua_gettop(lua);
  charge(lua, 50 + count);  // printf takes its time
  for (int i = 2; i <= count; ++i) {
    const int kind = lua_type(lua, i);
    if (kind == LUA_TSTRING || (kind == LUA_TNUMBER && lua_tonumber(lua, i) == lua_tonumber(lua, i))) continue;
    if (kind == LUA_TNUMBER) {
      lua_pushnumber(lua, __builtin_fabs(lua_tonumber(lua, i)));  // one sign for every NaN
    } else {
      pushText(lua, i);
    }
    lua_replace(lua, i);
  }
  lua_pushvalue(lua, lua_upvalueindex(1));
  lua_insert(lua, 1);
  lua_call(lua, count, 1);
  return 1;
}

}  // namespace

void addStrings(lua_State* lua) {
  const luaL_Reg functions[] = {{"find", search<true>}, {"match", search<false>}, {"gmatch", everyMatch},
                                {"gsub", substitute},   {"rep", repeat},          {nullptr, nullptr}};
  lua_newtable(lua);
  lua_pushliteral(lua, "");
  lua_getmetatable(lua, -1);  // made by the library: its __index is the library's table
  lua_getfield(lua, -1, "__index");
  for (const char* name : {"byte", "char", "len", "lower", "reverse", "sub", "upper"}) {
    lua_getfield(lua, -1, name);
    lua_setfield(lua, -5, name);
  }
  lua_getfield(lua, -1, "format");
  lua_pushcclosure(lua, format, 1);
  lua_setfield(lua, -5, "format");
  lua_pop(lua, 1);
  lua_pushvalue(lua, -3);
  lua_setfield(lua, -2, "__index");
  lua_pushcfunction(lua, applyOperator);
  lua_setfield(lua, -2, "__call");
  lua_pop(lua, 2);
  luaL_setfuncs(lua, functions, 0);
  lua_setfield(lua, -2, "string");
}

}  // namespace brittle::script
