// core/random.h - small random streams whose draws are the same on every machine. One stream per purpose, one draw per
// statement (the order in which a compiler evaluates arguments is not defined). Source: O'Neill, PCG: A Family of
// Simple Fast Space-Efficient Statistically Good Algorithms for Random Number Generation, 2014.
#pragma once

#include <cstdint>

namespace brittle {

class Random {
 public:
  Random() : Random(0) {}
  /// `stream` picks one of 2^63 independent sequences of the same seed.
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : increment_((stream << 1) | 1) {
    next();
    state_ += seed;
    next();
  }

  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ull + increment_;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    const auto rotation = static_cast<std::uint32_t>(old >> 59);
    return (shifted >> rotation) | (shifted << ((32 - rotation) & 31));
  }
  /// In [0, 1), a multiple of 2^-24.
  float nextFloat() { return static_cast<float>(next() >> 8) * 0x1p-24f; }
  /// In [low, high).
  float nextFloat(float low, float high) { return low + (high - low) * nextFloat(); }
  /// In [0, count); count > 0. Slightly biased for huge counts, always one draw.
  std::uint32_t nextBelow(std::uint32_t count) {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(next()) * count) >> 32);
  }

  std::uint64_t state() const { return state_; }
  std::uint64_t increment() const { return increment_; }
  void restore(std::uint64_t state, std::uint64_t increment) {
    state_ = state;
    increment_ = increment;
  }

 private:
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

/// Mixes two numbers into a seed for a stream of its own. Source: Vigna, splitmix64, 2015.
inline std::uint64_t mixSeed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t z = a + 0x9e3779b97f4a7c15ull * (b + 1);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

}  // namespace brittle
