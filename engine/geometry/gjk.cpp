#include "engine/geometry/gjk.h"

#include <cmath>

#include "engine/geometry/penetration.h"
#include "engine/geometry/simplex.h"

namespace brittle::geometry {

namespace {

constexpr int kMaxIterations = 64;      // random hulls need at most 15 (measured); a cap for whatever else comes
constexpr double kTouching = 1e-8;      // of the scale: nearer than this the axis test takes over
constexpr double kRelativeGap = 1e-11;  // of the squared distance: upper and lower bound agree
constexpr double kRounding = 1e-14;     // of distance * scale: what double can resolve

/// The two cores (radii left out) in A's frame.
struct Pair {
  const Proxy& a;
  const Proxy& b;
  RelativePose pose;

  double radii() const { return static_cast<double>(a.radius) + static_cast<double>(b.radius); }

  SimplexVertex vertex(std::uint32_t indexA, std::uint32_t indexB) const {
    SimplexVertex result;
    result.a = (a.isSphere() ? a.center : a.convex.vertices[indexA].point).cast<double>();
    result.b = pose.apply(b.isSphere() ? b.center : b.convex.vertices[indexB].point);
    result.w = result.a - result.b;
    result.indexA = indexA;
    result.indexB = indexB;
    return result;
  }
  /// The vertex of A - B farthest along `direction`.
  SimplexVertex support(const Vec3d& direction) const;
};

std::uint32_t farthestVertex(const Proxy& proxy, const Vec3d& direction) {
  if (proxy.isSphere()) return 0;
  const double x = direction.x(), y = direction.y(), z = direction.z();
  const Vertex* vertex = proxy.convex.vertices.data();
  const auto count = static_cast<std::uint32_t>(proxy.convex.vertices.size());
  std::uint32_t best = 0;
  double bestAlong = -1.0e300;
  for (std::uint32_t i = 0; i < count; ++i, ++vertex) {
    const float* p = vertex->point.data();
    const double along =
        (x * static_cast<double>(p[0]) + y * static_cast<double>(p[1])) + z * static_cast<double>(p[2]);
    if (along > bestAlong) {
      bestAlong = along;
      best = i;
    }
  }
  return best;
}

SimplexVertex Pair::support(const Vec3d& direction) const {
  Vec3d directionB;
  directionB.noalias() = pose.rotation.transpose() * direction;
  return vertex(farthestVertex(a, direction), farthestVertex(b, -directionB));
}

/// How the search ended: the simplex nearest the origin, and bounds of the distance.
struct Search {
  Simplex simplex;
  Vec3d nearest = Vec3d::Zero();  // of A - B
  double upper = 0.0;             // [m]
  double lower = 0.0;             // [m] of an `apart` one: along `nearest` it is at least that far apart
  bool apart = false;             // known to be further apart than `stopAbove`
  bool overlapping = false;       // the origin is inside, or too near to tell
};

Simplex startOf(const Pair& pair, const SimplexCache& cache) {
  Simplex simplex;
  const std::size_t countA = maxOf<std::size_t>(pair.a.convex.vertices.size(), 1);
  const std::size_t countB = maxOf<std::size_t>(pair.b.convex.vertices.size(), 1);
  for (int i = 0; i < minOf<int>(cache.count, 4); ++i) {
    if (cache.a[i] >= countA || cache.b[i] >= countB) continue;  // the mesh was cut since
    simplex.vertices[simplex.count++] = pair.vertex(cache.a[i], cache.b[i]);
  }
  if (simplex.count == 0) {
    simplex.vertices[0] = pair.vertex(0, 0);
    simplex.count = 1;
  }
  return simplex;
}

bool holds(const Simplex& simplex, const SimplexVertex& vertex) {
  for (int i = 0; i < simplex.count; ++i)
    if (simplex.vertices[i].indexA == vertex.indexA && simplex.vertices[i].indexB == vertex.indexB) return true;
  return false;
}

double sizeOf(const SimplexVertex& vertex) {
  return vertex.w.cwiseAbs().maxCoeff();
}

/// Walks the boundary of A - B towards the origin. Stops early when the distance is known to be above `stopAbove` or at
/// most `stopBelow` [m].
Search search(const Pair& pair, const SimplexCache& cache, double stopAbove, double stopBelow) {
  Search result;
  Simplex& simplex = result.simplex;
  simplex = startOf(pair, cache);
  double scale = 0.0;
  for (int i = 0; i < simplex.count; ++i) scale = maxOf(scale, sizeOf(simplex.vertices[i]));
  double squared = 1.0e300;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    reduceToNearest(simplex);
    result.nearest = simplex.nearest();
    const double before = squared;
    squared = result.nearest.squaredNorm();
    result.upper = std::sqrt(squared);
    result.overlapping = simplex.count == 4 || result.upper <= kTouching * scale;
    if (result.overlapping || result.upper <= stopBelow || squared >= before) return result;
    const SimplexVertex next = pair.support(-result.nearest);
    const double along = result.nearest.dot(next.w);
    if (along > stopAbove * result.upper) {
      result.apart = true;
      result.lower = along / result.upper;
      return result;
    }
    scale = maxOf(scale, sizeOf(next));
    if (squared - along <= kRelativeGap * squared + kRounding * scale * result.upper || holds(simplex, next))
      return result;
    simplex.vertices[simplex.count++] = next;
  }
  return result;
}

void remember(const Simplex& simplex, SimplexCache& cache) {
  cache.count = static_cast<std::uint8_t>(simplex.count);
  for (int i = 0; i < 4; ++i) {  // unused places are zero, so that equal states have equal bytes
    cache.a[i] = i < simplex.count ? static_cast<std::uint16_t>(simplex.vertices[i].indexA) : std::uint16_t{0};
    cache.b[i] = i < simplex.count ? static_cast<std::uint16_t>(simplex.vertices[i].indexB) : std::uint16_t{0};
  }
}

/// Cores that touch or overlap.
Penetration penetrationOf(const Pair& pair, const Simplex& simplex, std::uint32_t guess) {
  if (!pair.a.isSphere() && !pair.b.isSphere())
    return leastPenetration(pair.a.convex, pair.b.convex, pair.pose, simplex.vertices[0].indexA,
                            simplex.vertices[0].indexB, guess);
  if (!pair.a.isSphere()) return pointPenetration(pair.a.convex, pair.pose.apply(pair.b.center));
  Penetration result;
  if (pair.b.isSphere()) {
    result.separation = 0.0;
    result.pointA = result.pointB = pair.a.center.cast<double>();
    return result;
  }
  const Vec3d apart = pair.a.center.cast<double>() - pair.pose.translation;
  const Vec3d centerInB = pair.pose.rotation.transpose() * apart;
  const Penetration seenFromB = pointPenetration(pair.b.convex, centerInB);
  result.separation = seenFromB.separation;
  result.normal = -(pair.pose.rotation * seenFromB.normal);
  result.pointA = pair.a.center.cast<double>();
  result.pointB = result.pointA + result.separation * result.normal;
  return result;
}

/// Whether the two overlap along the normal of a face, numbered as in SimplexCache.
bool overlapsAlong(const Pair& pair, std::uint32_t axis) {
  if (axis == 0 || pair.a.isSphere() || pair.b.isSphere()) return false;
  const bool ofA = axis % 2 == 1;
  const ConvexView& own = (ofA ? pair.a : pair.b).convex;
  const std::uint32_t face = (axis - 1) / 2;
  if (face >= own.faces.size()) return false;  // the mesh was cut since
  const Vec3& corner = own.startOf(own.faces[face].edge);
  const Vec3d onFace = ofA ? Vec3d(corner.cast<double>()) : pair.pose.apply(corner);
  const Vec3d normal = own.faces[face].plane.normal.cast<double>();
  const Vec3d outward = ofA ? normal : Vec3d(pair.pose.rotation * normal);
  const SimplexVertex deepest = pair.support(ofA ? outward : Vec3d(-outward));
  return outward.dot((ofA ? deepest.b : deepest.a) - onFace) < 0.0;
}

/// What overlapped when it was last seen mostly does still: then the axes are tested at once, without a search for a
/// distance that is not there. False: not known whether they overlap.
bool isStillOverlapping(const Pair& pair, const SimplexCache& cache, Penetration& core) {
  if (!overlapsAlong(pair, cache.axis)) return false;
  const std::uint32_t deepA = cache.a[0] < pair.a.convex.vertices.size() ? cache.a[0] : 0;
  const std::uint32_t deepB = cache.b[0] < pair.b.convex.vertices.size() ? cache.b[0] : 0;
  core = leastPenetration(pair.a.convex, pair.b.convex, pair.pose, deepA, deepB, cache.axis);
  return core.separation < 0.0;
}

/// The closest points of the surfaces, in A's frame. None of a pair further apart than `stopAbove`.
Penetration closestOf(const Pair& pair, SimplexCache& cache, float stopAbove) {
  Penetration core;
  if (isStillOverlapping(pair, cache, core)) {
    cache.axis = core.axis;
    return core;
  }
  core = {};
  // A millionth more, so that what is found to be further apart still is after rounding to float.
  const Search found = search(pair, cache, (static_cast<double>(stopAbove) + pair.radii()) * (1.0 + 1e-6), 0.0);
  remember(found.simplex, cache);
  if (!found.overlapping) cache.axis = 0;
  if (found.apart) {
    core.separation = found.lower;
    core.normal = found.nearest / -found.upper;
  } else if (found.overlapping) {
    core = penetrationOf(pair, found.simplex, cache.axis);
    cache.axis = core.axis;
  } else {
    core.separation = found.upper;
    core.normal = found.nearest / -found.upper;
    core.pointA.setZero();
    for (int i = 0; i < found.simplex.count; ++i) core.pointA += found.simplex.weights[i] * found.simplex.vertices[i].a;
    core.pointB = core.pointA - found.nearest;
  }
  core.separation -= pair.radii();
  core.pointA += static_cast<double>(pair.a.radius) * core.normal;
  core.pointB -= static_cast<double>(pair.b.radius) * core.normal;
  return core;
}

}  // namespace

Separation separation(const Proxy& a, const Proxy& b, const RelativePose& pose, SimplexCache& cache, float stopAbove) {
  const Penetration closest = closestOf({a, b, pose}, cache, stopAbove);
  return {static_cast<float>(closest.separation), closest.normal.cast<float>(), closest.pointA.cast<float>(),
          closest.pointB.cast<float>()};
}

Separation separation(const Proxy& a, const Transform& poseA, const Proxy& b, const Transform& poseB,
                      SimplexCache& cache, float stopAbove) {
  const Penetration closest = closestOf({a, b, relativePose(poseA, poseB)}, cache, stopAbove);
  const Mat3d turn = rotationMatrix(poseA.rotation);
  const Vec3d origin = poseA.position.cast<double>();
  Separation result;
  result.distance = static_cast<float>(closest.separation);
  result.normal = (turn * closest.normal).cast<float>();
  result.pointA = (turn * closest.pointA + origin).cast<float>();
  result.pointB = (turn * closest.pointB + origin).cast<float>();
  return result;
}

bool overlaps(const Proxy& a, const Transform& poseA, const Proxy& b, const Transform& poseB, float margin) {
  const Pair pair{a, b, relativePose(poseA, poseB)};
  const double reach = pair.radii() + static_cast<double>(margin);
  const Search found = search(pair, SimplexCache{}, reach, reach);
  return !found.apart && (found.overlapping || found.upper <= reach);
}

}  // namespace brittle::geometry
