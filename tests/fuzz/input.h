// fuzz/input.h - bytes of a fuzzer read as numbers. Past the end everything is zero, so that any length is an input.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

#include "engine/math/types.h"

namespace brittle::fuzz {

class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool isAtEnd() const { return at_ >= bytes_.size(); }
  std::uint32_t nextByte() { return isAtEnd() ? 0u : bytes_[at_++]; }
  std::uint32_t nextBelow(std::uint32_t count) { return nextByte() % count; }
  /// In [low, high], in 65,536 steps: neighbours differ by little, so that edges and corners are hit exactly.
  float nextFloat(float low, float high) {
    const std::uint32_t first = nextByte();
    return low + (high - low) * (static_cast<float>(first << 8 | nextByte()) / 65535.0f);
  }
  /// Any finite float below `most` in size, by its bits.
  float nextBits(float most) {
    std::uint8_t raw[4];
    for (std::uint8_t& byte : raw) byte = static_cast<std::uint8_t>(nextByte());
    float value;
    std::memcpy(&value, raw, sizeof value);
    return std::isfinite(value) && std::abs(value) <= most ? value : 0.0f;
  }
  Vec3 nextVector(float low, float high) {
    const float x = nextFloat(low, high);
    const float y = nextFloat(low, high);
    const float z = nextFloat(low, high);
    return Vec3(x, y, z);
  }
  Vec3 nextDirection() { return normalizedOr(nextVector(-1.0f, 1.0f), Vec3::UnitY()); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

}  // namespace brittle::fuzz
