// physics/point_lanes.h - the points of one manifold side by side, one a lane: what collision and solver preparation
// ask of every point is asked of all four at once. Lanes beyond the manifold's count hold whatever stands there.
#pragma once

#include <cstddef>
#include <cstring>

#include "engine/math/simd.h"
#include "engine/math/transform.h"
#include "engine/physics/manifold.h"

namespace brittle::physics {

static_assert(kMaxPoints == kLanes && sizeof(ManifoldPoint) == 2 * sizeof(Float4));
static_assert(offsetof(ManifoldPoint, localB) == 12 && offsetof(ManifoldPoint, separation) == 24 &&
              offsetof(ManifoldPoint, normalImpulse) == 28);

inline Wide3<Float4> splat(const Vec3& v) {
  return {brittle::splat(v.x()), brittle::splat(v.y()), brittle::splat(v.z())};
}

inline Wide3<Float4> cross(const Wide3<Float4>& a, const Wide3<Float4>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[gnu::always_inline]] inline Wide3<Float4> product(const Mat3& m, const Wide3<Float4>& v) {
  return {dot(splat(m.row(0)), v), dot(splat(m.row(1)), v), dot(splat(m.row(2)), v)};
}

/// As Transform::toWorld, operation by operation.
[[gnu::always_inline]] inline Wide3<Float4> toWorld(const Transform& pose, const Wide3<Float4>& local) {
  const Wide3<Float4> axis = splat(pose.rotation.vec());
  const Wide3<Float4> half = cross(axis, local);
  const Wide3<Float4> twice = half + half;
  return ((local + twice * brittle::splat(pose.rotation.w())) + cross(axis, twice)) + splat(pose.position);
}

struct PointLanes {
  Wide3<Float4> onA, onB;  // world [m]

  Wide3<Float4> middle() const { return (onA + onB) * brittle::splat(0.5f); }
};

[[gnu::always_inline]] inline PointLanes lanesOf(const Manifold& manifold, const Transform& poseA,
                                                 const Transform& poseB) {
  Float4 first[kLanes], second[kLanes];  // a point is eight floats: A's three, B's three, separation and impulse
  for (int i = 0; i < kLanes; ++i) {
    std::memcpy(&first[i], &manifold.points[i], sizeof(Float4));
    std::memcpy(&second[i], reinterpret_cast<const char*>(&manifold.points[i]) + sizeof(Float4), sizeof(Float4));
  }
  transpose(first[0], first[1], first[2], first[3]);
  transpose(second[0], second[1], second[2], second[3]);
  return {toWorld(poseA, {first[0], first[1], first[2]}), toWorld(poseB, {first[3], second[0], second[1]})};
}

}  // namespace brittle::physics
