// audio/block.h - the mixer works in blocks of a fixed size, so what it gives does not depend on how much a device asks
// for at a time.
#pragma once

#include <cmath>

#include "engine/math/types.h"

namespace brittle::audio {

inline constexpr int kBlockFrames = 32;  // 0.67 ms, and 25 of them make a tick of 1/60 s

struct Block {
  float left[kBlockFrames] = {}, right[kBlockFrames] = {};

  float peak() const {
    float most = 0.0f;
    for (int i = 0; i < kBlockFrames; ++i) most = maxOf(most, maxOf(std::fabs(left[i]), std::fabs(right[i])));
    return most;
  }
};

}  // namespace brittle::audio
