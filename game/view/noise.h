// view/noise.h - numbers that look random and belong to a key: what is seen again is made again.
#pragma once

#include <cstdint>

namespace brittle::view {

/// Numbers in [0, 1): another index, another number.
class Noise {
 public:
  explicit Noise(std::uint64_t key) : key_(key * 0x9e3779b97f4a7c15ull) {}
  float operator()(std::uint32_t index) const {
    std::uint64_t h = key_ + index * 0xbf58476d1ce4e5b9ull;
    h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9ull;
    h = (h ^ h >> 27) * 0x94d049bb133111ebull;
    return static_cast<float>((h ^ h >> 31) >> 40) * 0x1p-24f;
  }
  float operator()(std::uint32_t index, float low, float high) const { return low + (high - low) * (*this)(index); }

 private:
  std::uint64_t key_;
};

}  // namespace brittle::view
