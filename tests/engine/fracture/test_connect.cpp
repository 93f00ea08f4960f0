#include "engine/fracture/connect.h"

#include <gtest/gtest.h>

#include "engine/geometry/make.h"
#include "engine/math/transform.h"
#include "tests/engine/fracture/scene.h"

namespace brittle::fracture {
namespace {

geometry::Convex cubeAt(const Vec3& center) {
  return geometry::makeBox<float>({0.5f, 0.5f, 0.5f}, center);
}

bool cubesConnect(const Vec3& offset) {
  const geometry::Convex a = cubeAt(Vec3::Zero());
  const geometry::Convex b = cubeAt(offset);
  const bool answer = areConnected(a, b, kSlop);
  EXPECT_EQ(answer, areConnected(b, a, kSlop)) << "the test is symmetric";
  return answer;
}

TEST(Connect, FacesHangTogetherEdgesAndCornersDoNot) {
  EXPECT_TRUE(cubesConnect({1.0f, 0.0f, 0.0f}));
  EXPECT_TRUE(cubesConnect({1.0f, 0.9f, 0.0f}));
  EXPECT_FALSE(cubesConnect({1.0f, 1.0f, 0.0f})) << "an edge only";
  EXPECT_FALSE(cubesConnect({1.0f, 1.0f, 1.0f})) << "a corner only";
}

TEST(Connect, GapDecidesAtTheSlopAndNowhereElse) {
  EXPECT_TRUE(cubesConnect({1.0f + 1e-6f, 0.0f, 0.0f}));
  EXPECT_TRUE(cubesConnect({1.0f - 1e-6f, 0.0f, 0.0f}));
  EXPECT_TRUE(cubesConnect({1.0f + 0.99f * kSlop, 0.0f, 0.0f}));
  EXPECT_FALSE(cubesConnect({1.0f + 1.01f * kSlop, 0.0f, 0.0f}));
  int flips = 0;
  bool last = true;
  for (int i = -300; i <= 300; ++i) {
    const bool now = cubesConnect({1.0f + 0.01f * static_cast<float>(i) * kSlop, 0.0f, 0.0f});
    flips += now != last ? 1 : 0;
    last = now;
  }
  EXPECT_EQ(flips, 1);
}

TEST(Connect, SharedAreaDecidesAtFourSlopsSquared) {
  // The boxes overlap in a square of side `shared` at their corners.
  const auto connectsWith = [](float shared) { return cubesConnect({1.0f, 1.0f - shared, 1.0f - shared}); };
  EXPECT_FALSE(connectsWith(1.95f * kSlop));
  EXPECT_TRUE(connectsWith(2.05f * kSlop));
}

TEST(Connect, DeepOverlapHangsTogetherHoweverTurned) {
  EXPECT_TRUE(cubesConnect({0.5f, 0.3f, 0.1f}));
  EXPECT_TRUE(cubesConnect(Vec3::Zero()));
  const geometry::Convex a = cubeAt(Vec3::Zero());
  const Quat turn = rotationXyz({0.5f, 0.6f, 0.7f});
  EXPECT_TRUE(areConnected(a, geometry::transformed(cubeAt(Vec3::Zero()), turn, {0.9f, 0.0f, 0.0f}), kSlop));
  EXPECT_FALSE(areConnected(a, geometry::transformed(cubeAt(Vec3::Zero()), turn, {1.7f, 0.0f, 0.0f}), kSlop));
}

TEST(Connect, AnEdgeOnAFaceDoesNotHold) {
  const geometry::Convex a = cubeAt(Vec3::Zero());
  const Quat turn = rotationAbout(Vec3::UnitZ(), 0.25f * kPi);
  const float touching = 0.5f + 0.70710678f;
  for (const float gap : {-0.5f, 0.0f, 0.5f}) {
    const geometry::Convex b = geometry::transformed(cubeAt(Vec3::Zero()), turn, {touching + gap * kSlop, 0.0f, 0.0f});
    EXPECT_FALSE(areConnected(a, b, kSlop)) << gap;
  }
}

// The hard case B16 takes stones out of arches, rings and combs of a hundred.
TEST(Connect, PartsAreGroupedByWhatHangsTogether) {
  Scene scene;
  for (const float x : {0.0f, 5.0f, 1.0f, 2.0f, 6.0f, 9.0f}) scene.add(cubeAt({x, 0.0f, 0.0f}));
  std::vector<std::uint32_t> groups;
  connectParts(scene.parts, kSlop, groups);
  EXPECT_EQ(groups, (std::vector<std::uint32_t>{0, 1, 0, 0, 1, 2}));
}

TEST(Connect, AnchorsHoldByAreaOrByPoint) {
  ConnectScratch scratch;
  const geometry::Convex cube = cubeAt(Vec3::Zero());
  Anchor square{{{-0.5f, -0.5f, -0.5f}, {0.5f, -0.5f, -0.5f}, {0.5f, -0.5f, 0.5f}, {-0.5f, -0.5f, 0.5f}}, 4};
  EXPECT_TRUE(touchesAnchor(cube, square, kSlop, scratch));
  EXPECT_TRUE(touchesAnchor(cubeAt({0.99f, 0.0f, 0.0f}), square, kSlop, scratch));
  EXPECT_FALSE(touchesAnchor(cubeAt({1.01f, 0.0f, 0.0f}), square, kSlop, scratch));
  EXPECT_FALSE(touchesAnchor(cubeAt({0.0f, 0.01f, 0.0f}), square, kSlop, scratch));
  const Anchor point{{{0.5f, 0.5f, 0.5f}}, 1};
  EXPECT_TRUE(touchesAnchor(cube, point, kSlop, scratch));
  EXPECT_FALSE(touchesAnchor(cubeAt({-0.01f, 0.0f, 0.0f}), point, kSlop, scratch));
}

}  // namespace
}  // namespace brittle::fracture
