// script/state.h - what a sandbox holds behind its interface: the Lua state, its budgets, and the rules for errors that
// jump. Internal to engine/script. Lua is C: an error is a longjmp, so no object with a destructor may live in a frame
// that calls a Lua function that can fail; what needs one is a member here instead.
#pragma once

#include "engine/core/result.h"
#include "engine/script/sandbox.h"

#include <cstdint>
#include <lua.hpp>
#include <string>
#include <utility>
#include <vector>

namespace brittle::script {

/// Comparing a string or reading it as a number takes one instruction of the virtual machine, but time by its length.
/// Up to 20 ns a byte, measured: strings with zeroes compared bit by bit. Priced so, a run of a million instructions
/// stays below two seconds.
inline constexpr std::size_t kPricedLength = 256;  // [bytes]

/// A key of a table, in the order in which pairs and snapshots visit: numbers, then strings bytewise, then false and
/// true.
struct Key {
  int type;  // LUA_TNUMBER, LUA_TSTRING or LUA_TBOOLEAN
  double number;
  std::string_view text;  // lives as long as the table holds the key
};
bool operator<(const Key& a, const Key& b);

class SandboxState {
 public:
  SandboxState(const Library& library, std::uint64_t seed, Limits limits, void* user);
  ~SandboxState();
  SandboxState(const SandboxState&) = delete;
  SandboxState& operator=(const SandboxState&) = delete;

  static SandboxState& of(lua_State* lua);

  /// Calls the function under `arguments` values on the stack; an error message gets its place if it has none.
  int callProtected(int arguments, int results);
  /// Runs `body(lua)` so that Lua errors end here; the values it leaves are kept, as many as `results`. Gives Lua's
  /// status.
  template <class Body>
  int protect(const Body& body, int results = 0) {
    lua_pushcfunction(lua, [](lua_State* inner) {
      const Body& inside = *static_cast<const Body*>(lua_touserdata(inner, 1));
      lua_settop(inner, 0);
      inside(inner);
      return lua_gettop(inner);
    });
    lua_pushlightuserdata(lua, const_cast<void*>(static_cast<const void*>(&body)));
    return callProtected(1, results);
  }

  /// A fresh budget. `instructions` of 0: the limits' own.
  void beginRun(std::int64_t instructions);
  /// Takes the error that Lua left on its stack and makes it "file:line: what".
  Error takeError(int status);
  /// Replaces the short chunk names in a message by the files they stand for.
  std::string withFiles(const std::string& message) const;
  /// The file and line that run now; line 0 outside of a script.
  std::pair<int, int> place() const;

  /// Takes `amount` from the instruction budget; false if that uses it up.
  bool spend(std::int64_t amount);

  static int callNative(lua_State* lua);

  lua_State* lua = nullptr;
  Limits limits;
  Random random;
  void* user;
  std::vector<std::string> files;  // chunk "~3" is files[3]
  std::int64_t granted = 0;        // instructions
  std::int64_t left = 0;
  std::size_t used = 0;  // bytes held now
  /// What an instruction costs: 1, and 1 more for every kPricedLength of the longest string that was ever made here.
  std::uint32_t price = 1;
  int builtins = 0;  // how many functions and tables had numbers before the first script
  bool running = false;
  bool unlimited = false;      // while our own code, not the script, asks for memory
  std::size_t slack = 1;       // times the limits: while a saved state, which grew otherwise, is put together again
  std::vector<Key> keys;       // scratch of the sorted walks
  std::vector<Key> outerKeys;  // of a walk around another

 private:
  static void* allocate(void* self, void* block, std::size_t before, std::size_t wanted);
  bool admits(std::size_t before, std::size_t wanted, std::size_t largest);
  bool runNative(const Library::Entry& entry);

  std::size_t churn_ = 0;                // bytes asked for since beginRun
  std::pair<int, int> refusedAt_{0, 0};  // where memory ran out
  std::string message_;                  // of the native that failed
  std::vector<Value> results_;           // of the native that ran last
};

/// Raises "file:line: what" with printf-like arguments (%s %d %f). Never returns.
int raise(lua_State* lua, const char* format, ...);
/// Takes from the instruction budget; raises when it is used up.
void charge(lua_State* lua, std::int64_t amount);
void pushValue(lua_State* lua, const Value& value);
/// Tables and functions give nil.
Value toValue(lua_State* lua, int index);

/// The key at `index` of the stack; false for kinds that have no order.
bool readKey(lua_State* lua, int index, Key& key);
/// Fills `state.keys` with the keys of the table at `index`, in order. Gives false if one of them has no order.
bool sortKeys(lua_State* lua, int index);
void pushKey(lua_State* lua, const Key& key);
/// Pushes the value as tostring shows it: tables and functions by their kind alone, never an address.
void pushText(lua_State* lua, int index);
/// The length of a table as a function of its contents alone: Lua's own depends on how the table was filled.
int lengthOf(lua_State* lua, int index);

// The parts of the standard library that are ours, put into the table on top of the stack.
void addMath(lua_State* lua);
void addStrings(lua_State* lua);
void addTables(lua_State* lua);
void addBase(lua_State* lua);

/// What "^", "%" and "#" became: see rewrite.h.
int applyOperator(lua_State* lua);

}  // namespace brittle::script
