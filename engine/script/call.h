// script/call.h - the arguments and results of one call from a script into C++. A wrong argument does not throw or
// jump: the first one is remembered, the reader gets a harmless value, and the script gets the error once the native
// has returned. So a native reads all its arguments, leaves if `failed()`, and only then acts.
#pragma once

#include "engine/core/random.h"
#include "engine/script/value.h"

#include <cstdint>
#include <string>
#include <vector>

struct lua_State;

namespace brittle::script {

class Call {
 public:
  /// How many arguments were passed; trailing nils count.
  int count() const;
  /// Whether argument `index` (from 1) was passed and is not nil.
  bool has(int index) const;
  /// A number, or a string that reads as one.
  bool isNumber(int index) const;

  /// A finite number of at most 1e15 in size; strings that read as numbers count. Wrong or missing: the call fails,
  /// gives 0.
  double number(int index);
  double number(int index, double otherwise);
  float real(int index) { return static_cast<float>(number(index)); }
  float real(int index, float otherwise) { return static_cast<float>(number(index, otherwise)); }
  /// A number rounded towards zero, at most 2^31 - 1 in size.
  int integer(int index);
  int integer(int index, int otherwise);
  /// A boolean; a number counts as true unless it is 0 (the community writes both).
  bool boolean(int index);
  bool boolean(int index, bool otherwise);
  /// A string of at most 1000 bytes, or a number as Lua prints it.
  std::string string(int index);
  std::string string(int index, const std::string& otherwise);

  /// Makes the call raise "file:line: NAME: what" when the native returns. The first failure counts.
  void fail(const std::string& what);
  bool failed() const { return failed_; }

  /// Adds a result; they are handed to the script in this order unless the call failed.
  void result(Value value);

  /// Takes from the instruction budget: for natives whose work grows with their arguments.
  void charge(std::int64_t instructions);

  /// The global function that was called.
  const std::string& name() const { return name_; }
  /// The script line that made this call: for messages and for "who asked".
  const std::string& file() const;
  int line() const;
  /// "file:line".
  std::string where() const { return file() + ":" + std::to_string(line()); }

  /// The sandbox's own random stream (math.random draws from it too).
  Random& random();
  /// What the owner of the sandbox gave to it.
  template <class T>
  T& user() {
    return *static_cast<T*>(userPointer());
  }

 private:
  friend class SandboxState;
  Call(lua_State* lua, const std::string& name) : lua_(lua), name_(name) {}
  void* userPointer();
  void refuse(int index, const char* expected);
  double rounded(int index, double value);

  lua_State* lua_;
  const std::string& name_;
  bool failed_ = false;
  std::string message_;
  std::vector<Value> results_;
};

}  // namespace brittle::script
