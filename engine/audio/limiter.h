// audio/limiter.h - keeps the mix below full scale whatever plays at once, by turning it down just before a peak and
// slowly up again. Bit-transparent below the ceiling, but for a delay of one block.
#pragma once

#include "engine/audio/block.h"

namespace brittle::audio {

inline constexpr float kCeiling = 0.97f;  // the largest magnitude that comes out

class Limiter {
 public:
  /// Takes a block and gives the one before. At each seam the gain is low enough for the blocks on both sides, and in
  /// between it is a straight line, so no sample is above the ceiling.
  void process(Block& block);
  /// What it turns the mix down by just now. [-]
  float gain() const { return gain_; }

 private:
  Block held_;
  float heldPeak_ = 0.0f, gain_ = 1.0f;
};

}  // namespace brittle::audio
