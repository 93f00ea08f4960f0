// game/sim/pace.h - how far the camera is along its room. Whole numbers, so that nothing drifts: the same room takes the same ticks and
// stands at the same places wherever it lies along the game. Knows no world and no script.
#pragma once

#include <cstdint>

namespace brittle::sim {

class Pace {
 public:
  /// Starts in an empty room of `length` [m] at the tick at which a room after it would be made, so that the first room of a game is
  /// entered exactly as every later one.
  void startBefore(float length);
  /// The room after the door: what was gone too far is kept, the speed glides.
  void enterRoom(float length);
  void tick();

  /// Of the camera from the room's start [m].
  float distance() const;
  float roomLength() const;                       // [m], a multiple of 2^-8
  float speed() const;                            // [m/s]
  bool atDoor() const { return distance_ >= length_ * kSteps; }
  /// Whether the room after this one is to be made.
  bool nextRoomDue() const { return distance_ > nextRoomAt() * kSteps; }
  std::int64_t lengthUnits() const { return length_ >> 8; }  // [2^-8 m]

  template <class Archive>
  void serialize(Archive& a) {
    a(length_);
    a(glide_);
    a(distance_);
  }

 private:
  static std::int64_t toUnits(float length);
  std::int64_t nextRoomAt() const;                // [2^-16 m]
  static constexpr std::int64_t kSteps = 1920;    // ticks per room
  std::int64_t length_ = 0;                       // [2^-16 m]
  std::int64_t glide_ = 0;                        // smoothed length [2^-16 m]
  std::int64_t distance_ = 0;                     // [2^-16 / 1920 m]: one tick adds `glide_`
};

/// The nearest length the rules allow: a multiple of 2^-8 in [8, 4000]. [m]
float allowedLength(float length);

}  // namespace brittle::sim
