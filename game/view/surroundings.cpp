#include "game/view/surroundings.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace brittle::view {
namespace {

constexpr float kBehind = 3.0f, kAhead = 13.0f;  // the part of the way that counts, from the camera [m]
constexpr float kFade = 3.0f;                    // lamps come and go over this [m]
constexpr float kFarthestSide = 12.0f;           // where a room has no side [m]
constexpr int kSlices = 7;                       // places along a segment where it is measured

/// A side of a room as seen from the camera's way.
struct Side {
  float distance = kFarthestSide;  // [m]
  Vec3 color = Vec3::Constant(0.5f);
};

/// The nearest face of the look's boxes on the way from (0, 1) towards `sign` on `axis`, at `z` in the segment's frame.
Side sideAt(const sim::SegmentLook& look, int axis, float sign, float z) {
  const int other = 1 - axis;
  const Vec3 eye(0.0f, 1.0f, z);
  Side nearest;
  for (const sim::LookBox& box : look.boxes) {
    if (box.glow > 0.0f || std::fabs(z - box.center.z()) > box.halfExtents.z()) continue;
    if (std::fabs(eye[other] - box.center[other]) > box.halfExtents[other]) continue;
    const float distance = sign * (box.center[axis] - eye[axis]) - box.halfExtents[axis];
    if (distance <= 0.0f || distance >= nearest.distance) continue;
    const auto face = static_cast<std::size_t>(axis == 0 ? (sign > 0.0f ? 0 : 1) : (sign > 0.0f ? 3 : 2));
    nearest = {distance, box.color[axis] * look.light[face]};
  }
  return nearest;
}

/// The usual side of a segment: the one in the middle of those measured, by distance.
Side usualSide(const sim::SegmentLook& look, int axis, float sign) {
  std::array<Side, kSlices> sides;
  for (std::size_t i = 0; i < sides.size(); ++i)
    sides[i] = sideAt(look, axis, sign, -look.length * (static_cast<float>(i) + 0.5f) / kSlices);
  std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.distance < b.distance; });
  return sides[kSlices / 2];
}

void addLamps(const sim::PlacedSegment& segment, float cameraZ, render::Surroundings& result) {
  for (const sim::LookBox& box : segment.look->boxes) {
    if (box.glow <= 0.0f) continue;
    const Vec3 center = segment.origin + box.center;
    const float ahead = cameraZ - center.z();
    const float fade = clampTo(minOf(ahead + kBehind, kAhead - ahead) / kFade, 0.0f, 1.0f);
    if (fade <= 0.0f) continue;
    result.lamps.push_back({center, box.halfExtents, minOf(box.glow, 2.0f) * fade});
    result.lampColor = box.color[1];
  }
}

void keepNearestLamps(const Vec3& eye, std::vector<render::Surroundings::Lamp>& lamps) {
  std::stable_sort(lamps.begin(), lamps.end(), [&eye](const auto& a, const auto& b) {
    return (a.center - eye).squaredNorm() < (b.center - eye).squaredNorm();
  });
  if (lamps.size() > render::kMostMirroredLamps) lamps.resize(render::kMostMirroredLamps);
}

class Mean {
 public:
  void add(const sim::SegmentLook& look, float weight) {
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const Side side = usualSide(look, i < 2 ? 0 : 1, i % 2 == 0 ? -1.0f : 1.0f);
      sides_[i].distance += weight * side.distance;
      sides_[i].color += weight * side.color;
    }
    weight_ += weight;
  }
  void write(render::Surroundings& result) const {
    if (weight_ <= 0.0f) return;
    const auto distance = [this](std::size_t i) { return sides_[i].distance / weight_; };
    const auto color = [this](std::size_t i) { return Vec3(sides_[i].color / weight_); };
    result.low = Vec2(-distance(0), 1.0f - distance(2));
    result.high = Vec2(distance(1), 1.0f + distance(3));
    result.left = color(0);
    result.right = color(1);
    result.floor = color(2);
    result.ceiling = color(3);
  }

 private:
  std::array<Side, 4> sides_ = {Side{0, Vec3::Zero()}, Side{0, Vec3::Zero()}, Side{0, Vec3::Zero()},
                                Side{0, Vec3::Zero()}};
  float weight_ = 0.0f;
};

}  // namespace

namespace {

/// Calls visit(segment, metres) for the segments about and ahead of the camera with how much of the way each holds.
template <class Visit>
void forSegmentsAbout(const sim::FramePacket& packet, Visit visit) {
  const float cameraZ = packet.camera.position.z();
  for (const sim::RoomView& room : packet.rooms)
    for (const sim::PlacedSegment& segment : room.segments) {
      const float near = minOf(segment.origin.z(), cameraZ + kBehind);
      const float far = maxOf(segment.origin.z() - segment.look->length, cameraZ - kAhead);
      if (near > far) visit(segment, near - far);
    }
}

}  // namespace

render::Surroundings surroundingsOf(const sim::FramePacket& packet, Bounds& bounds) {
  render::Surroundings result;
  Mean mean;
  forSegmentsAbout(packet, [&](const sim::PlacedSegment& segment, float length) {
    mean.add(*segment.look, length);
    addLamps(segment, packet.camera.position.z(), result);
  });
  mean.write(result);
  if (result.lamps.size() > render::kMostMirroredLamps)
    bounds.omissions.add(Omission::Lamp, result.lamps.size() - render::kMostMirroredLamps);
  keepNearestLamps(packet.camera.position, result.lamps);
  return result;
}

float shadowStrengthOf(const sim::FramePacket& packet) {
  float sum = 0.0f, weight = 0.0f;
  forSegmentsAbout(packet, [&](const sim::PlacedSegment& segment, float length) {
    sum += clampTo(segment.look->softShadow, 0.0f, 1.0f) * length;
    weight += length;
  });
  return weight > 0.0f ? sum / weight : 0.0f;
}

std::optional<float> mirrorHeightOf(const sim::FramePacket& packet) {
  std::map<float, float> areas;  // by height
  for (const sim::RoomView& room : packet.rooms)
    for (const sim::PlacedSegment& segment : room.segments)
      for (const sim::LookBox& box : segment.look->boxes) {
        const float top = segment.origin.y() + box.center.y() + box.halfExtents.y();
        if (box.reflects && top < packet.camera.position.y()) areas[top] += box.halfExtents.x() * box.halfExtents.z();
      }
  const auto largest =
      std::max_element(areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (largest == areas.end()) return std::nullopt;
  return largest->first;
}

}  // namespace brittle::view
