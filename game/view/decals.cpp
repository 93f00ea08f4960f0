#include "game/view/decals.h"

#include <cmath>
#include <optional>

#include "game/view/noise.h"

namespace brittle::view {
namespace {

constexpr float kMarkSpeed = 5.0f;            // a ball must be this fast to leave a mark [m/s]
constexpr float kMarkNear = 0.08f;            // farther from a box than this, it is not what was hit [m]
constexpr float kLift = 0.004f;               // of a decal above its surface [m]
constexpr int kFirstCrack = 40, kCracks = 8;  // tiles
const render::Rgb kMark(0.10f, 0.12f, 0.15f);

/// `frame`: of what the decal lies on.
render::Decal decalOf(const sim::LookDecal& decal, const Transform& frame) {
  const Quat rotation = frame.rotation * decal.rotation;
  const Vec3 lift = rotation * Vec3(0.0f, 0.0f, kLift);
  const std::uint32_t color = render::packRgba(decal.color.head<3>(), decal.color.w());
  return {frame.toWorld(decal.position) + lift, rotation, decal.size, decal.tile, color,
          clampTo(decal.blend, 0.0f, 1.0f)};
}

void addOfLevel(const sim::PlacedSegment& segment, render::Frame& frame) {
  for (const sim::LookDecal& decal : segment.look->decals)
    frame.decals.push_back(decalOf(decal, {segment.origin, Quat::Identity()}));
}

void addOfBodies(const sim::RoomView& room, render::Frame& frame) {
  for (const sim::BodyDecal& decal : room.bodyDecals) {
    if (decal.body >= room.bodies.size() || room.bodies[decal.body].generation == 0) continue;
    frame.decals.push_back(decalOf(decal.look, room.bodies[decal.body].pose));
  }
}

struct Surface {
  Vec3 point;
  Vec3 normal;
};

/// The face of the segment's boxes nearest to a point, if one is near.
std::optional<Surface> surfaceNear(const sim::PlacedSegment& segment, const Vec3& point) {
  std::optional<Surface> nearest;
  float least = kMarkNear;
  for (const sim::LookBox& box : segment.look->boxes) {
    const Vec3 d = point - segment.origin - box.center;
    const Vec3 outside = d.cwiseAbs() - box.halfExtents;
    Eigen::Index axis = 0;
    const float distance = std::fabs(outside.maxCoeff(&axis));
    if (distance >= least) continue;
    least = distance;
    Vec3 normal = Vec3::Zero();
    normal[axis] = d[axis] < 0.0f ? -1.0f : 1.0f;
    nearest = {point - normal * (outside[axis] - kLift), normal};
  }
  return nearest;
}

void addMark(const sim::PlacedSegment& segment, const Remembered& r, const Vec3& point, float age,
             render::Frame& frame) {
  const std::optional<Surface> surface = surfaceNear(segment, point);
  if (!surface) return;
  const Noise noise(r.tick * 31 + static_cast<std::uint64_t>(r.event.impulse));
  const float left = clampTo(2.0f - 2.0f * age / static_cast<float>(kMemoryTicks), 0.0f, 1.0f);
  const float size = clampTo(0.012f * r.event.speed, 0.08f, 0.28f);
  const Quat facing = Quat::FromTwoVectors(Vec3::UnitZ(), surface->normal);
  const Quat turned = facing * rotationAbout(Vec3::UnitZ(), noise(0, 0.0f, 6.28f));
  const int tile = kFirstCrack + static_cast<int>(noise(1, 0.0f, static_cast<float>(kCracks)));
  frame.decals.push_back({surface->point, turned, Vec2(size, size), tile, render::packRgba(kMark, 0.45f * left), 1.0f});
}

bool holds(const sim::PlacedSegment& segment, const Vec3& point) {
  return point.z() <= segment.origin.z() && point.z() > segment.origin.z() - segment.look->length;
}

}  // namespace

void addDecals(const sim::FramePacket& packet, const Memory& memory, double tick, render::Frame& frame) {
  for (const sim::RoomView& room : packet.rooms) {
    for (const sim::PlacedSegment& segment : room.segments) addOfLevel(segment, frame);
    addOfBodies(room, frame);
  }
  for (const Remembered& r : memory.events()) {
    const bool byBall = r.event.type == sim::EventType::Hit && r.event.value == 1;
    if (!byBall || r.event.look != sim::Look::Static || r.event.speed < kMarkSpeed) continue;
    const float age = static_cast<float>(tick - static_cast<double>(r.tick)) + 0.5f;
    const Vec3 point = r.pointIn(packet.originZ);
    for (const sim::RoomView& room : packet.rooms)
      for (const sim::PlacedSegment& segment : room.segments)
        if (age >= 0.0f && holds(segment, point)) addMark(segment, r, point, age, frame);
  }
}

}  // namespace brittle::view
