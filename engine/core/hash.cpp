#include "engine/core/hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace brittle {

std::uint64_t hashBytes(const void* data, std::size_t size, std::uint64_t seed) {
  return XXH64(data, size, seed);
}

std::uint32_t canonicalBits(float value) {
  if (value == 0.0f) return 0;
  if (value != value) return 0x7fc00000u;
  return __builtin_bit_cast(std::uint32_t, value);
}

std::uint64_t canonicalBits(double value) {
  if (value == 0.0) return 0;
  if (value != value) return 0x7ff8000000000000u;
  return __builtin_bit_cast(std::uint64_t, value);
}

std::uint64_t StateHash::value() const {
  return count_ == 0 ? state_ : hashBytes(buffer_, sizeof(std::uint32_t) * static_cast<std::size_t>(count_), state_);
}

void StateHash::flush() {
  state_ = value();
  count_ = 0;
}

}  // namespace brittle
