#include "engine/script/sandbox.h"

#include "engine/core/assert.h"
#include "engine/script/numbering.h"
#include "engine/script/rewrite.h"
#include "engine/script/state.h"

namespace brittle::script {
namespace {

constexpr std::size_t kLongestSource = 1u << 20;  // bytes

/// Leaves the compiled chunk, or Lua's error, on the stack.
int compile(SandboxState& state, std::string_view source, std::size_t file) {
  const std::string name = "@~" + std::to_string(file);
  return luaL_loadbufferx(state.lua, source.data(), source.size(), name.c_str(), "t");
}

/// Leaves the compiled chunk on the stack, or nothing and gives what is wrong.
Status compileRewritten(SandboxState& state, std::string_view source, const std::string& file) {
  if (source.size() > kLongestSource) return errorAt(file, 0, "a script may be 1 MiB long");
  if (source.substr(0, 3) == "\xef\xbb\xbf") source.remove_prefix(3);
  state.files.push_back(file);
  const std::size_t index = state.files.size() - 1;
  state.beginRun(0);
  const Rewritten rewritten = rewriteOperators(source);
  int status = rewritten.wrong.empty() ? compile(state, rewritten.source, index) : LUA_ERRSYNTAX;
  if (status == LUA_OK) return Done{};
  if (rewritten.wrong.empty()) lua_pop(state.lua, 1);
  status = compile(state, source, index);  // for a message about what the author wrote
  if (status != LUA_OK) return state.takeError(status);
  lua_pop(state.lua, 1);
  return errorAt(file, rewritten.wrongLine, rewritten.wrong.empty() ? "the script is too complex" : rewritten.wrong);
}

}  // namespace

Sandbox::Sandbox(const Library& library, std::uint64_t seed, Limits limits, void* user)
    : state_(std::make_unique<SandboxState>(library, seed, limits, user)) {}
Sandbox::~Sandbox() = default;
Sandbox::Sandbox(Sandbox&&) noexcept = default;
Sandbox& Sandbox::operator=(Sandbox&&) noexcept = default;

Status Sandbox::load(std::string_view source, const std::string& file) {
  SandboxState& state = *state_;
  const Status compiled = compileRewritten(state, source, file);
  if (!compiled) return compiled;
  state.beginRun(0);
  state.running = true;
  const int status = state.callProtected(0, 0);
  state.running = false;
  const Status result = status == LUA_OK ? Status(Done{}) : Status(state.takeError(status));
  if (state.protect([](lua_State* lua) { numberFunctions(lua); }) != LUA_OK) lua_pop(state.lua, 1);
  return result;
}

bool Sandbox::has(const std::string& function) const {
  bool found = false;
  const int status = state_->protect([&](lua_State* lua) {
    lua_pushglobaltable(lua);
    lua_getfield(lua, -1, function.c_str());
    found = lua_isfunction(lua, -1) && !isBuiltin(lua, function.c_str());
    lua_settop(lua, 0);
  });
  if (status != LUA_OK) lua_pop(state_->lua, 1);
  return found && status == LUA_OK;
}

Result<Value> Sandbox::call(const std::string& function, std::span<const Value> arguments, std::int64_t instructions) {
  SandboxState& state = *state_;
  state.beginRun(instructions);
  state.running = true;
  const int status = state.protect(
      [&](lua_State* lua) {
        lua_getglobal(lua, function.c_str());
        if (!lua_isfunction(lua, -1)) raise(lua, "there is no function %s", function.c_str());
        luaL_checkstack(lua, static_cast<int>(arguments.size()), "too many arguments");
        for (const Value& argument : arguments) pushValue(lua, argument);
        lua_call(lua, static_cast<int>(arguments.size()), 1);
      },
      1);
  state.running = false;
  if (status != LUA_OK) return state.takeError(status);
  const Value result = toValue(state.lua, -1);
  lua_pop(state.lua, 1);
  return result;
}

void Sandbox::set(const std::string& global, const Value& value) {
  const int status = state_->protect([&](lua_State* lua) {
    pushValue(lua, value);
    lua_setglobal(lua, global.c_str());
  });
  if (status != LUA_OK) lua_pop(state_->lua, 1);
}

Value Sandbox::get(const std::string& global) const {
  const int status = state_->protect([&](lua_State* lua) { lua_getglobal(lua, global.c_str()); }, 1);
  const Value value = status == LUA_OK ? toValue(state_->lua, -1) : Value();
  lua_pop(state_->lua, 1);
  return value;
}

Random& Sandbox::random() {
  return state_->random;
}
std::size_t Sandbox::memoryUsed() const {
  return state_->used;
}
std::int64_t Sandbox::instructionsUsed() const {
  return state_->granted - state_->left;
}

Status checkSyntax(std::string_view source, const std::string& file) {
  static const Library none;
  SandboxState state(none, 0, Limits{}, nullptr);
  return compileRewritten(state, source, file);
}

}  // namespace brittle::script
