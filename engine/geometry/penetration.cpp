#include "engine/geometry/penetration.h"

#include <cmath>
#include <vector>

namespace brittle::geometry {

namespace {

struct Box {
  Vec3d low = Vec3d::Constant(1.0e300), high = Vec3d::Constant(-1.0e300);
  void include(const Vec3d& point) {
    for (int i = 0; i < 3; ++i) {
      low[i] = minOf(low[i], point[i]);
      high[i] = maxOf(high[i], point[i]);
    }
  }
  /// Whether the box of the segment comes within `distance`.
  bool isNear(const Vec3d& p, const Vec3d& q, double distance) const {
    for (int i = 0; i < 3; ++i)
      if (minOf(p[i], q[i]) > high[i] + distance || maxOf(p[i], q[i]) < low[i] - distance) return false;
    return true;
  }
};

/// An edge with its two faces' outward normals, in A's frame.
struct EdgeLine {
  Vec3d start, end, direction;  // direction is a unit vector
  Vec3d normals[2];
};

struct Scratch {
  std::vector<Vec3d> pointsA, pointsB;
  std::vector<EdgeLine> edgesA, edgesB;
};

/// Projections nearer to zero than this cannot tell on which side they are: normals are floats.
constexpr double kSideSlack = 1e-6;

std::uint32_t farthest(const std::vector<Vec3d>& points, const Vec3d& direction) {
  std::uint32_t best = 0;
  double bestAlong = points[0].dot(direction);
  for (std::uint32_t i = 1; i < points.size(); ++i) {
    const double along = points[i].dot(direction);
    if (along > bestAlong) {
      bestAlong = along;
      best = i;
    }
  }
  return best;
}

bool isUnit(const Vec3& normal) {
  const float squared = normal.squaredNorm();
  return squared > 0.9f && squared < 1.1f;
}

class AxisTest {
 public:
  AxisTest(const ConvexView& a, const ConvexView& b, const RelativePose& pose, Scratch& scratch) : a_(a), b_(b), pose_(pose), scratch_(scratch) {
    scratch.pointsA.resize(a.vertices.size());
    scratch.pointsB.resize(b.vertices.size());
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
      scratch.pointsA[i] = a.vertices[i].point.cast<double>();
      boxA_.include(scratch.pointsA[i]);
    }
    for (std::size_t i = 0; i < b.vertices.size(); ++i) {
      scratch.pointsB[i] = pose.apply(b.vertices[i].point);
      boxB_.include(scratch.pointsB[i]);
    }
  }

  Penetration run(std::uint32_t deepA, std::uint32_t deepB) {
    testFaces(deepA, deepB);
    if (best_.separation < -1.0e299) tryAxis(normalBetween(), deepA, deepB);
    testEdges();
    return best_;
  }

 private:
  Vec3d normalBetween() const {
    const Vec3d apart = (boxB_.low + boxB_.high) - (boxA_.low + boxA_.high);
    const double length = apart.norm();
    return length > 1e-30 ? Vec3d(apart / length) : Vec3d(0.0, 1.0, 0.0);
  }

  /// Measures the axis over all vertices; keeps it if it separates better. deepA and deepB become the extreme vertices.
  bool tryAxis(const Vec3d& axis, std::uint32_t& deepA, std::uint32_t& deepB) {
    deepB = farthest(scratch_.pointsB, -axis);
    const double low = scratch_.pointsB[deepB].dot(axis);
    if (low - scratch_.pointsA[deepA].dot(axis) <= best_.separation) return false;
    deepA = farthest(scratch_.pointsA, axis);
    const double separation = low - scratch_.pointsA[deepA].dot(axis);
    if (separation <= best_.separation) return false;
    best_.separation = separation;
    best_.normal = axis;
    return true;
  }

  /// Any pair of points gives an upper bound of an axis' separation, so the extreme vertices of the best axis so far rule out
  /// most others at the cost of one projection.
  void testFaces(std::uint32_t deepA, std::uint32_t deepB) {
    for (const Face& face : a_.faces) {
      if (!isUnit(face.plane.normal)) continue;
      const Vec3d axis = face.plane.normal.cast<double>().normalized();
      if ((scratch_.pointsB[deepB] - scratch_.pointsA[a_.edges[face.edge].vertex]).dot(axis) <= best_.separation) continue;
      if (!tryAxis(axis, deepA, deepB)) continue;
      best_.pointB = scratch_.pointsB[deepB];
      best_.pointA = best_.pointB - best_.separation * axis;
    }
    for (const Face& face : b_.faces) {
      if (!isUnit(face.plane.normal)) continue;
      const Vec3d axis = -pose_.rotate(face.plane.normal).normalized();
      if ((scratch_.pointsB[b_.edges[face.edge].vertex] - scratch_.pointsA[deepA]).dot(axis) <= best_.separation) continue;
      if (!tryAxis(axis, deepA, deepB)) continue;
      best_.pointA = scratch_.pointsA[deepA];
      best_.pointB = best_.pointA + best_.separation * axis;
    }
  }

  /// On the axis of least depth the two touch after moving by that depth, in points of the two edges: so each edge comes within
  /// the depth known so far of the other convex. For shallow overlaps this leaves a handful of edges.
  void testEdges() {
    const double depth = maxOf(-best_.separation, 0.0);
    collect(a_, Mat3d::Identity(), scratch_.pointsA, boxB_, depth, scratch_.edgesA);
    if (scratch_.edgesA.empty()) return;
    collect(b_, pose_.rotation, scratch_.pointsB, boxA_, depth, scratch_.edgesB);
    for (const EdgeLine& edgeA : scratch_.edgesA)
      for (const EdgeLine& edgeB : scratch_.edgesB)
        if (isFaceOfDifference(edgeA, edgeB)) testEdgePair(edgeA, edgeB);
  }

  static void collect(const ConvexView& convex, const Mat3d& turn, const std::vector<Vec3d>& points, const Box& other, double depth,
                      std::vector<EdgeLine>& edges) {
    edges.clear();
    for (std::uint32_t i = 0; i < convex.edges.size(); ++i) {
      const Edge& edge = convex.edges[i];
      if (edge.opposite < i) continue;
      const Edge& twin = convex.edges[edge.opposite];
      const Vec3d& start = points[edge.vertex];
      const Vec3d& end = points[twin.vertex];
      if (!other.isNear(start, end, depth)) continue;
      const Vec3d along = end - start;
      const double length = along.norm();
      if (length < 1e-30) continue;
      EdgeLine& line = edges.emplace_back();
      line.start = start;
      line.end = end;
      line.direction = along / length;
      line.normals[0].noalias() = turn * convex.faces[edge.face].plane.normal.cast<double>();
      line.normals[1].noalias() = turn * convex.faces[twin.face].plane.normal.cast<double>();
    }
  }

  /// Only edge pairs whose arcs cross on the Gauss map (A's, and B's mirrored) make a face of the Minkowski difference.
  static bool isFaceOfDifference(const EdgeLine& a, const EdgeLine& b) {
    const double c = -b.normals[0].dot(a.direction), d = -b.normals[1].dot(a.direction);
    if ((c > kSideSlack && d > kSideSlack) || (c < -kSideSlack && d < -kSideSlack)) return false;
    const double e = a.normals[0].dot(b.direction), f = a.normals[1].dot(b.direction);
    if ((e > kSideSlack && f > kSideSlack) || (e < -kSideSlack && f < -kSideSlack)) return false;
    return c * f > -kSideSlack;
  }

  void testEdgePair(const EdgeLine& a, const EdgeLine& b) {
    Vec3d axis = a.direction.cross(b.direction);
    const double sine = axis.norm();
    if (sine < 1e-6) return;  // parallel: a face's normal or another pair has the axis
    axis /= sine;
    if (axis.dot(a.normals[0] + a.normals[1]) < 0.0) axis = -axis;
    if ((b.start - a.start).dot(axis) <= best_.separation + kSlackOfFaces * maxOf(-best_.separation, 0.0)) return;
    std::uint32_t deepA = 0, deepB = 0;
    if (!tryAxis(axis, deepA, deepB)) return;
    nearestOnLines(a, b);
  }

  void nearestOnLines(const EdgeLine& a, const EdgeLine& b) {
    const Vec3d apart = a.start - b.start;
    const double cosine = a.direction.dot(b.direction), alongA = a.direction.dot(apart), alongB = b.direction.dot(apart);
    const double lengthA = (a.end - a.start).norm(), lengthB = (b.end - b.start).norm();
    const double s = clampTo((cosine * alongB - alongA) / (1.0 - cosine * cosine), 0.0, lengthA);
    const double t = clampTo(cosine * s + alongB, 0.0, lengthB);
    best_.pointA = a.start + s * a.direction;
    best_.pointB = b.start + t * b.direction;
  }

  /// An edge axis has to beat the faces by this fraction of the depth, so that rounding does not choose between equals.
  static constexpr double kSlackOfFaces = 1e-6;

  const ConvexView& a_;
  const ConvexView& b_;
  const RelativePose& pose_;
  Scratch& scratch_;
  Box boxA_, boxB_;
  Penetration best_;
};

}  // namespace

Penetration leastPenetration(const ConvexView& a, const ConvexView& b, const RelativePose& pose, std::uint32_t deepA,
                             std::uint32_t deepB) {
  thread_local Scratch scratch;
  return AxisTest(a, b, pose, scratch).run(deepA, deepB);
}

Penetration pointPenetration(const ConvexView& a, const Vec3d& point) {
  Penetration best;
  for (const Face& face : a.faces) {
    if (!isUnit(face.plane.normal)) continue;
    const Vec3d axis = face.plane.normal.cast<double>().normalized();
    const double separation = (point - a.startOf(face.edge).cast<double>()).dot(axis);
    if (separation <= best.separation) continue;
    best.separation = separation;
    best.normal = axis;
  }
  if (best.separation < -1.0e299) best.separation = 0.0;
  best.pointB = point;
  best.pointA = point - best.separation * best.normal;
  return best;
}

}  // namespace brittle::geometry
