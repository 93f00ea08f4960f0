// geometry/make.h - convexes to start from: boxes, prisms, cylinders, hulls of points. Every one is valid in the sense
// of findTopologyError, which is the premise of split's guarantee.
#pragma once

#include <span>

#include "engine/core/result.h"
#include "engine/geometry/convex.h"

namespace brittle::geometry {

/// A box with the given half extents [m] > 0 about `center`.
template <class S>
ConvexT<S> makeBox(const Vec3T<S>& halfExtents, const Vec3T<S>& center = Vec3T<S>(S(0), S(0), S(0)));

/// A cylinder along Y: `sides` in [3, 10000], radius and half height [m] > 0. Side vertices carry smooth normals if
/// `smooth`.
Convex makeCylinder(float radius, float halfHeight, int sides, bool smooth = true);

/// A prism: a convex polygon (counter-clockwise seen from +Z, points in the XY plane, at least 3, no three in a line)
/// extruded to |z| <= halfDepth.
Result<Convex> makePrism(std::span<const Vec2> polygon, float halfDepth);

/// The convex hull of at least 4 points not in one plane. Coplanar triangles are merged into one face.
Result<Convex> makeHull(std::span<const Vec3> points);

/// The same convex rotated, moved and scaled (scale per axis > 0); planes are computed afresh.
Convex transformed(const ConvexView& convex, const Quat& rotation, const Vec3& translation,
                   const Vec3& scale = Vec3::Ones());

}  // namespace brittle::geometry
