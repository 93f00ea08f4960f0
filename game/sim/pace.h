// game/sim/pace.h - how far the camera is along its room. A room lasts 32 s whatever its length: the distance is the
// time in the room times the room's length over 32 s, and the length glides over from that of the room before. Whole
// numbers, so that nothing drifts: the same room takes the same ticks and stands at the same places wherever it lies
// along the game. Knows no world and no script.
#pragma once

#include <cstdint>

#include "game/sim/slow_motion.h"

namespace brittle::sim {

class Pace {
 public:
  /// Starts in an empty room of `length` [m] at the tick at which a room after it would be made, so that the first room
  /// of a game is entered exactly as every later one.
  void startBefore(float length);
  /// The room after the door; the speed glides. Only at the door.
  void enterRoom(float length);
  /// At the door at most until enterRoom. A part of a tick goes that part of the way.
  void tick(const TimeStep& time = {});

  /// Of the camera from the room's start [m].
  float distance() const;
  float roomLength() const;  // [m], a multiple of 2^-8
  float speed() const;       // of the last tick, in the game's time [m/s]
  /// Ticks of the game's time since the room was entered: the clock that music and beats follow.
  std::int32_t ticks() const { return ticks_; }
  float tickPart() const { return static_cast<float>(part_) / kWholeTick; }  // and this of a tick more
  bool atDoor() const;
  /// Whether all of it is what ticking can lead to, within a margin: what bytes from a file must hold.
  bool isValid() const;
  /// Whether the room after this one is to be made.
  bool nextRoomDue() const;
  std::int64_t lengthUnits() const { return length_ >> 8; }  // [2^-8 m]

  template <class Archive>
  void serialize(Archive& a) {
    a(length_);
    a(glide_);
    a(step_);
    std::int32_t packed = ticks_ | part_ << kPartShift;  // without slow motion: ticks_
    a(packed);
    ticks_ = packed & ((1 << kPartShift) - 1);
    part_ = packed >> kPartShift;
  }

 private:
  static constexpr int kPartShift = 16;
  static std::int64_t toUnits(float length);
  /// [2^-16 / 1920 m]
  std::int64_t place() const { return glide_ * (std::int64_t{ticks_} * kWholeTick + part_) / kWholeTick; }

  std::int64_t length_ = 0;  // [2^-16 m]
  std::int64_t glide_ = 0;   // smoothed length [2^-16 m]
  std::int64_t step_ = 0;    // way of the last tick, were it a whole one [2^-16 / 1920 m]
  std::int32_t ticks_ = 0;
  std::int32_t part_ = 0;  // of a tick [256ths of a tick]
};

/// The nearest length the rules allow: a multiple of 2^-8 in [8, 4000]. [m]
float allowedLength(float length);

}  // namespace brittle::sim
