#include "game/sim/pace.h"

#include "engine/math/types.h"
#include "game/sim/constants.h"

namespace brittle::sim {

float allowedLength(float length) {
  const float clamped = clampTo(isFinite(length) ? length : rules::kDefaultRoomLength, 8.0f, 4000.0f);
  return static_cast<float>(static_cast<std::int32_t>(clamped * 256.0f + 0.5f)) * rules::kLengthStep;
}

std::int64_t Pace::toUnits(float length) {
  return static_cast<std::int64_t>(allowedLength(length) * 65536.0f);
}

void Pace::startBefore(float length) {
  length_ = glide_ = step_ = toUnits(length);
  ticks_ = 0;
  while (!nextRoomDue()) ++ticks_;
}

void Pace::enterRoom(float length) {
  length_ = toUnits(length);
  ticks_ = 0;
}

void Pace::tick(const TimeStep& time) {
  const std::int64_t before = place();
  const std::int64_t left = rules::kRoomTicks - ticks_;
  const std::int64_t way = (length_ - glide_) * time.share;
  glide_ += way / (clampTo<std::int64_t>(left, 1, rules::kPaceShift) * kWholeTick);
  part_ = time.partAfter();
  if (time.isWhole()) ++ticks_;
  // The last tick takes what is left of the difference: the camera stands in the door to the bit, and the next room
  // begins at 0; in slow motion it stands beyond by less than a tick's way, as it does in the next room.
  if (atDoor()) glide_ = length_;
  step_ = (place() - before) * kWholeTick / time.share;
}

bool Pace::isValid() const {
  constexpr std::int64_t shortest = std::int64_t{8} << 16, longest = std::int64_t{4000} << 16;
  constexpr std::int64_t farthest = longest * rules::kRoomTicks * 2;
  return length_ >= shortest && length_ <= longest && glide_ >= shortest && glide_ <= longest && step_ >= -farthest &&
         step_ <= farthest && ticks_ >= 0 && ticks_ <= 2 * rules::kRoomTicks && part_ >= 0 && part_ < kWholeTick;
}

bool Pace::atDoor() const {
  return ticks_ >= rules::kRoomTicks;
}

bool Pace::nextRoomDue() const {
  return distance() > roomLength() - rules::kNextRoomAhead || ticks_ > rules::kNextRoomTicks;
}

float Pace::distance() const {
  return static_cast<float>(static_cast<double>(place()) / (65536.0 * rules::kRoomTicks));
}
float Pace::roomLength() const {
  return static_cast<float>(length_) / 65536.0f;
}
float Pace::speed() const {
  return static_cast<float>(static_cast<double>(step_) * rules::kTickRate / (65536.0 * rules::kRoomTicks));
}

}  // namespace brittle::sim
