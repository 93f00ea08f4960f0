// render/occlusion.h - what a point in a room sees of its surroundings: rays against axis-aligned boxes, four boxes at
// a time. Pure; used by the baker only.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/math/aabb.h"
#include "engine/math/simd.h"

namespace brittle::render {

class Occlusion {
 public:
  /// `reach`: how far away something may be and still darken [m].
  Occlusion(std::vector<Aabb> boxes, float reach);

  /// The boxes that can be seen from `face`, a flat box, on the side `sign` of `axis`. Before openness and isBlocked.
  void focus(const Aabb& face, int axis, float sign);
  /// Boxes within reach of the face in focus, on its open side.
  std::span<const Aabb> near() const { return near_; }

  /// The part of the hemisphere over `point` that is open, weighted as light counts and by how far away what closes it
  /// is. [0, 1]
  float openness(const Vec3& point, int axis, float sign) const;
  /// Whether a box lies between the two points; the last `margin` of the way does not count. [m]
  bool isBlocked(const Vec3& from, const Vec3& to, float margin) const;

 private:
  /// Low and high sides of four boxes by axis; empty ones fill up the last.
  struct Box4 {
    std::array<Float4, 3> low, high;
  };
  static std::vector<Box4> pack(const std::vector<Aabb>& boxes);
  /// How far a ray gets, at most `reach`. Starting inside a box counts as 0.
  static float wayOf(const std::vector<Box4>& boxes, const Vec3& from, const Vec3& inverse, float reach);

  float reach_;
  std::vector<Aabb> boxes_, near_, ahead_;
  std::vector<Box4> nearPacked_, aheadPacked_;
};

}  // namespace brittle::render
