// geometry/penetration.h - how deep two convexes overlap: the separating-axis test over the faces of both and the pairs
// of edges. Used by gjk.cpp when the two touch or overlap; everything in A's frame and in double. Source: Gregorius,
// The Separating Axis Test between Convex Polyhedra (GDC), 2013; the pruning by distance is ours.
#pragma once

#include "engine/geometry/convex.h"
#include "engine/geometry/relative_pose.h"

namespace brittle::geometry {

struct Penetration {
  double separation = -1.0e300;         // [m]; the largest over all axes, so minus the least depth
  Vec3d normal = Vec3d(0.0, 1.0, 0.0);  // unit, from A towards B
  Vec3d pointA = Vec3d::Zero();         // [m]
  Vec3d pointB = Vec3d::Zero();
  std::uint32_t axis = 0;  // the face it came from, as in SimplexCache; 0: a pair of edges
};

/// `deepA` and `deepB` are vertices near the overlap; any are legal, good ones save time. The separation is true for
/// the axis given (measured over all vertices), so errors in planes cost depth but never give a wrong answer. `guess`
/// is the axis of the last time: tested first, it rules out most others.
Penetration leastPenetration(const ConvexView& a, const ConvexView& b, const RelativePose& pose, std::uint32_t deepA,
                             std::uint32_t deepB, std::uint32_t guess);

/// The same of a point against a convex A.
Penetration pointPenetration(const ConvexView& a, const Vec3d& point);

}  // namespace brittle::geometry
