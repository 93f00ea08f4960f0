// Two hulls, slivers and touching ones among them, at any pose: the distance is finite, its normal has unit length, the
// two orders agree, closest points are as far apart as it says, and warm starts change nothing beyond rounding.
#include "engine/geometry/gjk.h"

#include <cmath>
#include <vector>

#include "engine/core/assert.h"
#include "engine/geometry/make.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/target.h"

namespace {

using namespace brittle;
using namespace brittle::geometry;

/// A box if the points have no hull.
Convex chooseHull(fuzz::Input& input) {
  std::vector<Vec3> points;
  Vec3 scale = input.nextVector(0.05f, 1.0f);
  const std::uint32_t flat = input.nextBelow(6);
  if (flat < 3) scale[static_cast<int>(flat)] *= 1e-3f;
  for (std::uint32_t i = 4 + input.nextBelow(12); i > 0; --i)
    points.push_back(input.nextVector(-1.0f, 1.0f).cwiseProduct(scale));
  const Result<Convex> hull = makeHull(points);
  return hull ? *hull : makeBox<float>(scale);
}

Transform choosePose(fuzz::Input& input) {
  Transform pose;
  pose.position = input.nextVector(-1.5f, 1.5f);
  if (input.nextBelow(2) == 0) return pose;
  const Vec3 turn = input.nextVector(-3.0f, 3.0f);
  const Quat rotation(1.0f, turn.x(), turn.y(), turn.z());
  pose.rotation = rotation.normalized();
  return pose;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input({data, size});
  const Convex hullA = chooseHull(input);
  const Convex hullB = chooseHull(input);
  const Proxy a{hullA.view()};
  const Proxy b{hullB.view()};
  const Transform poseA = choosePose(input);
  const Transform poseB = choosePose(input);
  SimplexCache cold, other;
  const Separation found = separation(a, poseA, b, poseB, cold);
  BR_ASSERT(std::isfinite(found.distance) && isFinite(found.pointA) && isFinite(found.pointB));
  BR_ASSERT(std::abs(found.normal.norm() - 1.0f) < 1e-5f);
  const float tolerance = 2e-5f;  // of an extent of about 1 m
  if (found.distance > tolerance) {
    const float apart = (found.pointB - found.pointA).norm();
    BR_ASSERT(std::abs(apart - found.distance) < tolerance);
  }
  const Separation mirrored = separation(b, poseB, a, poseA, other);
  BR_ASSERT(std::abs(mirrored.distance - found.distance) < tolerance);
  const Separation warm = separation(a, poseA, b, poseB, cold);
  BR_ASSERT(std::abs(warm.distance - found.distance) < tolerance);
  if (std::abs(found.distance) > tolerance) BR_ASSERT(overlaps(a, poseA, b, poseB, 0.0f) == (found.distance < 0.0f));
  return 0;
}
