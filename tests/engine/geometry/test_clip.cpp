#include "engine/geometry/clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/geometry/shapes.h"

namespace brittle::geometry {
namespace {

std::vector<Vec3> square(float half) {
  return {Vec3(-half, 0.0f, half), Vec3(half, 0.0f, half), Vec3(half, 0.0f, -half), Vec3(-half, 0.0f, -half)};
}

TEST(Clip, FaceCornersRunCounterClockwiseFromOutside) {
  const Convex box = test::box(Vec3(1.0f, 2.0f, 3.0f));
  Random random(1);
  const Transform pose = test::randomPose(random, 2.0f);
  std::vector<Vec3> polygon;
  for (std::uint32_t face = 0; face < 6; ++face) {
    facePolygon(box, face, pose, polygon);
    ASSERT_EQ(polygon.size(), 4u);
    const Vec3 normal = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[1]).normalized();
    EXPECT_LT((normal - pose.rotate(box.faces[face].plane.normal)).norm(), 1e-5f);
  }
}

TEST(Clip, APlaneKeepsWhatIsBelow) {
  std::vector<Vec3> polygon = square(1.0f), scratch;
  clipPolygon({Vec3::UnitX(), 0.5f}, scratch, polygon);
  EXPECT_EQ(polygon.size(), 4u);
  EXPECT_NEAR(polygonArea(polygon), 3.0f, 1e-6f);
  clipPolygon({Vec3::UnitX(), 2.0f}, scratch, polygon);
  EXPECT_NEAR(polygonArea(polygon), 3.0f, 1e-6f);
  clipPolygon({Vec3::UnitX(), -2.0f}, scratch, polygon);
  EXPECT_TRUE(polygon.empty());
  clipPolygon({Vec3::UnitX(), 0.0f}, scratch, polygon);
  EXPECT_EQ(polygonArea(polygon), 0.0f);
}

TEST(Clip, BothSidesOfAPlaneAddUp) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    std::vector<Vec3> below = square(1.0f), above = below, scratch;
    const float angle = random.nextFloat(-kPi, kPi);
    const Plane plane{Vec3(cosine(angle), 0.0f, sine(angle)), random.nextFloat(-1.2f, 1.2f)};
    clipPolygon(plane, scratch, below);
    clipPolygon(plane.flipped(), scratch, above);
    EXPECT_NEAR(polygonArea(below) + polygonArea(above), 4.0f, 1e-5f);
  }
}

TEST(Clip, ToAFaceGivesTheCommonArea) {
  const Convex box = test::box(Vec3(1.0f, 0.5f, 1.0f));
  const std::uint32_t top = supportFace(box, Vec3::UnitY());
  std::vector<Vec3> polygon, scratch;
  // A square turned by 45 degrees: the common part of two squares of side 2 is an octagon of area 8 (sqrt 2 - 1).
  facePolygon(box, top, {Vec3::Zero(), rotationAbout(Vec3::UnitY(), 0.25f * kPi)}, polygon);
  clipToFace(box, top, Transform{}, scratch, polygon);
  EXPECT_EQ(polygon.size(), 8u);
  EXPECT_NEAR(polygonArea(polygon), 8.0f * (std::sqrt(2.0f) - 1.0f), 1e-5f);
  facePolygon(box, top, {Vec3(1.5f, 3.0f, 0.0f), Quat::Identity()}, polygon);
  clipToFace(box, top, Transform{}, scratch, polygon);
  EXPECT_NEAR(polygonArea(polygon), 1.0f, 1e-6f);
  facePolygon(box, top, {Vec3(2.5f, 0.0f, 0.0f), Quat::Identity()}, polygon);
  clipToFace(box, top, Transform{}, scratch, polygon);
  EXPECT_TRUE(polygon.empty());
}

TEST(Clip, SupportFaceIsTheOneMostAlong) {
  Random random(3);
  const Convex hull = test::randomHull(random, 14, Vec3(1.0f, 0.3f, 2.0f));
  for (std::uint32_t i = 0; i < hull.faces.size(); ++i) EXPECT_EQ(supportFace(hull, hull.faces[i].plane.normal), i);
}

}  // namespace
}  // namespace brittle::geometry
