// math/types.h - the vector types of the project; the only file of ours that sees Eigen.
// Metres, seconds, kilograms, radians. Right-handed: X right, Y up, -Z forward.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace brittle {

template <class S>
using Vec3T = Eigen::Matrix<S, 3, 1>;
template <class S>
using Mat3T = Eigen::Matrix<S, 3, 3>;

using Vec2 = Eigen::Vector2f;
using Vec3 = Vec3T<float>;
using Vec4 = Eigen::Vector4f;
using Mat3 = Mat3T<float>;
using Mat4 = Eigen::Matrix4f;
using Quat = Eigen::Quaternionf;
using Vec3d = Vec3T<double>;
using Mat3d = Mat3T<double>;

/// Smallest and largest by compare and select, so that NaN and signed zeros behave the same on every machine.
template <class T>
constexpr T minOf(T a, T b) {
  return b < a ? b : a;
}
template <class T>
constexpr T maxOf(T a, T b) {
  return a < b ? b : a;
}
template <class T>
constexpr T clampTo(T value, T low, T high) {
  return value < low ? low : (high < value ? high : value);
}

inline bool isFinite(float value) {
  return value - value == 0.0f;
}
inline bool isFinite(const Vec3& v) {
  return isFinite(v.x()) && isFinite(v.y()) && isFinite(v.z());
}
inline bool isFinite(const Quat& q) {
  return isFinite(q.x()) && isFinite(q.y()) && isFinite(q.z()) && isFinite(q.w());
}

/// The matrix S with S u = v x u.
inline Mat3 crossMatrix(const Vec3& v) {
  Mat3 m;
  m << 0.0f, -v.z(), v.y(), v.z(), 0.0f, -v.x(), -v.y(), v.x(), 0.0f;
  return m;
}

/// `v` scaled to length 1, or `fallback` if it is too short to have a direction.
inline Vec3 normalizedOr(const Vec3& v, const Vec3& fallback) {
  const float length = v.norm();
  return length > 1e-20f ? Vec3(v / length) : fallback;
}

/// A unit vector perpendicular to the unit vector `n`; depends on `n` alone.
inline Vec3 perpendicular(const Vec3& n) {
  const Vec3 axis = n.x() * n.x() < 0.333f ? Vec3::UnitX() : Vec3::UnitY();
  return n.cross(axis).normalized();
}

}  // namespace brittle
