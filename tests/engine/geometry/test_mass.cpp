#include "engine/geometry/mass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/math/transform.h"
#include "tests/engine/geometry/cutting.h"
#include "tests/engine/geometry/exact.h"

namespace brittle::geometry {
namespace {

bool isPositiveDefinite(const Mat3& inertia) {
  return mass_detail::smallestPivot(inertia.cast<double>()) > 0.0;
}

double relativeError(const Mat3& found, const Mat3d& expected) {
  return (found.cast<double>() - expected).norm() / expected.norm();
}

TEST(Mass, BoxHasItsClosedForm) {
  const MassProperties mass = massOf(makeBox<float>(Vec3(1.0f, 2.0f, 3.0f), Vec3(4.0f, 5.0f, 6.0f)).view());
  EXPECT_EQ(mass.volume, 48.0f);
  EXPECT_EQ(mass.center, Vec3(4.0f, 5.0f, 6.0f));
  EXPECT_EQ(mass.inertia, Mat3(Vec3(16.0f * 13.0f, 16.0f * 10.0f, 16.0f * 5.0f).asDiagonal()));
}

TEST(Mass, TetrahedronHasItsClosedForm) {
  const Vec3 corners[] = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  const MassProperties mass = massOf(makeHull(corners)->view());
  EXPECT_FLOAT_EQ(mass.volume, 1.0f / 6.0f);
  EXPECT_LT((mass.center - Vec3::Constant(0.25f)).norm(), 1e-7f);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FLOAT_EQ(mass.inertia(i, i), 1.0f / 80.0f);
    EXPECT_FLOAT_EQ(mass.inertia(i, (i + 1) % 3), 1.0f / 480.0f);
  }
}

TEST(Mass, CylinderOfManySidesHasThatOfACylinder) {
  const float radius = 0.5f;
  const float height = 2.0f;
  const MassProperties mass = massOf(makeCylinder(radius, 0.5f * height, 5000).view());
  const float volume = kPi * radius * radius * height;
  EXPECT_NEAR(mass.volume / volume, 1.0f, 1e-6f);
  EXPECT_NEAR(mass.inertia(1, 1) / (0.5f * volume * radius * radius), 1.0f, 1e-6f);
  EXPECT_NEAR(mass.inertia(0, 0) / (volume * (0.25f * radius * radius + height * height / 12.0f)), 1.0f, 1e-6f);
}

TEST(Mass, SphereHasItsClosedForm) {
  const MassProperties mass = massOfSphere(2.0f, Vec3(1.0f, 2.0f, 3.0f));
  EXPECT_FLOAT_EQ(mass.volume, 4.0f / 3.0f * kPi * 8.0f);
  EXPECT_EQ(mass.center, Vec3(1.0f, 2.0f, 3.0f));
  EXPECT_FLOAT_EQ(mass.inertia(1, 1), 0.4f * mass.volume * 4.0f);
  EXPECT_EQ(mass.inertia(0, 1), 0.0f);
}

TEST(Mass, NothingHasNoMass) {
  const MassProperties mass = massOf(ConvexView());
  EXPECT_EQ(mass.volume, 0.0f);
  EXPECT_EQ(mass.inertia, Mat3(Mat3::Zero()));
}

class MassModes : public ::testing::TestWithParam<CutMode> {};

TEST_P(MassModes, AgreesWithExactIntegrals) {
  CutCube<float> cube(GetParam(), 61);
  for (int attempt = 0; attempt < 300; ++attempt) {
    if (cube.step() != SplitOutcome::Split) continue;
    const MassProperties mass = massOf(cube.above.view());
    const MassPropertiesT<Exact> exact = massOf(exactOf(cube.above).view());
    ASSERT_NEAR(mass.volume / static_cast<double>(exact.volume), 1.0, 1e-6);
    Mat3d inertia;
    for (int i = 0; i < 3; ++i) {
      // Coordinates below 1 are rounded to 2^-25.
      ASSERT_NEAR(mass.center[i], static_cast<double>(exact.center[i]), 1e-6 * extentOf(cube.above.view()) + 0x1p-25);
      for (int j = 0; j < 3; ++j) inertia(i, j) = static_cast<double>(exact.inertia(i, j));
    }
    ASSERT_LT(relativeError(mass.inertia, inertia), 1e-5) << attempt;
  }
}

TEST_P(MassModes, IsThatOfABodyForEveryPiece) {
  CutCube<float> cube(GetParam(), 62);
  for (int attempt = 0; attempt < 20000; ++attempt) {
    if (cube.step() != SplitOutcome::Split) continue;
    for (const Convex* piece : {&cube.above, &cube.below}) {
      const MassProperties mass = massOf(piece->view());
      ASSERT_GT(mass.volume, 0.0f);
      ASSERT_TRUE(isPositiveDefinite(mass.inertia));
      ASSERT_LT(mass.center.cwiseAbs().maxCoeff(), 0.5f + 1e-6f);
    }
  }
}

TEST_P(MassModes, PiecesAddUpToTheCube) {
  CutCube<float> cube(GetParam(), 63);
  while (!cube.isFull()) cube.step();
  MassProperties sum;
  for (std::size_t i = 0; i < cube.count(); ++i) sum = combined(sum, massOf(cube.piece(i).view()));
  EXPECT_NEAR(sum.volume, 1.0f, 1e-5f);
  EXPECT_LT(sum.center.norm(), 1e-6f);
  EXPECT_LT(relativeError(sum.inertia, Mat3d::Identity() / 6.0), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(AllModes, MassModes, ::testing::ValuesIn(kCutModes), [](const auto& instance) {
  return std::string(kCutModeNames[static_cast<int>(instance.param)]);
});

TEST(Mass, SliversAndNeedlesStayPositiveDefinite) {
  Random random(64);
  for (const float thin : {1e-2f, 1e-3f, 1e-4f, kMinThickness}) {
    for (const float middle : {1.0f, thin}) {
      for (int i = 0; i < 200; ++i) {
        const Convex sliver =
            transformed(makeBox<float>(Vec3(0.5f, 0.5f * middle, 0.5f * thin)), drawRotation(random), Vec3::Zero());
        const MassProperties mass = massOf(sliver.view());
        ASSERT_GT(mass.volume, 0.0f);
        ASSERT_TRUE(isPositiveDefinite(mass.inertia));
        ASSERT_TRUE(isFinite(mass.inertia.inverse().norm()));
        ASSERT_NEAR(mass.volume / (middle * thin), 1.0f, 0.02f);  // corners are rounded to 2^-25
      }
    }
  }
}

// Thicker than nothing on one side, inside out on the other: with both weighed, the centre would lie far outside.
TEST(Mass, PiecesPartlyInsideOutCountAsTheirBounds) {
  Convex bowTie = makeBox<float>(Vec3::Ones());
  for (Vertex& vertex : bowTie.vertices) vertex.point.z() *= 0.5f * (vertex.point.x() + 0.1f);
  const MassProperties mass = massOf(bowTie.view());
  EXPECT_FLOAT_EQ(mass.volume, 0.4f);
  EXPECT_LT(mass.center.norm(), 1e-6f);
  EXPECT_FLOAT_EQ(mass.inertia(2, 2), 0.4f * 8.0f / 12.0f);
  EXPECT_TRUE(isPositiveDefinite(mass.inertia));
}

TEST(Mass, CombinedDoesNotDependOnTheOrder) {
  const MassProperties a = massOf(makeBox<float>(Vec3(0.5f, 1.0f, 1.0f), Vec3(-0.5f, 0.0f, 0.0f)).view());
  const MassProperties b = massOf(makeBox<float>(Vec3(1.0f, 1.0f, 1.0f), Vec3(1.0f, 0.0f, 0.0f)).view());
  const MassProperties whole = massOf(makeBox<float>(Vec3(1.5f, 1.0f, 1.0f), Vec3(0.5f, 0.0f, 0.0f)).view());
  for (const MassProperties& sum : {combined(a, b), combined(b, a)}) {
    EXPECT_FLOAT_EQ(sum.volume, whole.volume);
    EXPECT_LT((sum.center - whole.center).norm(), 1e-6f);
    EXPECT_LT(relativeError(sum.inertia, whole.inertia.cast<double>()), 1e-6);
  }
  EXPECT_EQ(combined(MassProperties(), a).inertia, a.inertia);
  EXPECT_EQ(combined(a, MassProperties()).volume, a.volume);
}

}  // namespace
}  // namespace brittle::geometry
