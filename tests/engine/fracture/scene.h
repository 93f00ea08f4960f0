// Compounds to break, and what every breaking must satisfy.
#pragma once

#include <deque>
#include <vector>

#include "engine/fracture/fracture.h"
#include "engine/geometry/convex.h"

namespace brittle::fracture {

inline constexpr float kSlop = 0.001f;

/// Owns the convexes its parts view.
struct Scene {
  std::deque<geometry::Convex> convexes;
  std::deque<Anchor> anchors;
  std::vector<Part> parts;

  Part& add(geometry::Convex convex, bool anchored = false);
  Part& addBox(const Vec3& halfExtents, const Vec3& center, bool anchored = false);
  double volume() const;
};

/// 1 m x 1 m x 2 cm in the XY plane.
Scene pane();
/// The same pane of two halves that meet at x = 0.
Scene panesWithSeam();
/// Half a metre each way.
Scene block();

Impact straightAt(const Vec3& point, float speed = 10.0f, float strikerRadius = 0.05f);

geometry::ConvexView viewOf(const Scene& scene, const Fracture& made, const Piece& piece);

/// Volumes add up, every piece is a valid convex, groups and neighbours are consistent. Uses gtest expectations.
void expectSound(const Scene& scene, const Fracture& made);

/// Each of so many random points of the box `half` lies in exactly one piece: in none that is farther than 2e-6 m away,
/// in one that is as near.
void expectPartition(const Scene& scene, const Fracture& made, const Vec3& half, int samples);

/// Of everything in the result, bit for bit.
std::uint64_t hashOf(const Fracture& made);

/// Distance of the convex from the line through `point` along the unit vector `direction`; 0 if the line meets it.
float distanceFromLine(const geometry::ConvexView& convex, const Vec3& point, const Vec3& direction);

}  // namespace brittle::fracture
