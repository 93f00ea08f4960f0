// fracture/strike.h - where an impact strikes a compound: the point of the body it belongs to, the sheet hit there, and
// how large the hole must be. Every pattern is drawn in this frame. Knows nothing of cutting.
#pragma once

#include <cstdint>
#include <span>

#include "engine/fracture/fracture.h"

namespace brittle::fracture {

struct Strike {
  std::uint32_t part = 0;           // the part nearest to the impact
  Vec3 center = Vec3::Zero();       // the impact, moved into the body [m]
  Vec3 direction = -Vec3::UnitZ();  // unit, the striker's way
  // The sheet that was hit: `normal` is its thin axis; right, up and normal are a right-handed frame.
  Vec3 normal = Vec3::UnitZ();
  Vec3 right = Vec3::UnitX();
  Vec3 up = Vec3::UnitY();
  float middle = 0.0f;          // normal . x half-way through the sheet [m]
  float thickness = 0.0f;       // of the nearest part along `normal` [m]
  Vec3 passage = Vec3::Zero();  // where the striker's path crosses the middle of the sheet [m]
  float strikerRadius = 0.0f;   // [m]
  float radius = 0.0f;          // of the carved volume [m]
};

/// `parts` is not empty. Finite for any finite impact.
Strike strikeOf(std::span<const Part> parts, const Impact& impact, const FractureMaterial& material);

/// How far [m] from `passage` the striker reaches within the sheet in the in-plane direction `along` (unit): half the
/// width of the shadow that its swept cylinder casts, longer along the slant.
float reachWithinSheet(const Strike& strike, float strikerRadius, const Vec3& along);

/// The point of the convex that is closest to `point`: itself if it lies inside.
Vec3 closestPoint(const geometry::ConvexView& convex, const Vec3& point);

}  // namespace brittle::fracture
