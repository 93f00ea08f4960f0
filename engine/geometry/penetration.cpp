#include "engine/geometry/penetration.h"

#include <cmath>
#include <vector>

namespace brittle::geometry {

namespace {

/// An edge with its two faces' outward normals, in A's frame.
struct EdgeLine {
  Vec3d start, along, direction;  // direction is a unit vector
  Vec3d normals[2];
};

/// One of the two convexes, in A's frame and in double.
struct Side {
  std::vector<Vec3d> points, normals;
  std::vector<std::uint32_t>
      refuted;  // per face: which of the other's deep points lie below it by more than the best depth
  std::vector<EdgeLine> edges;
  Vec3d deep[32];  // extreme points met so far: those of this convex that reach deepest into the other
  std::uint32_t deepIndex[32];
  int deepCount = 0;
};

/// Projections nearer to zero than this cannot tell on which side they are: normals are floats.
constexpr double kSideSlack = 1e-6;
/// An edge axis has to beat the faces by this fraction of the depth, so that rounding does not choose between equals.
constexpr double kEdgeSlack = 1e-6;

/// Edges in the plane in which two faces touch have the faces' axis, but for rounding, and need not cross: where their
/// nearest points are further apart than the axis says by this part of the shorter one, they do not touch each other.
constexpr double kBesideSlack = 1e-4;

bool isUnit(const Vec3& normal) {
  const float squared = normal.squaredNorm();
  return squared > 0.99f && squared < 1.01f;
}

std::uint32_t farthest(const std::vector<Vec3d>& points, double x, double y, double z) {
  std::uint32_t best = 0;
  double bestAlong = -1.0e300;
  const auto count = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const double along = (x * points[i].x() + y * points[i].y()) + z * points[i].z();
    if (along > bestAlong) {
      bestAlong = along;
      best = i;
    }
  }
  return best;
}

void addDeep(Side& side, std::uint32_t index) {
  for (int i = 0; i < side.deepCount; ++i)
    if (side.deepIndex[i] == index) return;
  if (side.deepCount == 32) return;
  side.deepIndex[side.deepCount] = index;
  side.deep[side.deepCount++] = side.points[index];
}

class AxisTest {
 public:
  AxisTest(const ConvexView& a, const ConvexView& b, const RelativePose& pose, Side& sideA, Side& sideB)
      : a_(a), b_(b), sideA_(sideA), sideB_(sideB) {
    place(a, RelativePose{}, sideA);
    place(b, pose, sideB);
  }

  Penetration run(std::uint32_t deepA, std::uint32_t deepB, std::uint32_t guess) {
    addDeep(sideB_, deepB);
    addDeep(sideA_, deepA);
    const std::uint32_t first = (guess - 1) / 2;
    if (guess % 2 == 1 && first < a_.faces.size()) testFace(a_, sideA_, sideB_, first);
    if (guess % 2 == 0 && guess > 0 && first < b_.faces.size()) testFace(b_, sideB_, sideA_, first);
    for (std::uint32_t f = 0; f < a_.faces.size(); ++f) testFace(a_, sideA_, sideB_, f);
    for (std::uint32_t f = 0; f < b_.faces.size(); ++f) testFace(b_, sideB_, sideA_, f);
    if (best_.separation < -1.0e299) tryAxis(normalBetween(), sideA_, sideB_, sideA_.points[0]);
    if (!refute(a_, sideA_, sideB_) && !refute(b_, sideB_, sideA_)) {
      collect(a_, sideA_);
      if (!sideA_.edges.empty()) collect(b_, sideB_);
      if (!sideA_.edges.empty()) testEdges();
    }
    best_.normal.normalize();
    return best_;
  }

 private:
  static void place(const ConvexView& convex, const RelativePose& pose, Side& side) {
    side.points.resize(convex.vertices.size());
    side.normals.resize(convex.faces.size());
    side.deepCount = 0;
    for (std::size_t i = 0; i < convex.vertices.size(); ++i) side.points[i] = pose.apply(convex.vertices[i].point);
    for (std::size_t i = 0; i < convex.faces.size(); ++i) side.normals[i] = pose.rotate(convex.faces[i].plane.normal);
  }

  Vec3d normalBetween() const {
    const Vec3d apart = sideB_.points[0] - sideA_.points[0];
    const double length = apart.norm();
    return length > 1e-30 ? Vec3d(apart / length) : Vec3d(0.0, 1.0, 0.0);
  }

  /// Measures an axis that leaves `from` over all vertices and keeps it if it separates better. Returns the extreme
  /// vertex of `to`. Any pair of points bounds the separation from above, so a hopeless axis costs one search.
  std::uint32_t tryAxis(const Vec3d& axis, const Side& from, const Side& to, const Vec3d& onFrom) {
    const std::uint32_t deepest = farthest(to.points, -axis.x(), -axis.y(), -axis.z());
    const double low = to.points[deepest].dot(axis);
    if (low - onFrom.dot(axis) <= best_.separation) return deepest;
    const double separation = low - from.points[farthest(from.points, axis.x(), axis.y(), axis.z())].dot(axis);
    if (separation <= best_.separation) return deepest;
    best_.separation = separation;
    best_.normal = &from == &sideA_ ? axis : Vec3d(-axis);
    // The foot of the deepest vertex on the face.
    const Vec3d foot = to.points[deepest] - separation * axis;
    best_.pointA = &from == &sideA_ ? foot : to.points[deepest];
    best_.pointB = &from == &sideA_ ? to.points[deepest] : foot;
    return deepest;
  }

  /// The axis of one face. The deep points known so far rule out most.
  void testFace(const ConvexView& own, const Side& ownSide, Side& other, std::uint32_t f) {
    const Face& face = own.faces[f];
    const Vec3d& normal = ownSide.normals[f];
    const Vec3d& onFace = ownSide.points[own.edges[face.edge].vertex];
    const double limit = best_.separation + onFace.dot(normal);
    for (int i = 0; i < other.deepCount; ++i)
      if (other.deep[i].dot(normal) <= limit) return;
    if (!isUnit(face.plane.normal)) return;
    const double before = best_.separation;
    addDeep(other, tryAxis(normal, ownSide, other, onFace));
    if (best_.separation > before) best_.axis = 1 + 2 * f + (&ownSide == &sideA_ ? 0 : 1);
  }

  /// On an axis between the normals of two faces of A, A's extreme point is on their edge. If some point of B is below
  /// both faces by at least the depth known so far, it is so for every axis between, and the edge cannot do better:
  /// notes for each face which points of the other are that deep. True: one is that deep inside all faces, which
  /// refutes every edge at once.
  bool refute(const ConvexView& own, Side& ownSide, const Side& other) const {
    ownSide.refuted.resize(own.faces.size());
    const double limit = best_.separation + kEdgeSlack * std::abs(best_.separation);
    std::uint32_t common = ~0u;
    for (std::size_t f = 0; f < own.faces.size(); ++f) {
      const Vec3d& normal = ownSide.normals[f];
      const double offset = ownSide.points[own.edges[own.faces[f].edge].vertex].dot(normal);
      std::uint32_t mask = 0;
      for (int i = 0; i < other.deepCount; ++i)
        if (other.deep[i].dot(normal) - offset <= limit) mask |= 1u << i;
      ownSide.refuted[f] = mask;
      common &= mask;
    }
    return common != 0;
  }

  static void collect(const ConvexView& convex, Side& side) {
    side.edges.clear();
    for (std::uint32_t i = 0; i < convex.edges.size(); ++i) {
      const Edge& edge = convex.edges[i];
      if (edge.opposite < i) continue;
      const Edge& twin = convex.edges[edge.opposite];
      if ((side.refuted[edge.face] & side.refuted[twin.face]) != 0) continue;
      const Vec3d& start = side.points[edge.vertex];
      const Vec3d along = side.points[twin.vertex] - start;
      const double length = along.norm();
      if (length < 1e-30) continue;
      side.edges.push_back({start, along, along / length, {side.normals[edge.face], side.normals[twin.face]}});
    }
  }

  void testEdges() {
    for (const EdgeLine& edgeA : sideA_.edges)
      for (const EdgeLine& edgeB : sideB_.edges)
        if (isFaceOfDifference(edgeA, edgeB)) testEdgePair(edgeA, edgeB);
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
    // A sliver's edge lies between faces whose normals nearly cancel: rounding is all that its own have to say.
    const double outward = axis.dot((a.normals[0] + a.normals[1]) - (b.normals[0] + b.normals[1]));
    if (outward > -kSideSlack) tryEdgeAxis(axis, a, b);
    if (outward < kSideSlack) tryEdgeAxis(-axis, a, b);
  }

  void tryEdgeAxis(const Vec3d& axis, const EdgeLine& a, const EdgeLine& b) {
    if ((b.start - a.start).dot(axis) <= best_.separation + kEdgeSlack * std::abs(best_.separation)) return;
    const Penetration before = best_;
    tryAxis(axis, sideA_, sideB_, a.start);
    if (best_.separation <= before.separation) return;
    nearestOnLines(a, b);
    best_.axis = 0;
    const double apart = (best_.pointB - best_.pointA).norm();
    if (apart > std::abs(best_.separation) + kBesideSlack * minOf(a.along.norm(), b.along.norm())) best_ = before;
  }

  void nearestOnLines(const EdgeLine& a, const EdgeLine& b) {
    const Vec3d apart = a.start - b.start;
    const double cosine = a.direction.dot(b.direction), alongA = a.direction.dot(apart),
                 alongB = b.direction.dot(apart);
    const double s = clampTo((cosine * alongB - alongA) / (1.0 - cosine * cosine), 0.0, a.along.norm());
    const double t = clampTo(cosine * s + alongB, 0.0, b.along.norm());
    best_.pointA = a.start + s * a.direction;
    best_.pointB = b.start + t * b.direction;
  }

  const ConvexView& a_;
  const ConvexView& b_;
  Side& sideA_;
  Side& sideB_;
  Penetration best_;
};

}  // namespace

Penetration leastPenetration(const ConvexView& a, const ConvexView& b, const RelativePose& pose, std::uint32_t deepA,
                             std::uint32_t deepB, std::uint32_t guess) {
  thread_local Side sides[2];
  return AxisTest(a, b, pose, sides[0], sides[1]).run(deepA, deepB, guess);
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
