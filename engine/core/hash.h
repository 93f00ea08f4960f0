// core/hash.h - 64-bit state hashes that are the same on every machine. Floats are hashed by their bits, with one NaN
// and one zero.
#pragma once

#include <cstddef>
#include <cstdint>

namespace brittle {

/// XXH64 of a block of bytes.
std::uint64_t hashBytes(const void* data, std::size_t size, std::uint64_t seed = 0);

/// The bits of a number with -0 as +0 and every NaN as one.
std::uint32_t canonicalBits(float value);
std::uint64_t canonicalBits(double value);

/// Accumulates values in the order they are added. Words are hashed little-endian.
class StateHash {
 public:
  void add(std::uint32_t value) { addWord(value); }
  void add(std::int32_t value) { addWord(static_cast<std::uint32_t>(value)); }
  void add(bool value) { addWord(value ? 1u : 0u); }
  void add(float value) { addWord(canonicalBits(value)); }
  void add(double value) { add(canonicalBits(value)); }
  void add(std::uint64_t value) {
    addWord(static_cast<std::uint32_t>(value));
    addWord(static_cast<std::uint32_t>(value >> 32));
  }
  void add(std::int64_t value) { add(static_cast<std::uint64_t>(value)); }
  void addBytes(const void* data, std::size_t size) { state_ = hashBytes(data, size, value()); }
  std::uint64_t value() const;

 private:
  void addWord(std::uint32_t word) {
    buffer_[count_++] = word;
    if (count_ == kBuffered) flush();
  }
  void flush();

  static constexpr int kBuffered = 64;
  std::uint32_t buffer_[kBuffered];
  int count_ = 0;
  std::uint64_t state_ = 0;
};

}  // namespace brittle
