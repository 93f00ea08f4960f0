// The convex hull of points: makeHull of make.h. Points are put on a grid of 2^24 steps along their extent, on which
// every sign is computed exactly, so the triangulated hull is a closed mesh whatever the points. Then triangles in one
// plane become one face. Incremental: each point replaces the triangles that see it by a cone over their outline.
// Quadratic, meant for loading. Source: Clarkson and Shor, Applications of Random Sampling in Computational Geometry,
// II, 1989 (without their randomness).
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/geometry/make.h"
#include "engine/geometry/make_impl.h"
#include "engine/geometry/split.h"

namespace brittle::geometry {
namespace {

using make_detail::Loops;
__extension__ typedef __int128 Wide;
using GridPoint = std::array<std::int64_t, 3>;
using Triangle = std::array<std::uint32_t, 3>;

constexpr double kGridSteps = 0x1p24;  // differences have 25 bits, determinants 78: exact in Wide
constexpr double kCoplanar = 0x1p-20;  // of the extent: triangles this close to a plane belong to one face
constexpr std::uint32_t kNone = 0xffffffff;

GridPoint between(const GridPoint& a, const GridPoint& b) {
  return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

GridPoint crossOf(const GridPoint& a, const GridPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The triangulated hull of grid points.
class GridHull {
 public:
  explicit GridHull(std::vector<GridPoint> points) : points_(std::move(points)) {}

  /// False if all points lie in one plane.
  bool build() {
    if (!start()) return false;
    for (std::uint32_t i = 0; i < points_.size(); ++i) add(i);
    return true;
  }
  const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
  /// Which side of the triangle's plane: above 0 means it sees the point.
  int sideOf(const Triangle& triangle, std::uint32_t point) const {
    const GridPoint& origin = points_[triangle[0]];
    const GridPoint normal = crossOf(between(origin, points_[triangle[1]]), between(origin, points_[triangle[2]]));
    const GridPoint to = between(origin, points_[point]);
    const Wide sum = Wide(normal[0]) * to[0] + Wide(normal[1]) * to[1] + Wide(normal[2]) * to[2];
    return sum > 0 ? 1 : (sum < 0 ? -1 : 0);
  }

  bool start() {
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

  void add(std::uint32_t point) {
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

  using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<GridPoint> points_;
  std::vector<Triangle> triangles_;
  std::vector<DirectedEdge> outline_;
};

struct Bounds {
  Vec3d low;
  double extent = 0.0;
  double reach = 0.0;  // largest coordinate
};

Bounds boundsOf(std::span<const Vec3> points) {
  Bounds bounds;
  bounds.low = points[0].cast<double>();
  Vec3d high = bounds.low;
  for (const Vec3& point : points) {
    for (int i = 0; i < 3; ++i) {
      const double coordinate = point[i];
      bounds.low[i] = minOf(bounds.low[i], coordinate);
      high[i] = maxOf(high[i], coordinate);
      bounds.reach = maxOf(bounds.reach, std::abs(coordinate));
    }
  }
  for (int i = 0; i < 3; ++i) bounds.extent = maxOf(bounds.extent, high[i] - bounds.low[i]);
  return bounds;
}

std::vector<GridPoint> onGrid(std::span<const Vec3> points, const Bounds& bounds) {
  std::vector<GridPoint> grid;
  grid.reserve(points.size());
  for (const Vec3& point : points) {
    GridPoint at;
    for (int i = 0; i < 3; ++i) {
      const double steps = (point[i] - bounds.low[i]) * (kGridSteps / bounds.extent);
      at[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::floor(steps + 0.5));
    }
    grid.push_back(at);
  }
  return grid;
}

/// A convex from loops over `points`; only the points used become vertices, in their order. False if it is not a valid
/// mesh.
bool assemble(std::span<const Vec3> points, Loops loops, Convex& convex) {
  std::vector<std::uint32_t> vertexOf(points.size(), kNone);
  for (const std::uint32_t corner : loops.corners) vertexOf[corner] = 0;
  convex.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (vertexOf[i] == kNone) continue;
    vertexOf[i] = static_cast<std::uint32_t>(convex.vertices.size());
    convex.vertices.push_back({points[i]});
  }
  for (std::uint32_t& corner : loops.corners) corner = vertexOf[corner];
  if (!make_detail::linkLoops(loops, convex) || findTopologyError(convex.view()) != nullptr) return false;
  make_detail::fitPlanes(convex);
  return true;
}

/// Normal of a triangle, as long as twice its area.
Vec3d doubleAreaOf(const Convex& triangles, std::uint32_t face) {
  const ConvexView view = triangles.view();
  const std::uint32_t edge = triangles.faces[face].edge;
  const Vec3d origin = view.startOf(edge).cast<double>();
  const Vec3d b = view.endOf(edge).cast<double>() - origin;
  const Vec3d c = view.endOf(triangles.edges[edge].next).cast<double>() - origin;
  return b.cross(c);
}

/// Merges triangles into faces: the largest triangle first, each takes the neighbours that lie in its plane.
class Merger {
 public:
  Merger(const Convex& triangles, double tolerance) : mesh_(triangles), tolerance_(tolerance) {}

  /// The faces' loops over the mesh's vertices, without those that are left with two edges. False if a face is not one
  /// loop.
  bool merge(Loops& loops) {
    group();
    std::vector<std::uint32_t> degree(mesh_.vertices.size(), 0);
    std::uint32_t outer = 0;
    for (std::uint32_t edge = 0; edge < mesh_.edges.size(); ++edge) {
      if (!isOuter(edge)) continue;
      ++outer;
      ++degree[mesh_.edges[edge].vertex];
    }
    std::vector<bool> isDone(groupCount_, false);
    for (std::uint32_t edge = 0; edge < mesh_.edges.size(); ++edge) {
      const std::uint32_t face = groupOf_[mesh_.edges[edge].face];
      if (!isOuter(edge) || isDone[face]) continue;
      isDone[face] = true;
      std::uint32_t walked = edge;
      do {
        const std::uint32_t vertex = mesh_.edges[walked].vertex;
        if (degree[vertex] > 2) loops.corners.push_back(vertex);
        walked = nextOuter(walked);
        --outer;
      } while (walked != edge);
      loops.close();
      if (loops.corners.size() < loops.starts[loops.count() - 1] + 3) return false;
    }
    return outer == 0;
  }

 private:
  bool isOuter(std::uint32_t edge) const {
    return groupOf_[mesh_.edges[edge].face] != groupOf_[mesh_.edges[mesh_.edges[edge].opposite].face];
  }
  std::uint32_t nextOuter(std::uint32_t edge) const {
    std::uint32_t next = mesh_.edges[edge].next;
    while (!isOuter(next)) next = mesh_.edges[mesh_.edges[next].opposite].next;
    return next;
  }
  void group() {
    const auto count = static_cast<std::uint32_t>(mesh_.faces.size());
    std::vector<std::pair<double, std::uint32_t>> byArea;
    for (std::uint32_t i = 0; i < count; ++i) byArea.push_back({-doubleAreaOf(mesh_, i).squaredNorm(), i});
    std::sort(byArea.begin(), byArea.end());
    groupOf_.assign(count, kNone);
    std::vector<std::uint32_t> pending;
    for (const auto& [area, seed] : byArea) {
      if (groupOf_[seed] != kNone) continue;
      const std::uint32_t group = groupCount_++;
      groupOf_[seed] = group;
      pending.assign(1, seed);
      while (!pending.empty()) {
        const std::uint32_t face = pending.back();
        pending.pop_back();
        std::uint32_t edge = mesh_.faces[face].edge;
        for (int k = 0; k < 3; ++k, edge = mesh_.edges[edge].next) {
          const std::uint32_t across = mesh_.edges[mesh_.edges[edge].opposite].face;
          if (groupOf_[across] != kNone || !liesIn(across, seed)) continue;
          groupOf_[across] = group;
          pending.push_back(across);
        }
      }
    }
  }

  bool liesIn(std::uint32_t face, std::uint32_t seed) const {
    const ConvexView view = mesh_.view();
    const Vec3d normal = doubleAreaOf(mesh_, seed).normalized();
    const Vec3d origin = view.startOf(mesh_.faces[seed].edge).cast<double>();
    std::uint32_t edge = mesh_.faces[face].edge;
    for (int k = 0; k < 3; ++k, edge = mesh_.edges[edge].next) {
      const Vec3d to = view.startOf(edge).cast<double>() - origin;
      if (std::abs(normal.dot(to)) > tolerance_) return false;
    }
    return true;
  }

  const Convex& mesh_;
  double tolerance_;
  std::vector<std::uint32_t> groupOf_;
  std::uint32_t groupCount_ = 0;
};

/// How far the points reach below the largest triangle, whose normal is the surest.
double thicknessOf(const Convex& triangles) {
  Vec3d normal = Vec3d::Zero();
  Vec3d origin = Vec3d::Zero();
  for (std::uint32_t face = 0; face < triangles.faces.size(); ++face) {
    const Vec3d doubleArea = doubleAreaOf(triangles, face);
    if (!(doubleArea.squaredNorm() > normal.squaredNorm())) continue;
    normal = doubleArea;
    origin = triangles.view().startOf(triangles.faces[face].edge).cast<double>();
  }
  normal.normalize();
  double depth = 0.0;
  for (const Vertex& vertex : triangles.vertices) {
    const Vec3d to = origin - vertex.point.cast<double>();
    depth = maxOf(depth, normal.dot(to));
  }
  return depth;
}

}  // namespace

Result<Convex> makeHull(std::span<const Vec3> points) {
  const std::string given = " (" + std::to_string(points.size()) + " points given)";
  if (points.size() < 4) return Error{"a hull needs at least 4 points" + given};
  for (const Vec3& point : points) {
    if (!isFinite(point)) return Error{"a hull's points must be finite" + given};
  }
  const Bounds bounds = boundsOf(points);
  const Error flat = {"a hull's points must not lie in one plane" + given};
  if (!(bounds.extent > 0.0)) return flat;
  GridHull hull(onGrid(points, bounds));
  if (!hull.build()) return flat;
  Loops loops;
  for (const Triangle& triangle : hull.triangles()) {
    loops.corners.insert(loops.corners.end(), triangle.begin(), triangle.end());
    loops.close();
  }
  Convex triangulated;
  if (!assemble(points, loops, triangulated)) return Error{"a hull has more edges than 16 bits count" + given};
  if (thicknessOf(triangulated) < kMinThickness * bounds.extent) return flat;

  std::vector<Vec3> corners;
  for (const Vertex& vertex : triangulated.vertices) corners.push_back(vertex.point);
  Loops merged;
  Convex convex;
  const double tolerance = maxOf(kCoplanar * bounds.extent, 0.5 * kCoplanar * bounds.reach);
  // A triangulated sphere is always 3-connected. Should merging spoil that, the triangles stand.
  if (Merger(triangulated, tolerance).merge(merged) && assemble(corners, merged, convex)) return convex;
  return triangulated;
}

}  // namespace brittle::geometry
