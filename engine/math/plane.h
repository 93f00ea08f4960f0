// math/plane.h - an oriented plane: the points x with normal . x = offset; above is where the normal points.
#pragma once

#include "engine/math/types.h"

namespace brittle {

template <class S>
struct PlaneT {
  Vec3T<S> normal = Vec3T<S>(S(0), S(1), S(0));  // unit, unless the scalar is exact
  S offset = S(0);                               // [m]

  /// Signed distance of `point`, summed in this order on every machine. [m] for a unit normal.
  S distance(const Vec3T<S>& point) const {
    return ((normal.x() * point.x() + normal.y() * point.y()) + normal.z() * point.z()) - offset;
  }
  PlaneT flipped() const { return {Vec3T<S>(-normal.x(), -normal.y(), -normal.z()), -offset}; }
};

using Plane = PlaneT<float>;

inline Plane planeThrough(const Vec3& point, const Vec3& normal) {
  return {normal, normal.dot(point)};
}

}  // namespace brittle
