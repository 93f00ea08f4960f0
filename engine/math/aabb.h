// math/aabb.h - axis-aligned bounding boxes.
#pragma once

#include "engine/math/types.h"

namespace brittle {

struct Aabb {
  Vec3 low = Vec3::Constant(3.0e38f);  // above `high` on every axis: empty
  Vec3 high = Vec3::Constant(-3.0e38f);

  bool isEmpty() const { return high.x() < low.x(); }
  void include(const Vec3& point) {
    for (int i = 0; i < 3; ++i) {
      low[i] = minOf(low[i], point[i]);
      high[i] = maxOf(high[i], point[i]);
    }
  }
  void include(const Aabb& other) {
    for (int i = 0; i < 3; ++i) {
      low[i] = minOf(low[i], other.low[i]);
      high[i] = maxOf(high[i], other.high[i]);
    }
  }
  Aabb grownBy(float margin) const { return {low - Vec3::Constant(margin), high + Vec3::Constant(margin)}; }
  bool overlaps(const Aabb& other) const {
    return low.x() <= other.high.x() && other.low.x() <= high.x() && low.y() <= other.high.y() &&
           other.low.y() <= high.y() && low.z() <= other.high.z() && other.low.z() <= high.z();
  }
  bool contains(const Aabb& other) const {
    return low.x() <= other.low.x() && low.y() <= other.low.y() && low.z() <= other.low.z() &&
           other.high.x() <= high.x() && other.high.y() <= high.y() && other.high.z() <= high.z();
  }
  bool contains(const Vec3& point) const { return contains(Aabb{point, point}); }
  Vec3 center() const { return 0.5f * (low + high); }
  Vec3 extent() const { return high - low; }
  /// Half the surface area: the cost measure of a bounding volume tree. [m2]
  float halfArea() const {
    const Vec3 e = extent();
    return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
  }
};

inline Aabb unionOf(Aabb a, const Aabb& b) {
  a.include(b);
  return a;
}

}  // namespace brittle
