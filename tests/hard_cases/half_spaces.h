// hard_cases/half_spaces.h - a cell of half-spaces as another library cuts it: Voro++, in double, by vertices and
// orders of its own. Source: Rycroft, Voro++: A Three-Dimensional Voronoi Cell Library in C++, 2009.
#pragma once

#include <span>
#include <voro++/voro++.hh>

#include "tests/engine/geometry/cutting.h"

namespace brittle::geometry {

/// Smallest face that is counted [m2]: below, what is an edge to one cutter may be a sliver to another.
inline constexpr double kLeastFace = 1e-7;

struct OtherCell {
  double volume = 0.0;  // [m3]
  int faces = 0;        // larger than kLeastFace
};

/// The part of a box about the origin that lies below all planes and holds `inside`.
inline OtherCell otherCell(const Vec3d& half, const Vec3d& inside, std::span<const PlaneT<double>> planes) {
  voro::voronoicell cell;
  const Vec3d low = -half - inside, high = half - inside;
  cell.init(low.x(), high.x(), low.y(), high.y(), low.z(), high.z());
  for (const PlaneT<double>& plane : planes)
    cell.plane(plane.normal.x(), plane.normal.y(), plane.normal.z(), 2.0 * (plane.offset - plane.normal.dot(inside)));
  OtherCell found;
  found.volume = cell.volume();
  std::vector<double> areas;
  cell.face_areas(areas);
  for (const double area : areas) found.faces += area > kLeastFace ? 1 : 0;
  return found;
}

template <class S>
int facesOf(const ConvexT<S>& convex) {
  int count = 0;
  for (const FaceT<S>& face : convex.faces) count += areaOf(convex, face) > kLeastFace ? 1 : 0;
  return count;
}

}  // namespace brittle::geometry
