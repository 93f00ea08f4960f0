// geometry/grid_hull.h - the triangulated convex hull of points on an integer grid. Every sign is computed exactly, so
// the result is a closed mesh whatever the points. Used by makeHull.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace brittle::geometry {

/// Coordinates from 0 to kGridSteps.
using GridPoint = std::array<std::int64_t, 3>;
/// Indices of points, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// Differences of coordinates have 25 bits, determinants 78: exact in 128.
inline constexpr double kGridSteps = 0x1p24;

class GridHull {
 public:
  explicit GridHull(std::vector<GridPoint> points) : points_(std::move(points)) {}

  /// False if all points lie in one plane. Quadratic in the number of points.
  bool build();
  /// Triangles may lie in one plane with their neighbours; none is degenerate. The order depends on the points' order
  /// only.
  const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
  using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

  int sideOf(const Triangle& triangle, std::uint32_t point) const;
  bool start();
  void add(std::uint32_t point);

  std::vector<GridPoint> points_;
  std::vector<Triangle> triangles_;
  std::vector<DirectedEdge> outline_;
};

}  // namespace brittle::geometry
