#include "engine/math/transform.h"

#include <gtest/gtest.h>

#include "engine/core/random.h"
#include "engine/math/aabb.h"
#include "engine/math/plane.h"

namespace brittle {
namespace {

Vec3 randomVector(Random& random, float size) {
  const float x = random.nextFloat(-size, size);
  const float y = random.nextFloat(-size, size);
  const float z = random.nextFloat(-size, size);
  return Vec3(x, y, z);
}

Transform randomTransform(Random& random) {
  const Vec3 axis = normalizedOr(randomVector(random, 1.0f), Vec3::UnitX());
  const float angle = random.nextFloat(-3.0f, 3.0f);
  return {randomVector(random, 10.0f), rotationAbout(axis, angle)};
}

TEST(Transform, QuarterTurnAboutYTakesZToX) {
  const Quat turn = rotationAbout(Vec3::UnitY(), kPi / 2);
  EXPECT_LT((turn * Vec3::UnitZ() - Vec3::UnitX()).norm(), 1e-6f);
}

TEST(Transform, XyzTurnsAboutXFirst) {
  const Quat turn = rotationXyz(Vec3(kPi / 2, 0.0f, kPi / 2));
  EXPECT_LT((turn * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-6f);
  EXPECT_LT((turn * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-6f);
}

TEST(Transform, LocalUndoesWorldAndRelativeUndoesTheProduct) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Transform a = randomTransform(random);
    const Transform b = randomTransform(random);
    const Vec3 point = randomVector(random, 5.0f);
    ASSERT_LT((a.toLocal(a.toWorld(point)) - point).norm(), 2e-5f);
    ASSERT_LT(((a * b).toWorld(point) - a.toWorld(b.toWorld(point))).norm(), 3e-5f);
    ASSERT_LT(((a * relativeTo(a, b)).toWorld(point) - b.toWorld(point)).norm(), 5e-5f);
  }
}

TEST(Transform, ConstantSpinIsExactForAnyStep) {
  const Vec3 spin(1.0f, -2.0f, 0.5f);
  Quat many = Quat::Identity();
  for (int i = 0; i < 60; ++i) many = integrateRotation(many, spin, 1.0f / 60.0f);
  const Quat once = integrateRotation(Quat::Identity(), spin, 1.0f);
  EXPECT_NEAR(std::fabs(many.dot(once)), 1.0f, 1e-6f);
  EXPECT_EQ(integrateRotation(once, Vec3::Zero(), 1.0f).coeffs(), once.coeffs());
}

TEST(Types, PerpendicularIsAUnitVectorAtARightAngle) {
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 n = normalizedOr(randomVector(random, 1.0f), Vec3::UnitX());
    const Vec3 p = perpendicular(n);
    ASSERT_NEAR(p.norm(), 1.0f, 1e-6f);
    ASSERT_NEAR(p.dot(n), 0.0f, 1e-6f);
  }
}

TEST(Types, MinAndMaxTakeTheFirstOfEquals) {
  EXPECT_FALSE(std::signbit(minOf(0.0f, -0.0f)));
  EXPECT_FALSE(std::signbit(maxOf(0.0f, -0.0f)));
  EXPECT_TRUE(std::signbit(maxOf(-0.0f, 0.0f)));
  EXPECT_FALSE(isFinite(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_FALSE(isFinite(std::numeric_limits<float>::infinity()));
}

TEST(Aabb, GrowsToWhatItIncludes) {
  Aabb box;
  EXPECT_TRUE(box.isEmpty());
  box.include(Vec3(1.0f, 2.0f, 3.0f));
  box.include(Vec3(-1.0f, 0.0f, 0.0f));
  EXPECT_FALSE(box.isEmpty());
  EXPECT_EQ(box.extent(), Vec3(2.0f, 2.0f, 3.0f));
  EXPECT_EQ(box.halfArea(), 2.0f * 2.0f + 2.0f * 3.0f + 3.0f * 2.0f);
  EXPECT_TRUE(box.contains(box.center()));
  EXPECT_TRUE(box.overlaps(Aabb{Vec3(1.0f, 2.0f, 3.0f), Vec3(9.0f, 9.0f, 9.0f)})) << "touching counts";
  EXPECT_FALSE(box.overlaps(Aabb{Vec3(1.1f, 0.0f, 0.0f), Vec3(9.0f, 9.0f, 9.0f)}));
}

TEST(Plane, DistanceIsSignedAndFlipsExactly) {
  const Plane plane = planeThrough(Vec3(0.0f, 2.0f, 0.0f), Vec3::UnitY());
  EXPECT_EQ(plane.distance(Vec3(5.0f, 3.5f, -1.0f)), 1.5f);
  Random random(8);
  for (int i = 0; i < 1000; ++i) {
    const Plane any = planeThrough(randomVector(random, 3.0f), normalizedOr(randomVector(random, 1.0f), Vec3::UnitX()));
    const Vec3 point = randomVector(random, 3.0f);
    ASSERT_EQ(any.flipped().distance(point), -any.distance(point));
  }
}

}  // namespace
}  // namespace brittle
