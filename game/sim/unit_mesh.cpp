#include "game/sim/unit_mesh.h"

#include <vector>

#include "engine/geometry/make.h"
#include "engine/math/trig.h"

namespace brittle::sim {

namespace {

/// A regular polygon in the XY plane with a corner at the top, from `from` to `to` of the full circle.
std::vector<Vec2> arc(int corners, float from, float to, bool closed) {
  std::vector<Vec2> points;
  const int steps = closed ? corners : corners - 1;
  for (int i = 0; i < corners; ++i) {
    const float part = from + (to - from) * static_cast<float>(i) / static_cast<float>(steps);
    const float angle = 0.5f * kPi + 2.0f * kPi * part;
    points.push_back(Vec2(0.5f * cosine(angle), 0.5f * sine(angle)));
  }
  return points;
}

Result<geometry::Convex> prism(std::vector<Vec2> polygon) {
  return geometry::makePrism(polygon, 0.5f);
}

/// A slice of a disc of `parts` slices, its tip in the middle.
Result<geometry::Convex> slice(int parts) {
  std::vector<Vec2> points = arc(4, 0.0f, 1.0f / static_cast<float>(parts), false);
  points.push_back(Vec2::Zero());
  return prism(points);
}

}  // namespace

Result<geometry::Convex> unitMesh(const std::string& name) {
  if (name == "pyramid") {
    const std::vector<Vec3> points = {Vec3(-0.5f, -0.5f, -0.5f), Vec3(0.5f, -0.5f, -0.5f), Vec3(0.5f, -0.5f, 0.5f),
                                      Vec3(-0.5f, -0.5f, 0.5f), Vec3(0.0f, 0.5f, 0.0f)};
    return geometry::makeHull(points);
  }
  if (name == "diamond") {
    const std::vector<Vec3> points = {Vec3(0.5f, 0.0f, 0.0f),  Vec3(-0.5f, 0.0f, 0.0f), Vec3(0.0f, 0.5f, 0.0f),
                                      Vec3(0.0f, -0.5f, 0.0f), Vec3(0.0f, 0.0f, 0.5f),  Vec3(0.0f, 0.0f, -0.5f)};
    return geometry::makeHull(points);
  }
  if (name == "pin") {
    std::vector<Vec3> points;
    const float heights[4] = {-0.5f, -0.1f, 0.35f, 0.5f};
    const float radii[4] = {0.14f, 0.2f, 0.1f, 0.06f};
    for (int ring = 0; ring < 4; ++ring)
      for (int i = 0; i < 8; ++i) {
        const float angle = 2.0f * kPi * static_cast<float>(i) / 8.0f;
        points.push_back(Vec3(radii[ring] * cosine(angle), heights[ring], radii[ring] * sine(angle)));
      }
    return geometry::makeHull(points);
  }
  if (name == "3gon" || name == "triangle") return prism(arc(3, 0.0f, 1.0f, true));
  if (name == "4gon") return prism(arc(4, 0.0f, 1.0f, true));
  if (name == "5gon") return prism(arc(5, 0.0f, 1.0f, true));
  if (name == "6gon") return prism(arc(6, 0.0f, 1.0f, true));
  if (name == "triangle2") return prism({Vec2(-0.5f, -0.5f), Vec2(0.5f, -0.5f), Vec2(-0.5f, 0.5f)});
  if (name == "circleseg") return slice(8);
  if (name == "circleseg6") return slice(6);
  return Error{
      "mesh \"" + name +
      "\": unknown, expected pyramid, diamond, pin, 3gon to 6gon, triangle, triangle2, circleseg or circleseg6"};
}

}  // namespace brittle::sim
