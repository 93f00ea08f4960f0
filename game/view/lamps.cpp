#include "game/view/lamps.h"

#include <cmath>

#include "engine/math/aabb.h"

namespace brittle::view {
namespace {

constexpr int kSamples = 3;          // points along a lamp that stand for it
constexpr float kBrightness = 4.5f;  // light one metre before a lamp of one square metre and glow 1. Chosen by eye
constexpr float kSoftness = 0.35f;   // added to squared distances, so that nothing next to a lamp burns out [m2]
constexpr float kHalo = 0.75f;       // radius [m]
constexpr float kHaloLight = 0.10f;

struct Lamp {
  Aabb box;
  Vec3 color;
  Vec3 points[kSamples];
  float strength;
};

std::vector<Lamp> lampsOf(const sim::SegmentLook& look) {
  std::vector<Lamp> lamps;
  for (const sim::LookBox& box : look.boxes) {
    if (box.glow <= 0.0f) continue;
    Lamp lamp{{box.center - box.halfExtents, box.center + box.halfExtents}, box.color[1], {}, 0.0f};
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
      if (box.halfExtents[axis] > box.halfExtents[longest]) longest = axis;
    const Vec3 h = box.halfExtents;
    const float area = 4.0f * maxOf(h.x() * h.y(), maxOf(h.y() * h.z(), h.x() * h.z()));
    lamp.strength = box.glow * kBrightness * area / kSamples;
    for (int i = 0; i < kSamples; ++i) {
      lamp.points[i] = box.center;
      lamp.points[i][longest] += h[longest] * (static_cast<float>(i) - 1.0f) * 0.667f;
    }
    lamps.push_back(lamp);
  }
  return lamps;
}

Vec3 lightAt(const Vec3& point, const Vec3& normal, const std::vector<Lamp>& lamps) {
  Vec3 light = Vec3::Zero();
  for (const Lamp& lamp : lamps) {
    for (const Vec3& from : lamp.points) {
      const Vec3 way = from - point;
      const float squared = way.squaredNorm() + kSoftness;
      light += lamp.color * (lamp.strength * maxOf(way.dot(normal), 0.0f) / (squared * std::sqrt(squared)));
    }
  }
  return light;
}

std::uint32_t brightened(std::uint32_t color, const Vec3& by) {
  std::uint32_t result = color & 0xff000000u;
  for (int i = 0; i < 3; ++i) {
    const float value = static_cast<float>(color >> (8 * i) & 0xffu) * (1.0f + by[i]);
    result |= static_cast<std::uint32_t>(minOf(value + 0.5f, 255.0f)) << (8 * i);
  }
  return result;
}

}  // namespace

void lightByLamps(const sim::SegmentLook& look, render::BakedMesh& mesh) {
  const std::vector<Lamp> lamps = lampsOf(look);
  if (lamps.empty()) return;
  for (std::size_t quad = 0; quad + 3 < mesh.vertices.size(); quad += 4) {
    render::StaticVertex* corner = &mesh.vertices[quad];
    const Vec3 across = corner[1].point - corner[0].point, up = corner[3].point - corner[0].point;
    const Vec3 normal = normalizedOr(across.cross(up), Vec3::UnitY());
    const Vec3 center = 0.5f * (corner[0].point + corner[2].point);
    const Lamp* own = nullptr;
    for (const Lamp& lamp : lamps)
      if (lamp.box.grownBy(1e-3f).contains(center)) own = &lamp;
    for (int i = 0; i < 4; ++i)
      corner[i].color = own != nullptr ? render::packRgba(own->color * 0.5f)
                                       : brightened(corner[i].color, lightAt(corner[i].point, normal, lamps));
  }
}

void addHalos(const sim::SegmentLook& look, const Vec3& origin, std::vector<render::Glow>& glows) {
  for (const Lamp& lamp : lampsOf(look))
    for (const Vec3& point : lamp.points)
      glows.push_back({origin + point, kHalo, render::packRgba(lamp.color, kHaloLight)});
}

}  // namespace brittle::view
