#include "engine/fracture/connect.h"

#include <gtest/gtest.h>

#include <functional>

#include "engine/core/random.h"
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

/// Islands of a scene with one part taken away, by the plainest possible means.
std::vector<std::uint32_t> oracle(std::size_t count, const std::function<bool(std::size_t, std::size_t)>& touch) {
  std::vector<std::uint32_t> group(count, 0xffffffff);
  std::uint32_t next = 0;
  for (std::size_t seed = 0; seed < count; ++seed) {
    if (group[seed] != 0xffffffff) continue;
    std::vector<std::size_t> open{seed};
    group[seed] = next;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      for (std::size_t other = 0; other < count; ++other) {
        if (group[other] != 0xffffffff || !touch(at, other)) continue;
        group[other] = next;
        open.push_back(other);
      }
    }
    ++next;
  }
  return group;
}

/// Takes each of the parts away in turn; `touch` knows by construction which parts touch.
void removeEach(const Scene& scene, const std::function<bool(std::size_t, std::size_t)>& touch) {
  for (std::size_t removed = 0; removed < scene.parts.size(); ++removed) {
    std::vector<Part> parts;
    std::vector<std::size_t> names;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
      if (i == removed) continue;
      parts.push_back(scene.parts[i]);
      names.push_back(i);
    }
    std::vector<std::uint32_t> groups;
    connectParts(parts, kSlop, groups);
    const auto expected = oracle(names.size(), [&](std::size_t a, std::size_t b) { return touch(names[a], names[b]); });
    ASSERT_EQ(groups, expected) << "without part " << removed;
  }
}

/// A voussoir of a ring in the XY plane, from angle to angle.
geometry::Convex wedge(float from, float to) {
  std::vector<Vec3> points;
  for (const float z : {-0.2f, 0.2f}) {
    for (const float angle : {from, to}) {
      for (const float radius : {3.0f, 3.5f}) points.push_back({radius * cosine(angle), radius * sine(angle), z});
    }
  }
  return geometry::makeHull(points).value();
}

TEST(Connect, ChainFallsInTwoWhateverLinkGoes) {
  Scene scene;
  for (int i = 0; i < 100; ++i) scene.addBox({0.05f, 0.05f, 0.05f}, {0.1f * static_cast<float>(i), 0.0f, 0.0f});
  removeEach(scene, [](std::size_t a, std::size_t b) { return a + 1 == b || b + 1 == a; });
}

TEST(Connect, RingStaysOneWhateverStoneGoes) {
  Scene scene;
  for (int i = 0; i < 100; ++i) {
    const float step = 2.0f * kPi / 100.0f;
    scene.add(wedge(step * static_cast<float>(i), step * static_cast<float>(i + 1)));
  }
  removeEach(scene, [](std::size_t a, std::size_t b) { return (a + 1) % 100 == b || (b + 1) % 100 == a; });
}

TEST(Connect, ArchFallsInTwoWhateverStoneGoes) {
  Scene scene;
  for (int i = 0; i < 100; ++i) {
    const float step = kPi / 100.0f;
    scene.add(wedge(step * static_cast<float>(i), step * static_cast<float>(i + 1)));
  }
  removeEach(scene, [](std::size_t a, std::size_t b) { return a + 1 == b || b + 1 == a; });
}

TEST(Connect, CombLosesATooth) {
  Scene scene;  // 50 blocks of the spine, each with a tooth below
  for (int i = 0; i < 50; ++i) {
    scene.addBox({0.1f, 0.1f, 0.1f}, {0.2f * static_cast<float>(i), 0.0f, 0.0f});
    scene.addBox({0.05f, 0.2f, 0.1f}, {0.2f * static_cast<float>(i), -0.3f, 0.0f});
  }
  removeEach(scene, [](std::size_t a, std::size_t b) {
    if (a / 2 == b / 2) return a != b;
    return a % 2 == 0 && b % 2 == 0 && (a + 2 == b || b + 2 == a);
  });
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
