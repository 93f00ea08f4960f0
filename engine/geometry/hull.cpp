// makeHull of make.h: the triangulated hull on a grid, then triangles in one plane become one face.
#include <algorithm>
#include <cmath>
#include <string>

#include "engine/geometry/grid_hull.h"
#include "engine/geometry/make.h"
#include "engine/geometry/make_impl.h"
#include "engine/geometry/split.h"

namespace brittle::geometry {
namespace {

using make_detail::Loops;
constexpr double kCoplanar = 0x1p-20;  // of the extent: triangles this close to a plane belong to one face
constexpr std::uint32_t kNone = 0xffffffff;

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
