#include "engine/physics/manifold.h"

#include <cmath>

#include "engine/geometry/clip.h"
#include "engine/physics/manifold_points.h"

namespace brittle::physics {

namespace {

using geometry::Proxy;
using geometry::RelativePose;
using geometry::Separation;

// Cosines between a face's normal and the direction of least distance. Chosen: 11 degrees is where two facing faces
// still touch like faces; the exact one only forgives rounding.
constexpr float kFacing = 0.98f;
constexpr float kExactlyFacing = 0.99999f;
constexpr float kPreferA = 1e-6f;    // of two equally good faces A's is the reference, so that the normal does not flip
constexpr float kNear = 0.25f;       // of the size: closer than this counts as touching [-]
constexpr float kDepthBand = 0.02f;  // of the size: depths within it are equal [-]
constexpr float kBesideFace =
    0.5f;  // of the size: corners that are this near the deepest point count beside the face's [-]
constexpr float kMergeRadius = 0.2f;  // of the size: a new point this near an old one replaces it (incremental) [-]
constexpr float kMaxDrift = 0.25f;    // of the size: sideways drift after which a point is dropped (incremental) [-]
constexpr float kTooDeep = 0.1f;      // of the size: overlaps deeper than this get all points at once (incremental) [-]
constexpr float kMaxTurn = 0.035f;    // two degrees: recompute after that [rad]
constexpr float kUnknownReach = -1.0f;

struct Scratch {
  std::vector<Vec3> reference, polygon, clip;
  std::vector<Plane> sides;  // of the reference face
  std::vector<Candidate> candidates;
};

Scratch& scratch() {
  thread_local Scratch instance;
  return instance;
}

/// The pair of one update, seen from A.
struct View {
  const Proxy& a;
  const Proxy& b;
  Transform poseA, poseB;
  RelativePose pose;  // B seen from A
  float size;         // the smaller inner radius [m]
  float margin;       // [m]

  Vec3 toA(const Vec3& localB) const { return pose.apply(localB).cast<float>(); }
  Vec3 toB(const Vec3& localA) const {
    return (pose.rotation.transpose() * (localA.cast<double>() - pose.translation)).cast<float>();
  }
  Vec3 directionToB(const Vec3& localA) const {
    return (pose.rotation.transpose() * localA.cast<double>()).cast<float>();
  }
};

/// Separations along the kept normal, in A's frame. False if a point is beyond the margin by now.
bool refresh(const View& view, Manifold& manifold) {
  manifold.normal = (manifold.normalOfB ? view.poseB : view.poseA).rotate(manifold.localNormal);
  const Vec3d normal =
      manifold.normalOfB ? view.pose.rotate(manifold.localNormal) : Vec3d(manifold.localNormal.cast<double>());
  for (int i = 0; i < manifold.count; ++i) {
    ManifoldPoint& point = manifold.points[i];
    point.separation = static_cast<float>(normal.dot(view.pose.apply(point.localB) - point.localA.cast<double>()));
    if (point.separation > view.margin) return false;
  }
  return true;
}

float reachFrom(const Proxy& proxy, const Vec3& local) {
  float squared = 0.0f;
  for (const geometry::Vertex& vertex : proxy.convex.vertices)
    squared = maxOf(squared, (vertex.point - local).squaredNorm());
  return std::sqrt(squared);
}

/// Measured when it is first asked for: most contacts of things that tumble never live that long.
float reachOf(const View& view, Manifold& manifold) {
  if (manifold.reach < 0.0f)
    manifold.reach = minOf(reachFrom(view.a, manifold.points[0].localA), reachFrom(view.b, manifold.points[0].localB));
  return manifold.reach;
}

/// True while no vertex near the contact has moved by more than the recycling distance since the points were computed.
bool hardlyMoved(const View& view, const ManifoldSettings& settings, Manifold& manifold) {
  if (!manifold.computed || manifold.count == 0) return false;
  const float limit = settings.recycleDistance * view.size;
  if (view.margin > manifold.computedMargin + limit) return false;
  const Quat relative = view.poseA.rotation.conjugate() * view.poseB.rotation;
  const float turn = 2.0f * (relative * manifold.computedAt.rotation.conjugate()).vec().norm();
  if (turn > kMaxTurn) return false;
  const Vec3& point = manifold.points[0].localB;
  const float moved = (view.toA(point) - manifold.computedAt.toWorld(point)).norm();
  return moved < limit && moved + turn * reachOf(view, manifold) < limit;
}

/// The corners of a face in A's frame, relative to `origin` (so that rounding is relative to the contact, not to the
/// frame).
void cornersOf(const geometry::ConvexView& convex, std::uint32_t face, const RelativePose& pose, const Vec3d& origin,
               std::vector<Vec3>& corners) {
  corners.clear();
  const std::uint32_t first = convex.faces[face].edge;
  std::uint32_t edge = first;
  do {
    corners.push_back((pose.apply(convex.startOf(edge)) - origin).cast<float>());
    edge = convex.edges[edge].next;
  } while (edge != first);
}

void addCandidate(const Vec3& corner, const Vec3& normal, float separation, float sign, Scratch& s) {
  const Vec3 foot = corner - separation * normal;
  if (sign > 0.0f)
    s.candidates.push_back({foot, corner, separation});
  else
    s.candidates.push_back({corner, foot, separation});
}

/// Clips the incident face by the sides of the reference face. Points are relative to `origin`; `normal` points out of
/// the reference face, `sign` is 1 if that face is A's.
void clipFaces(const Vec3& normal, float sign, const View& view, Scratch& s) {
  s.sides.clear();
  for (std::size_t i = 0; i < s.reference.size(); ++i) {
    const Vec3& start = s.reference[i];
    const Vec3 outward = (s.reference[(i + 1) % s.reference.size()] - start).cross(normal);
    const float length = outward.norm();
    if (length > 1e-20f) s.sides.push_back(planeThrough(start, outward / length));
  }
  for (const Plane& side : s.sides) geometry::clipPolygon(side, s.clip, s.polygon);
  for (const Vec3& corner : s.polygon) {
    const float separation = normal.dot(corner - s.reference[0]);
    if (separation <= view.margin) addCandidate(corner, normal, separation, sign, s);
  }
}

/// Corners beside the incident face that are about as deep as it: a shard whose underside is folded would else rock
/// from facet to facet, each with its own three points.
void addCornersBeside(const geometry::ConvexView& incident, const RelativePose& pose, const Vec3d& origin,
                      const Vec3& normal, float sign, const View& view, Scratch& s) {
  float deepest = view.margin;
  for (const Candidate& candidate : s.candidates) deepest = minOf(deepest, candidate.separation);
  const float limit = minOf(view.margin, deepest + kBesideFace * view.size);
  const std::size_t known = s.candidates.size();
  // Most vertices are far off: one product each, in their own frame, says so.
  const Vec3d along = pose.rotation.transpose() * normal.cast<double>();
  const double offset = normal.cast<double>().dot(pose.translation - origin - s.reference[0].cast<double>());
  for (const geometry::Vertex& vertex : incident.vertices) {
    const auto separation = static_cast<float>(along.dot(vertex.point.cast<double>()) + offset);
    if (separation > limit) continue;
    const Vec3 corner = (pose.apply(vertex.point) - origin).cast<float>();
    bool counts = true;
    for (const Plane& side : s.sides) counts = counts && side.distance(corner) <= 0.0f;
    for (std::size_t i = 0; i < known && counts; ++i)
      counts = (sign > 0.0f ? s.candidates[i].onB : s.candidates[i].onA) != corner;
    if (counts) addCandidate(corner, normal, separation, sign, s);
  }
}

enum class Reference { None, OfA, OfB };  // whose face gives the normal

/// Candidates of two facing faces, and the normal in A's frame. Leaves both alone if no face faces the other shape.
Reference facePoints(const View& view, const Separation& closest, Scratch& s, Vec3& normal) {
  const Vec3d origin = closest.pointA.cast<double>();
  const Vec3 towardsA = view.directionToB(Vec3(-closest.normal));
  const std::uint32_t faceA = geometry::supportFace(view.a.convex, closest.normal);
  const std::uint32_t faceB = geometry::supportFace(view.b.convex, towardsA);
  const float alongA = view.a.convex.faces[faceA].plane.normal.dot(closest.normal);
  const float alongB = view.b.convex.faces[faceB].plane.normal.dot(towardsA);
  const bool ofB = alongB > alongA + kPreferA;
  const float along = ofB ? alongB : alongA;
  if (along < (closest.distance <= kNear * view.size ? kFacing : kExactlyFacing)) return Reference::None;
  RelativePose own;
  cornersOf(view.a.convex, faceA, own, origin, ofB ? s.polygon : s.reference);
  cornersOf(view.b.convex, faceB, view.pose, origin, ofB ? s.reference : s.polygon);
  const Vec3 outward = ofB ? Vec3(view.pose.rotate(view.b.convex.faces[faceB].plane.normal).cast<float>())
                           : view.a.convex.faces[faceA].plane.normal;
  const float sign = ofB ? -1.0f : 1.0f;
  clipFaces(outward, sign, view, s);
  if (ofB)
    addCornersBeside(view.a.convex, own, origin, outward, sign, view, s);
  else
    addCornersBeside(view.b.convex, view.pose, origin, outward, sign, view, s);
  normal = ofB ? Vec3(-outward) : outward;
  return ofB ? Reference::OfB : Reference::OfA;
}

void setPoints(const View& view, const Vec3& origin, const Scratch& s, Manifold& manifold) {
  manifold.count = static_cast<std::int32_t>(minOf<std::size_t>(s.candidates.size(), kMaxPoints));
  for (int i = 0; i < manifold.count; ++i) {
    const Candidate& candidate = s.candidates[i];
    ManifoldPoint& point = manifold.points[i];
    point.localA = candidate.onA + origin;
    point.localB = view.toB(Vec3(candidate.onB + origin));
    point.separation = candidate.separation;
    point.normalImpulse = candidate.normalImpulse;
  }
}

float spreadOf(const Manifold& manifold) {
  float squared = 0.0f;
  for (int i = 1; i < manifold.count; ++i)
    squared = maxOf(squared, (manifold.points[i].localA - manifold.points[0].localA).squaredNorm());
  return std::sqrt(squared);
}

/// All points at once. Spheres, edges and corners give the one closest point.
void clipAll(const View& view, const Separation& closest, Manifold& manifold) {
  Scratch& s = scratch();
  s.candidates.clear();
  const ManifoldPoint old[kMaxPoints] = {manifold.points[0], manifold.points[1], manifold.points[2],
                                         manifold.points[3]};
  const int oldCount = manifold.count;
  Vec3 normal = closest.normal;
  const bool ball = view.a.isSphere() || view.b.isSphere();
  const Reference reference = ball ? Reference::None : facePoints(view, closest, s, normal);
  const bool faces = reference != Reference::None;
  // The closest point itself, unless the faces hold one as deep: the deepest corner need not belong to the face that
  // faces A.
  const Vec3 apart = closest.pointB - closest.pointA;
  const float separation = faces ? normal.dot(apart) : closest.distance;
  bool found = false;
  for (const Candidate& candidate : s.candidates)
    found = found || candidate.separation <= separation + kDepthBand * view.size;
  if (!found) s.candidates.push_back({Vec3::Zero(), apart, separation});
  reducePoints(normal, kDepthBand * view.size, s.candidates);
  setPoints(view, closest.pointA, s, manifold);
  manifold.normal = view.poseA.rotate(normal);
  manifold.normalOfB = reference == Reference::OfB;
  manifold.localNormal = manifold.normalOfB ? view.poseB.unrotate(manifold.normal) : normal;
  // A ball has one point whatever it does; other points are the same while they stay within the contact's own scale.
  keepImpulses(old, oldCount, ball ? 1.0e18f : maxOf(view.size, 0.25f * spreadOf(manifold)), manifold);
}

/// One more point each time. Returns true if four are known and the closest is one of them: nothing more is to be
/// learned here.
bool addClosest(const View& view, const Separation& closest, Manifold& manifold) {
  Scratch& s = scratch();
  s.candidates.clear();
  const Vec3& normal = closest.normal;
  const Candidate fresh{closest.pointA, closest.pointB, closest.distance};
  bool merged = false, dropped = false;
  for (int i = 0; i < manifold.count; ++i) {
    const ManifoldPoint& point = manifold.points[i];
    Candidate kept{point.localA, view.toA(point.localB), 0.0f, point.normalImpulse};
    const Vec3 apart = kept.onB - kept.onA;
    kept.separation = normal.dot(apart);
    const float drift = (apart - kept.separation * normal).norm();
    const float near = minOf((kept.onA - fresh.onA).squaredNorm(), (kept.onB - fresh.onB).squaredNorm());
    if (!merged && near < kMergeRadius * kMergeRadius * view.size * view.size) {
      kept = fresh;
      kept.normalImpulse = point.normalImpulse;
      merged = true;
    } else if (kept.separation > view.margin || drift > kMaxDrift * view.size) {
      dropped = true;
      continue;
    }
    s.candidates.push_back(kept);
  }
  if (!merged) s.candidates.push_back(fresh);
  reducePoints(normal, kDepthBand * view.size, s.candidates);
  setPoints(view, Vec3::Zero(), s, manifold);
  manifold.normalOfB = false;
  manifold.localNormal = normal;
  manifold.normal = view.poseA.rotate(normal);
  return merged && !dropped && manifold.count == kMaxPoints;
}

}  // namespace

void updateManifold(const Proxy& a, const Transform& poseA, float sizeA, const Proxy& b, const Transform& poseB,
                    float sizeB, float margin, const ManifoldSettings& settings, Manifold& manifold) {
  const View view{a, b, poseA, poseB, geometry::relativePose(poseA, poseB), minOf(sizeA, sizeB), margin};
  if (hardlyMoved(view, settings, manifold) && refresh(view, manifold)) return;
  const Separation closest = geometry::separation(a, b, view.pose, manifold.simplex, margin);  // seen from A
  manifold.computed = false;
  if (closest.distance > margin) {
    manifold.count = 0;
    return;
  }
  bool settled = true;
  // One point a tick cannot hold up what already sinks in: thin shards drop their points by turning, and would go on
  // sinking.
  const bool atOnce = settings.kind == ManifoldKind::Clipped || a.isSphere() || b.isSphere() ||
                      closest.distance < -kTooDeep * view.size;
  if (atOnce)
    clipAll(view, closest, manifold);
  else
    settled = addClosest(view, closest, manifold);
  if (!settled || a.isSphere() || b.isSphere()) return;
  manifold.computed = true;
  manifold.computedAt = relativeTo(poseA, poseB);
  manifold.computedMargin = margin;
  manifold.reach = kUnknownReach;
}

}  // namespace brittle::physics
