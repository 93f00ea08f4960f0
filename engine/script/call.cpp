#include "engine/script/call.h"

#include "engine/script/state.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace brittle::script {
namespace {

constexpr double kLargest = 1e15;
constexpr std::size_t kLongest =
    1000;  // [bytes]: names and key=value; the game keeps them, out of reach of the script's memory budget

std::string describe(lua_State* lua, int index) {
  switch (lua_type(lua, index)) {
    case LUA_TNUMBER: {
      char text[40];
      std::snprintf(text, sizeof(text), "%.14g", lua_tonumber(lua, index));
      return text;
    }
    case LUA_TSTRING:
      return "\"" + std::string(lua_tostring(lua, index)).substr(0, 60) + "\"";
    case LUA_TBOOLEAN:
      return lua_toboolean(lua, index) != 0 ? "true" : "false";
    case LUA_TNONE:
      return "nothing";
    default:
      return luaL_typename(lua, index);
  }
}

}  // namespace

int Call::count() const {
  return lua_gettop(lua_);
}
bool Call::has(int index) const {
  return !lua_isnoneornil(lua_, index);
}
bool Call::isNumber(int index) const {
  return lua_isnumber(lua_, index) != 0;
}

void Call::fail(const std::string& what) {
  if (failed_) return;
  failed_ = true;
  message_ = what;
}

void Call::refuse(int index, const char* expected) {
  fail("argument " + std::to_string(index) + ": expected " + expected + ", got " + describe(lua_, index));
}

double Call::number(int index) {
  int isNumber = 0;
  const double value = lua_tonumberx(lua_, index, &isNumber);
  if (isNumber == 0) {
    refuse(index, "a number");
    return 0.0;
  }
  if (!(value <= kLargest && value >= -kLargest)) {
    refuse(index, "a finite number up to 1e15");
    return 0.0;
  }
  return value;
}

double Call::number(int index, double otherwise) {
  return has(index) ? number(index) : otherwise;
}

double Call::rounded(int index, double value) {
  if (value <= 2147483647.0 && value >= -2147483647.0) return std::trunc(value);
  refuse(index, "a whole number up to 2147483647");
  return 0.0;
}

int Call::integer(int index) {
  return static_cast<int>(rounded(index, number(index)));
}
int Call::integer(int index, int otherwise) {
  return has(index) ? integer(index) : otherwise;
}

bool Call::boolean(int index) {
  if (lua_isboolean(lua_, index)) return lua_toboolean(lua_, index) != 0;
  if (lua_type(lua_, index) == LUA_TNUMBER) return lua_tonumber(lua_, index) != 0.0;
  refuse(index, "true or false");
  return false;
}

bool Call::boolean(int index, bool otherwise) {
  return has(index) ? boolean(index) : otherwise;
}

std::string Call::string(int index) {
  if (lua_type(lua_, index) == LUA_TSTRING && lua_rawlen(lua_, index) <= kLongest) return toValue(lua_, index).text;
  if (lua_type(lua_, index) == LUA_TNUMBER) return describe(lua_, index);
  refuse(index, lua_type(lua_, index) == LUA_TSTRING ? "a string of at most 1000 bytes" : "a string");
  return {};
}

std::string Call::string(int index, const std::string& otherwise) {
  return has(index) ? string(index) : otherwise;
}

void Call::result(Value value) {
  results_.push_back(std::move(value));
}

void Call::charge(std::int64_t instructions) {
  SandboxState::of(lua_).spend(instructions);
}

const std::string& Call::file() const {
  static const std::string none = "script";
  const SandboxState& state = SandboxState::of(lua_);
  const auto index = static_cast<std::size_t>(state.place().first);
  return index < state.files.size() ? state.files[index] : none;
}

int Call::line() const {
  return SandboxState::of(lua_).place().second;
}
Random& Call::random() {
  return SandboxState::of(lua_).random;
}
void* Call::userPointer() {
  return SandboxState::of(lua_).user;
}

}  // namespace brittle::script
