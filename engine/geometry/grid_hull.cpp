// Source: Clarkson and Shor, Applications of Random Sampling in Computational Geometry, II, 1989 (without their
// randomness).
#include "engine/geometry/grid_hull.h"

#include <algorithm>

namespace brittle::geometry {
namespace {

__extension__ typedef __int128 Wide;

GridPoint between(const GridPoint& a, const GridPoint& b) {
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

GridPoint crossOf(const GridPoint& a, const GridPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

bool GridHull::build() {
  if (!start()) return false;
  for (std::uint32_t i = 0; i < points_.size(); ++i) add(i);
  return true;
}

/// Which side of the triangle's plane: above 0 means it sees the point.
int GridHull::sideOf(const Triangle& triangle, std::uint32_t point) const {
  const GridPoint& origin = points_[triangle[0]];
  const GridPoint normal = crossOf(between(origin, points_[triangle[1]]), between(origin, points_[triangle[2]]));
  const GridPoint to = between(origin, points_[point]);
  const Wide sum = Wide(normal[0]) * to[0] + Wide(normal[1]) * to[1] + Wide(normal[2]) * to[2];
  return sum > 0 ? 1 : (sum < 0 ? -1 : 0);
}

/// The first tetrahedron that has a volume.
bool GridHull::start() {
  const auto count = static_cast<std::uint32_t>(points_.size());
  std::uint32_t b = 1;
  while (b < count && points_[b] == points_[0]) ++b;
  std::uint32_t c = b + 1;
  const GridPoint nowhere = {0, 0, 0};
  while (c < count && crossOf(between(points_[0], points_[b]), between(points_[0], points_[c])) == nowhere) ++c;
  std::uint32_t d = c + 1;
  while (d < count && sideOf({0, b, c}, d) == 0) ++d;
  if (d >= count) return false;
  if (sideOf({0, b, c}, d) > 0) std::swap(b, c);
  triangles_ = {{0, b, c}, {0, c, d}, {0, d, b}, {b, d, c}};
  return true;
}

/// Replaces the triangles that see the point by a cone over their outline. A point in a triangle's plane is not seen by
/// it, so no new triangle is degenerate: were the point in line with an outline edge, both triangles there would have
/// it in their planes.
void GridHull::add(std::uint32_t point) {
  outline_.clear();
  std::size_t kept = 0;
  for (const Triangle& triangle : triangles_) {
    if (sideOf(triangle, point) <= 0) {
      triangles_[kept++] = triangle;
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) outline_.push_back({triangle[k], triangle[(k + 1) % 3]});
  }
  triangles_.resize(kept);
  std::sort(outline_.begin(), outline_.end());
  for (const DirectedEdge& edge : outline_) {
    const DirectedEdge reversed = {edge.second, edge.first};
    if (!std::binary_search(outline_.begin(), outline_.end(), reversed)) {
      triangles_.push_back({edge.first, edge.second, point});
    }
  }
}

}  // namespace brittle::geometry
