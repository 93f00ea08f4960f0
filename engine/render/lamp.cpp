#include "engine/render/lamp.h"

#include <cmath>

#include "engine/render/bake.h"

namespace brittle::render {

namespace {

constexpr float kBrightness = 2.6f;  // light one metre before a lamp of one square metre and glow 1. Chosen by eye
constexpr float kSoftness = 0.35f;   // added to squared distances, so that nothing next to a lamp burns out [m2]
constexpr float kReach = 9.0f;       // nothing farther is lit [m]: there a lamp of a square metre adds 5 %
constexpr float kOwnMargin = 0.12f;  // what holds a lamp does not hide it [m]

Lamp lampOf(const BakeBox& box) {
  const Vec3 h = box.halfExtents;
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (h[axis] > h[longest]) longest = axis;
  const float area = 4.0f * maxOf(h.x() * h.y(), maxOf(h.y() * h.z(), h.x() * h.z()));
  Lamp lamp;
  lamp.color = box.color[1];
  lamp.strength = box.glow * kBrightness * area / static_cast<float>(kLampPoints);
  for (std::size_t i = 0; i < kLampPoints; ++i) {
    lamp.points[i] = box.center;
    lamp.points[i][longest] += h[longest] * (static_cast<float>(i) - 1.0f) * 0.667f;
  }
  return lamp;
}

}  // namespace

void addLamps(std::span<const BakeBox> boxes, std::vector<Lamp>& lamps) {
  for (const BakeBox& box : boxes)
    if (box.glow > 0.0f) lamps.push_back(lampOf(box));
}

Vec3 lightAt(const Vec3& point, const Vec3& normal, std::span<const Lamp> lamps, const Occlusion& occlusion) {
  Vec3 light = Vec3::Zero();
  const Vec3 start = point + normal * 0.02f;
  for (const Lamp& lamp : lamps) {
    for (const Vec3& from : lamp.points) {
      const Vec3 way = from - point;
      const float facing = way.dot(normal), squared = way.squaredNorm();
      if (facing <= 0.0f || squared > kReach * kReach || occlusion.isBlocked(start, from, kOwnMargin)) continue;
      const float soft = squared + kSoftness;
      const float fade = 1.0f - squared / (kReach * kReach);
      light += lamp.color * (lamp.strength * fade * facing / (soft * std::sqrt(soft)));
    }
  }
  return light;
}

}  // namespace brittle::render
