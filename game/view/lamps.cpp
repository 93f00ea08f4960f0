#include "game/view/lamps.h"

namespace brittle::view {
namespace {

constexpr float kHalo = 0.75f;  // radius [m]
constexpr float kHaloLight = 0.10f;
constexpr float kPlaces[] = {-0.667f, 0.0f, 0.667f};  // of halos along a lamp

}  // namespace

void addHalos(const sim::SegmentLook& look, const Vec3& origin, std::vector<render::Glow>& glows) {
  for (const sim::LookBox& box : look.boxes) {
    if (box.glow <= 0.0f) continue;
    Eigen::Index longest = 0;
    box.halfExtents.maxCoeff(&longest);
    for (const float place : kPlaces) {
      Vec3 point = origin + box.center;
      point[longest] += place * box.halfExtents[longest];
      glows.push_back({point, kHalo, render::packRgba(box.color[1], kHaloLight)});
    }
  }
}

bool hasLamps(const sim::FramePacket& packet) {
  for (const sim::RoomView& room : packet.rooms)
    for (const sim::PlacedSegment& segment : room.segments)
      for (const sim::LookBox& box : segment.look->boxes)
        if (box.glow > 0.0f) return true;
  return false;
}

}  // namespace brittle::view
