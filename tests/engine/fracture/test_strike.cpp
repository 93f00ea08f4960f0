#include "engine/fracture/strike.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/random.h"
#include "engine/geometry/make.h"
#include "engine/math/trig.h"
#include "tests/engine/fracture/scene.h"

namespace brittle::fracture {
namespace {

TEST(Strike, ClosestPointOfABoxIsTheClampedPoint) {
  const Vec3 half(0.5f, 0.25f, 0.125f);
  const geometry::Convex box = geometry::makeBox<float>(half);
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    Vec3 point;
    for (int k = 0; k < 3; ++k) point[k] = random.nextFloat(-1.0f, 1.0f);
    Vec3 expected;
    for (int k = 0; k < 3; ++k) expected[k] = clampTo(point[k], -half[k], half[k]);
    EXPECT_LT((closestPoint(box, point) - expected).norm(), 1e-6f);
  }
}

TEST(Strike, FindsTheSheetWhicheverWayItLies) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 half = Vec3::Constant(0.5f);
    half[axis] = 0.01f;
    Scene scene;
    scene.addBox(half, Vec3::Zero());
    const Strike strike = strikeOf(scene.parts, straightAt({0.0f, 0.0f, 0.0f}), {});
    EXPECT_NEAR(std::fabs(strike.normal[axis]), 1.0f, 1e-6f);
    EXPECT_NEAR(strike.thickness, 0.02f, 1e-6f);
    EXPECT_NEAR(strike.right.cross(strike.up).dot(strike.normal), 1.0f, 1e-6f);
  }
}

TEST(Strike, ARodOfAPaneBelongsToThePane) {
  Scene scene = pane();
  scene.addBox({0.01f, 0.5f, 0.01f}, {0.51f, 0.0f, 0.0f});
  const Strike strike = strikeOf(scene.parts, straightAt({0.515f, 0.0f, 0.01f}), {});
  EXPECT_EQ(strike.part, 1u);
  EXPECT_NEAR(std::fabs(strike.normal.z()), 1.0f, 1e-6f);
}

TEST(Strike, ACubeIsStruckOnTheSideThatIsHit) {
  const Scene scene = block();
  const Strike strike = strikeOf(scene.parts, {{0.25f, 0.0f, 0.0f}, -Vec3::UnitX(), 5.0f, 0.02f}, {});
  EXPECT_NEAR(std::fabs(strike.normal.x()), 1.0f, 1e-6f);
}

TEST(Strike, RadiusGrowsWithTheRootOfSpeedAndLetsTheStrikerThrough) {
  const Scene scene = pane();
  FractureMaterial material;
  material.carveRadius = 0.2f;
  const auto radiusAt = [&](float speed, float striker) {
    return strikeOf(scene.parts, straightAt(Vec3::Zero(), speed, striker), material).radius;
  };
  EXPECT_NEAR(radiusAt(10.0f, 0.0f), 0.2f, 1e-6f);
  EXPECT_NEAR(radiusAt(40.0f, 0.0f), 0.4f, 1e-6f);
  EXPECT_GT(radiusAt(1.0f, 0.2f), 0.27f);
}

TEST(Strike, AnImpactBesideTheBodyIsMovedIntoIt) {
  const Scene scene = pane();
  const Strike strike = strikeOf(scene.parts, straightAt({0.6f, 0.0f, 0.5f}), {});
  EXPECT_NEAR((strike.center - Vec3(0.5f, 0.0f, 0.01f)).norm(), 0.0f, 1e-6f);
  EXPECT_NEAR((strike.passage - Vec3(0.6f, 0.0f, 0.0f)).norm(), 0.0f, 1e-6f);
}

TEST(Strike, ReachGrowsAlongTheSlant) {
  const Scene scene = pane();
  Impact impact = straightAt(Vec3::Zero());
  impact.direction = Vec3(sine(1.0f), 0.0f, -cosine(1.0f));
  const Strike strike = strikeOf(scene.parts, impact, {});
  EXPECT_NEAR(reachWithinSheet(strike, 0.05f, Vec3::UnitY()), 0.05f, 1e-6f);
  EXPECT_NEAR(reachWithinSheet(strike, 0.05f, Vec3::UnitX()), 0.05f / cosine(1.0f) + 0.01f * tangent(1.0f), 1e-6f);
}

}  // namespace
}  // namespace brittle::fracture
