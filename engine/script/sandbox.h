// script/sandbox.h - one Lua 5.2 world: its globals, its budget, its random stream. The same script gives the same
// results on every machine: pairs and next go in key order, math and ^ are our own, nothing shows an address, a clock
// or the memory in use. A script can neither hang (instructions are counted, string searches too) nor exhaust memory,
// and reaches no file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/byte_stream.h"
#include "engine/core/random.h"
#include "engine/core/result.h"
#include "engine/script/library.h"
#include "engine/script/value.h"

namespace brittle::script {

struct Limits {
  std::int64_t instructions = 1'000'000;  // per load or call, unless the call says otherwise
  std::size_t memoryBytes = 8u << 20;     // all that the script holds [bytes]; at least 128 KiB
  std::size_t largestBlockBytes =
      512u << 10;  // 32,768 list entries, 8,192 fields of one table, or as many values on the stack
  std::size_t longestString = 64u << 10;  // [bytes]: comparing strings is the one long work that no budget sees
};

class SandboxState;

class Sandbox {
 public:
  /// `library` must outlive the sandbox; `user` is what Call::user() gives to its functions.
  explicit Sandbox(const Library& library, std::uint64_t seed = 0, Limits limits = {}, void* user = nullptr);
  ~Sandbox();
  Sandbox(Sandbox&&) noexcept;
  Sandbox& operator=(Sandbox&&) noexcept;

  /// Compiles `source` and runs it: its functions and variables become globals. Further loads add to the same globals.
  /// An error reads "file:line: what"; what the script had done before it stays, and the sandbox can still be called. A
  /// source without a file name is never named: an error in it is one of the line that called it.
  Status load(std::string_view source, const std::string& file);

  /// Whether a script has defined a function of this name (a function of the library does not count).
  bool has(const std::string& function) const;
  /// Calls a global function and gives its first result (nil if none). `instructions`: the budget, 0 for the limits'
  /// own.
  Result<Value> call(const std::string& function, std::span<const Value> arguments = {}, std::int64_t instructions = 0);

  /// Sets or reads a global variable; tables and functions read as nil.
  void set(const std::string& global, const Value& value);
  Value get(const std::string& global) const;

  /// Writes all that scripts have changed since they were loaded: globals, the variables their functions share, nested
  /// tables with shared references and cycles, and the random stream. Fails, writing nothing, if some value cannot be
  /// written: a function made while running. Changes made to math, string and table while running are not seen.
  Status save(ByteWriter& out) const;
  /// Puts a saved state into a sandbox into which the same sources were loaded. On failure the sandbox is of no more
  /// use.
  Status restore(ByteReader& in);

  Random& random();
  std::size_t memoryUsed() const;         // [bytes]
  std::int64_t instructionsUsed() const;  // by the last load or call

 private:
  std::unique_ptr<SandboxState> state_;
};

/// The first syntax error of `source` as "file:line: what", without running it.
Status checkSyntax(std::string_view source, const std::string& file);

}  // namespace brittle::script
