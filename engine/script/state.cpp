#include "engine/script/state.h"

#include "engine/core/assert.h"
#include "engine/script/numbering.h"

#include <algorithm>
#include <cstdarg>
#include <cstdlib>
#include <cstring>

namespace brittle::script {
namespace {

constexpr int kHookEvery = 100;           // instructions between two looks at the budget: 0.4 ns each, measured
constexpr std::size_t kChurnFactor = 32;  // a run may ask for this many times the memory limit in all

// What Lua keeps with a string: list, kind, hash, length; and a byte for its end.
constexpr std::size_t kStringHeader = sizeof(void*) == 8 ? 25 : 17;
constexpr std::size_t kLongestMessage = 300;  // an error is one line

void countInstructions(lua_State* lua, lua_Debug*) {
  charge(lua, kHookEvery * std::int64_t{SandboxState::of(lua).price});
}

int panic(lua_State* lua) {
  const char* message = lua_tostring(lua, -1);
  assertFailed(message != nullptr ? message : "Lua error outside of a protected call", __FILE__, __LINE__);
  return 0;
}

/// Runs where an error was raised: gives it a place if it has none, as errors from within C functions do.
int addPlace(lua_State* lua) {
  if (lua_type(lua, 1) == LUA_TSTRING && *lua_tostring(lua, 1) == '~') return 1;
  const std::pair<int, int> place = SandboxState::of(lua).place();
  if (place.second == 0) return 1;
  lua_pushfstring(lua, "~%d:%d: ", place.first, place.second);
  if (lua_type(lua, 1) == LUA_TSTRING) {
    lua_pushvalue(lua, 1);
  } else {
    lua_pushfstring(lua, "the error is a %s", luaL_typename(lua, 1));
  }
  lua_concat(lua, 2);
  return 1;
}

/// Scripts may raise texts of any length with any bytes.
std::string shortened(const std::string& message) {
  return asOneLine(message.substr(0, kLongestMessage));
}

/// Leaves what a library's opener returns on the stack, without a trace in the registry.
void open(lua_State* lua, lua_CFunction opener) {
  lua_pushcfunction(lua, opener);
  lua_call(lua, 0, 1);
}

void keep(lua_State* lua, int from, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    lua_getfield(lua, from, name);
    lua_setfield(lua, -2, name);
  }
}

}  // namespace

SandboxState& SandboxState::of(lua_State* lua) {
  void* self = nullptr;
  lua_getallocf(lua, &self);
  return *static_cast<SandboxState*>(self);
}

SandboxState::SandboxState(const Library& library, std::uint64_t seed, Limits limits_, void* user_)
    : limits(limits_), random(seed), user(user_) {
  BR_ASSERT(limits.memoryBytes >= (128u << 10));
  lua = lua_newstate(allocate, this);
  BR_ASSERT(lua != nullptr);
  lua_atpanic(lua, panic);
  const int status = protect([&library](lua_State* inner) {
    open(inner, luaopen_base);
    open(inner, luaopen_bit32);
    open(inner, luaopen_string);  // for the metatable of strings
    lua_pop(inner, 1);
    lua_newtable(inner);
    keep(inner, 1,
         {"_VERSION", "assert", "error", "ipairs", "rawequal", "rawget", "rawset", "select", "tonumber", "type"});
    addBase(inner);
    lua_pushvalue(inner, -1);
    lua_setfield(inner, -2, "_G");
    lua_pushvalue(inner, 2);
    lua_setfield(inner, -2, "bit32");
    addMath(inner);
    addStrings(inner);
    addTables(inner);
    for (const Library::Entry& entry : library.entries()) {
      lua_pushlightuserdata(inner, const_cast<Library::Entry*>(&entry));
      lua_pushcclosure(inner, callNative, 1);
      lua_setfield(inner, -2, entry.name.c_str());
    }
    lua_rawseti(inner, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    rememberBuiltins(inner);
  });
  BR_ASSERT(status == LUA_OK);
}

SandboxState::~SandboxState() {
  lua_close(lua);
}

void* SandboxState::allocate(void* self, void* block, std::size_t before, std::size_t wanted) {
  auto& state = *static_cast<SandboxState*>(self);
  const bool isString = block == nullptr && before == LUA_TSTRING;  // for a new block Lua passes the kind of object
  if (block == nullptr) before = 0;
  if (wanted == 0) {
    state.used -= before;
    std::free(block);
    return nullptr;
  }
  if (wanted > before &&
      !state.admits(before, wanted, isString ? state.limits.longestString : state.limits.largestBlockBytes))
    return nullptr;
  if (isString && wanted > kStringHeader)
    state.price = std::max(state.price, 1 + static_cast<std::uint32_t>((wanted - kStringHeader) / kPricedLength));
  void* moved = std::realloc(block, wanted);
  if (moved != nullptr) state.used += wanted - before;
  return moved;
}

bool SandboxState::admits(std::size_t before, std::size_t wanted, std::size_t largest) {
  churn_ += wanted - before;
  const bool fits = unlimited || (wanted <= largest * slack && used + (wanted - before) <= limits.memoryBytes * slack &&
                                  (!running || churn_ <= limits.memoryBytes * kChurnFactor));
  if (!fits) {
    // Lua now collects all its garbage and asks again. A script that lives at the limit would do so for ever.
    churn_ += limits.memoryBytes / 2;
    refusedAt_ = place();
  }
  return fits;
}

void SandboxState::beginRun(std::int64_t instructions) {
  BR_ASSERT(!running);
  granted = instructions > 0 ? instructions : limits.instructions;
  left = granted;
  churn_ = 0;
  refusedAt_ = {0, 0};
  lua_sethook(lua, countInstructions, LUA_MASKCOUNT, kHookEvery);  // from zero: a run does not depend on the one before
}

bool SandboxState::spend(std::int64_t amount) {
  left -= amount < 0 ? 0 : std::min(amount, granted + 1);
  return left >= 0;
}

int SandboxState::callProtected(int arguments, int results) {
  const int base = lua_gettop(lua) - arguments;
  lua_pushcfunction(lua, addPlace);
  lua_insert(lua, base);
  const int status = lua_pcall(lua, arguments, results, base);
  lua_remove(lua, base);
  return status;
}

std::pair<int, int> SandboxState::place() const {
  lua_Debug record;
  for (int level = 0; lua != nullptr && lua_getstack(lua, level, &record) != 0; ++level) {
    lua_getinfo(lua, "Sl", &record);
    if (record.currentline <= 0 || record.source[0] != '@' || record.source[1] != '~') continue;
    const int file = std::atoi(record.source + 2);
    if (!files[static_cast<std::size_t>(file)].empty()) return {file, record.currentline};
  }
  return {0, 0};
}

std::string SandboxState::withFiles(const std::string& message) const {
  if (message.empty() || message[0] != '~') return message;
  const std::size_t end = message.find(':');
  if (end == std::string::npos) return message;
  const auto index = static_cast<std::size_t>(std::atoi(message.c_str() + 1));
  return index < files.size() ? files[index] + message.substr(end) : message;
}

Error SandboxState::takeError(int status) {
  std::string message;
  if (status == LUA_ERRMEM) {
    // Outside of any line it was the compiler that asked.
    const std::size_t place = refusedAt_.second > 0 ? static_cast<std::size_t>(refusedAt_.first) : files.size() - 1;
    message =
        errorAt(files.empty() ? "script" : files[place], refusedAt_.second,
                "the memory budget is used up: recursion without end, or data without end (" +
                    std::to_string(limits.memoryBytes) + " bytes in all, " + std::to_string(limits.largestBlockBytes) +
                    " in one table, " + std::to_string(limits.longestString) + " in one string)")
            .message;
  } else if (lua_type(lua, -1) == LUA_TSTRING) {
    std::size_t size = 0;
    const char* text = lua_tolstring(lua, -1, &size);
    message = withFiles(std::string(text, size));
    if (text[0] != '~' && !files.empty()) message = files.back() + ": " + message;
  } else {
    message = (files.empty() ? std::string() : files.back() + ": ") + "the error is a " + luaL_typename(lua, -1);
  }
  lua_pop(lua, 1);
  const std::string wrong = "attempt to call global '";
  const std::string tail = "' (a nil value)";
  const std::size_t at = message.find(wrong);
  const std::size_t end = message.find(tail);
  if (at != std::string::npos && end != std::string::npos && end > at)
    message = message.substr(0, at) + "unknown function " + message.substr(at + wrong.size(), end - at - wrong.size());
  return {shortened(message)};
}

bool SandboxState::runNative(const Library::Entry& entry) {
  Call call(lua, entry.name);
  entry.native(call);
  results_ = std::move(call.results_);
  message_ = std::move(call.message_);
  return !call.failed_;
}

int SandboxState::callNative(lua_State* lua) {
  const auto& entry = *static_cast<const Library::Entry*>(lua_touserdata(lua, lua_upvalueindex(1)));
  SandboxState& state = of(lua);
  const bool succeeded = state.runNative(entry);
  charge(lua, 10);
  if (!succeeded) return raise(lua, "%s: %s", entry.name.c_str(), state.message_.c_str());
  luaL_checkstack(lua, static_cast<int>(state.results_.size()), "too many results");
  for (const Value& value : state.results_) pushValue(lua, value);
  return static_cast<int>(state.results_.size());
}

int raise(lua_State* lua, const char* format, ...) {
  const std::pair<int, int> place = SandboxState::of(lua).place();
  if (place.second > 0) {
    lua_pushfstring(lua, "~%d:%d: ", place.first, place.second);
  } else {
    lua_pushliteral(lua, "");
  }
  std::va_list arguments;
  va_start(arguments, format);
  lua_pushvfstring(lua, format, arguments);
  va_end(arguments);
  lua_concat(lua, 2);
  return lua_error(lua);
}

void charge(lua_State* lua, std::int64_t amount) {
  SandboxState& state = SandboxState::of(lua);
  if (!state.spend(amount))
    raise(lua, "the budget of %f instructions is used up", static_cast<lua_Number>(state.granted));
}

void pushValue(lua_State* lua, const Value& value) {
  switch (value.kind) {
    case Value::Kind::Nil:
      lua_pushnil(lua);
      break;
    case Value::Kind::Boolean:
      lua_pushboolean(lua, value.number != 0.0 ? 1 : 0);
      break;
    case Value::Kind::Number:
      lua_pushnumber(lua, value.number);
      break;
    case Value::Kind::Text:
      lua_pushlstring(lua, value.text.data(), value.text.size());
      break;
  }
}

Value toValue(lua_State* lua, int index) {
  switch (lua_type(lua, index)) {
    case LUA_TNUMBER:
      return lua_tonumber(lua, index);
    case LUA_TBOOLEAN:
      return lua_toboolean(lua, index) != 0;
    case LUA_TSTRING: {
      std::size_t size = 0;
      const char* text = lua_tolstring(lua, index, &size);
      return std::string(text, size);
    }
    default:
      return {};
  }
}

}  // namespace brittle::script
