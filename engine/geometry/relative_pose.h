// geometry/relative_pose.h - one frame as seen from another, in double. Vertices and poses are floats; the difference
// of two far poses is taken here before anything is rounded, so that what follows is as precise as the floats it was
// given.
#pragma once

#include "engine/math/transform.h"

namespace brittle::geometry {

inline Mat3d rotationMatrix(double w, double x, double y, double z) {
  const double s = 2.0 / (w * w + x * x + y * y + z * z);  // a float quaternion is a unit one to 1e-7 only
  Mat3d m;
  m << 1.0 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y),  //
      s * (x * y + w * z), 1.0 - s * (x * x + z * z), s * (y * z - w * x),   //
      s * (x * z - w * y), s * (y * z + w * x), 1.0 - s * (x * x + y * y);
  return m;
}

inline Mat3d rotationMatrix(const Quat& q) {
  return rotationMatrix(static_cast<double>(q.w()), static_cast<double>(q.x()), static_cast<double>(q.y()),
                        static_cast<double>(q.z()));
}

/// Maps points of B's frame to A's.
struct RelativePose {
  Mat3d rotation = Mat3d::Identity();
  Vec3d translation = Vec3d::Zero();  // [m]

  Vec3d apply(const Vec3& point) const {
    const double x = static_cast<double>(point.x()), y = static_cast<double>(point.y()),
                 z = static_cast<double>(point.z());
    return {rotation(0, 0) * x + rotation(0, 1) * y + rotation(0, 2) * z + translation.x(),
            rotation(1, 0) * x + rotation(1, 1) * y + rotation(1, 2) * z + translation.y(),
            rotation(2, 0) * x + rotation(2, 1) * y + rotation(2, 2) * z + translation.z()};
  }
  Vec3d rotate(const Vec3& v) const { return apply(v) - translation; }
};

inline RelativePose relativePose(const Transform& a, const Transform& b) {
  const Mat3d inverse = rotationMatrix(a.rotation).transpose();
  const Vec3d apart = b.position.cast<double>() - a.position.cast<double>();
  const Mat3d own = rotationMatrix(b.rotation);
  RelativePose pose;
  pose.rotation.noalias() = inverse * own;
  pose.translation.noalias() = inverse * apart;
  return pose;
}

}  // namespace brittle::geometry
