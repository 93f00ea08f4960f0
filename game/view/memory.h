// view/memory.h - what the picture remembers of the last ticks' events. Everything in it is forgotten after
// kMemoryTicks, so a picture is a function of the packets of that many ticks and a range of frames renders alone as it
// does in a full run.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "engine/render/frame.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

/// A rendering that begins this many ticks before its first picture has all that the picture needs.
inline constexpr std::uint32_t kMemoryTicks = 180;

/// An event with its place along the whole game, which origin shifts do not move.
struct Remembered {
  sim::Event event;
  std::uint64_t tick = 0;
  double placeZ = 0.0;  // [m]
  double time = 0.0;    // of the game [ticks]

  /// In the frame of a packet with this origin.
  Vec3 pointIn(double originZ) const {
    return {event.point.x(), event.point.y(), static_cast<float>(placeZ - originZ)};
  }
};

class Memory {
 public:
  void tick(const sim::FramePacket& packet);
  void clear();

  const std::deque<Remembered>& events() const { return events_; }
  /// Ticks since the last event of a type, as of `tick` (which may lie between two); kMemoryTicks if none is
  /// remembered.
  float ageOf(sim::EventType type, double tick) const;
  /// The fog of the room left last; meaningful for kMemoryTicks after RoomEntered.
  const render::Fog& fogBefore() const { return fogBefore_; }
  /// Ticks since the shown number of balls changed, like ageOf.
  float ballsAge(double tick) const;
  /// By how much they changed last; meaningful while ballsAge is below kMemoryTicks.
  std::int32_t ballsChange() const { return ballsChange_; }

 private:
  std::deque<Remembered> events_;
  render::Fog fog_, fogBefore_;
  std::int32_t balls_ = 0, ballsChange_ = 0;
  std::uint64_t ballsTick_ = 0;
  bool knowsBalls_ = false, ballsChanged_ = false;
};

/// The fog of the room a packet's camera is in.
render::Fog fogOf(const sim::FramePacket& packet);

}  // namespace brittle::view
