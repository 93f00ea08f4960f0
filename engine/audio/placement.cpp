#include "engine/audio/placement.h"

#include "engine/math/trig.h"

namespace brittle::audio {
namespace {

constexpr float kHalfGain =
    6.0f;  // here a sound is half as loud as at the ear [m]; by ear: true 1 / r empties the far end of the track
constexpr float kWidth = 0.8f;        // of full left and right: with headphones nothing is in one ear alone
constexpr float kNearest = 1.0f;      // closer things do not jump from side to side [m]
constexpr float kHalfCutoff = 22.0f;  // here the highest frequencies have come down by an octave [m]

}  // namespace

Placement placementOf(const Vec3& point) {
  const float distance = point.norm();
  const float side = kWidth * point.x() / maxOf(distance, kNearest);
  const float gain = 1.0f / (1.0f + distance / kHalfGain);
  const float angle = 0.25f * kPi * (1.0f + side);
  Placement placement;
  placement.left = gain * cosine(angle);
  placement.right = gain * sine(angle);
  placement.send = std::sqrt(1.0f + distance / kHalfGain);
  placement.cutoff = kHighestCutoff / (1.0f + distance / kHalfCutoff);
  return placement;
}

}  // namespace brittle::audio
