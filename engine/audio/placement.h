// audio/placement.h - where a sound comes from: louder on its side, quieter, duller and more of the room with distance.
#pragma once

#include <cmath>

#include "engine/audio/filter.h"
#include "engine/math/types.h"

namespace brittle::audio {

struct Placement {
  float left = 0.70710678f, right = 0.70710678f;  // gains: their squares add up to the loudness
  float send = 1.0f;                              // what the room hears, over what comes straight
  float cutoff = kHighestCutoff;                  // of the air and all that stands between [Hz]

  float loudness() const { return std::sqrt(left * left + right * right); }
};

/// Of a sound at `point` in the listener's frame: X right, Y up, -Z ahead. [m]
Placement placementOf(const Vec3& point);

}  // namespace brittle::audio
