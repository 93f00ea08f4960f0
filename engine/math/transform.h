// math/transform.h - rigid poses: rotate, then move.
#pragma once

#include "engine/math/trig.h"
#include "engine/math/types.h"

namespace brittle {

/// The rotation by `angle` [rad] about the unit vector `axis`.
inline Quat rotationAbout(const Vec3& axis, float angle) {
  const float s = sine(0.5f * angle);
  return Quat(cosine(0.5f * angle), axis.x() * s, axis.y() * s, axis.z() * s);
}

/// The rotation about X, then Y, then Z (level files store rotations this way) [rad].
inline Quat rotationXyz(const Vec3& angles) {
  return rotationAbout(Vec3::UnitZ(), angles.z()) * rotationAbout(Vec3::UnitY(), angles.y()) *
         rotationAbout(Vec3::UnitX(), angles.x());
}

/// `v` turned by the unit quaternion `q`: the same operations as Eigen's q * v, but inlined.
inline Vec3 rotated(const Quat& q, const Vec3& v) {
  const float w = q.w(), x = q.x(), y = q.y(), z = q.z();
  const float halfX = y * v.z() - z * v.y(), halfY = z * v.x() - x * v.z(), halfZ = x * v.y() - y * v.x();
  const float twiceX = halfX + halfX, twiceY = halfY + halfY, twiceZ = halfZ + halfZ;
  return Vec3((v.x() + w * twiceX) + (y * twiceZ - z * twiceY), (v.y() + w * twiceY) + (z * twiceX - x * twiceZ),
              (v.z() + w * twiceZ) + (x * twiceY - y * twiceX));
}

struct Transform {
  Vec3 position = Vec3::Zero();      // [m]
  Quat rotation = Quat::Identity();  // unit

  Vec3 toWorld(const Vec3& pointLocal) const { return rotated(rotation, pointLocal) + position; }
  Vec3 toLocal(const Vec3& pointWorld) const { return rotated(rotation.conjugate(), pointWorld - position); }
  Vec3 rotate(const Vec3& vectorLocal) const { return rotated(rotation, vectorLocal); }
  Vec3 unrotate(const Vec3& vectorWorld) const { return rotated(rotation.conjugate(), vectorWorld); }
};

/// First `inner`, then `outer`.
inline Transform operator*(const Transform& outer, const Transform& inner) {
  return {outer.toWorld(inner.position), outer.rotation * inner.rotation};
}

/// `b` as seen from `a`: a * relative == b.
inline Transform relativeTo(const Transform& a, const Transform& b) {
  return {a.toLocal(b.position), a.rotation.conjugate() * b.rotation};
}

/// The rotation vector [rad] that leads from `a` to `b`, at most half a turn.
inline Vec3 rotationBetween(const Quat& a, const Quat& b) {
  Quat turn = b * a.conjugate();
  if (turn.w() < 0.0f) turn.coeffs() = -turn.coeffs();
  const float s = turn.vec().norm();
  return s > 1e-9f ? Vec3(turn.vec() * (2.0f * arcTangent(s, turn.w()) / s)) : Vec3(Vec3::Zero());
}

/// The rotation after turning with angular velocity `w` [rad/s] for `dt` [s]; exact for constant w.
inline Quat integrateRotation(const Quat& q, const Vec3& w, float dt) {
  const float speed = w.norm();
  if (speed * dt < 1e-9f) return q;
  return (rotationAbout(w / speed, speed * dt) * q).normalized();
}

}  // namespace brittle
