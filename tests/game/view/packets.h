// Packets made by hand, for the tests of the view.
#pragma once

#include "game/sim/frame_packet.h"
#include "game/view/omission.h"

namespace brittle::view {

inline sim::Event eventOf(sim::EventType type, const Vec3& point) {
  sim::Event event;
  event.type = type;
  event.point = point;
  return event;
}

/// The default's, for who does not look at what is left out.
inline Bounds& anyBounds() {
  static Bounds bounds;
  return bounds;
}

/// One room with a floor of 4 x 8 m, in which every effect runs that finds something to do, and a camera one metre
/// above it.
inline sim::FramePacket packetAt(std::uint64_t tick) {
  sim::FramePacket packet;
  packet.tick = tick;
  packet.time = static_cast<double>(tick);
  packet.camera.halfWidthTangent = 0.57735f;
  packet.camera.near = 0.2f;
  packet.camera.far = 100.0f;
  packet.fogNear = 5.0f;
  packet.fogFull = 25.0f;
  packet.hud.balls = 25;
  auto look = std::make_shared<sim::SegmentLook>();
  look->name = "floor";
  look->length = 8.0f;
  sim::LookBox floor;
  floor.center = Vec3(0.0f, -0.5f, -4.0f);
  floor.halfExtents = Vec3(2.0f, 0.5f, 4.0f);
  look->boxes.push_back(floor);
  sim::RoomView room;
  room.effects = effects::EffectMask::ofBits(~0u);
  room.segments.push_back({1, Vec3::Zero(), look});
  packet.rooms.push_back(room);
  return packet;
}

}  // namespace brittle::view
