#include "game/sim/pace.h"

#include "engine/math/types.h"
#include "game/sim/constants.h"

namespace brittle::sim {

static_assert(rules::kRoomTicks == 1920, "Pace counts in this many steps per room");

float allowedLength(float length) {
  const float clamped = clampTo(isFinite(length) ? length : rules::kDefaultRoomLength, 8.0f, 4000.0f);
  return static_cast<float>(static_cast<std::int32_t>(clamped * 256.0f + 0.5f)) * rules::kLengthStep;
}

std::int64_t Pace::toUnits(float length) { return static_cast<std::int64_t>(allowedLength(length) * 65536.0f); }

std::int64_t Pace::nextRoomAt() const { return length_ - static_cast<std::int64_t>(rules::kNextRoomAhead * 65536.0f); }

void Pace::startBefore(float length) {
  length_ = glide_ = toUnits(length);
  const std::int64_t goal = nextRoomAt();
  const std::int64_t ticks = goal < 0 ? 1 : goal * kSteps / glide_ + 1;  // the first tick beyond the goal
  distance_ = ticks * glide_;
}

void Pace::enterRoom(float length) {
  distance_ -= length_ * kSteps;
  length_ = toUnits(length);
}

void Pace::tick() {
  const std::int64_t difference = length_ - glide_;
  std::int64_t step = difference / rules::kPaceShift;
  if (step == 0 && difference != 0) step = difference > 0 ? 1 : -1;  // arrives exactly, so that rooms of one length are all alike
  glide_ += step;
  distance_ += glide_;
}

float Pace::distance() const { return static_cast<float>(static_cast<double>(distance_) / (65536.0 * kSteps)); }
float Pace::roomLength() const { return static_cast<float>(length_) / 65536.0f; }
float Pace::speed() const { return static_cast<float>(static_cast<double>(glide_) / (65536.0 * 32.0)); }

}  // namespace brittle::sim
