#include "engine/geometry/gjk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/geometry/cutting.h"
#include "tests/engine/geometry/shapes.h"

namespace brittle::geometry {
namespace {

using test::at;
using test::box;
using test::proxy;
using test::randomHull;
using test::randomPose;
using test::sphere;

Separation fresh(const Proxy& a, const Transform& poseA, const Proxy& b, const Transform& poseB) {
  SimplexCache cache;
  return separation(a, poseA, b, poseB, cache);
}

void expectSound(const Separation& s) {
  ASSERT_TRUE(isFinite(s.distance) && isFinite(s.normal) && isFinite(s.pointA) && isFinite(s.pointB));
  EXPECT_NEAR(s.normal.norm(), 1.0f, 1e-5f);
}

TEST(Gjk, BoxesAFaceApart) {
  const Convex a = box(Vec3(1.0f, 1.0f, 1.0f)), b = box(Vec3(0.5f, 0.5f, 0.5f));
  const Separation s = fresh(proxy(a), at(0.0f, 0.0f, 0.0f), proxy(b), at(0.2f, 1.75f, 0.1f));
  EXPECT_NEAR(s.distance, 0.25f, 1e-6f);
  EXPECT_NEAR(s.normal.y(), 1.0f, 1e-6f);
  EXPECT_NEAR(s.pointA.y(), 1.0f, 1e-6f);
  EXPECT_NEAR(s.pointB.y(), 1.25f, 1e-6f);
}

TEST(Gjk, BoxesACornerApart) {
  const Convex a = box(Vec3::Ones());
  const Separation s = fresh(proxy(a), at(0.0f, 0.0f, 0.0f), proxy(a), at(3.0f, 3.0f, 3.0f));
  EXPECT_NEAR(s.distance, std::sqrt(3.0f), 1e-6f);
  EXPECT_LT((s.pointA - Vec3::Ones()).norm(), 1e-6f);
  EXPECT_LT((s.pointB - Vec3::Constant(2.0f)).norm(), 1e-6f);
}

TEST(Gjk, RotatedBoxOnItsEdge) {
  const Convex a = box(Vec3::Ones());
  const Transform turned{Vec3(0.0f, 3.0f, 0.0f), rotationAbout(Vec3::UnitZ(), 0.25f * kPi)};
  const Separation s = fresh(proxy(a), at(0.0f, 0.0f, 0.0f), proxy(a), turned);
  EXPECT_NEAR(s.distance, 2.0f - std::sqrt(2.0f), 1e-6f);
  EXPECT_NEAR(s.normal.y(), 1.0f, 1e-6f);
}

TEST(Gjk, CrossedEdges) {
  const Convex a = box(Vec3(0.5f, 0.5f, 3.0f));
  const Transform poseA{Vec3::Zero(), rotationAbout(Vec3::UnitZ(), 0.25f * kPi)};
  const Convex b = box(Vec3(3.0f, 0.5f, 0.5f));
  const float reach = 0.5f * std::sqrt(2.0f);
  for (const float gap : {0.3f, 1e-3f, 1e-5f, -1e-5f, -1e-2f}) {
    const Transform poseB{Vec3(0.0f, 2.0f * reach + gap, 0.0f), rotationAbout(Vec3::UnitX(), 0.25f * kPi)};
    const Separation s = fresh(proxy(a), poseA, proxy(b), poseB);
    EXPECT_NEAR(s.distance, gap, 1e-6f);
    EXPECT_NEAR(s.normal.y(), 1.0f, 1e-5f) << gap;
    EXPECT_LT((s.pointA - Vec3(0.0f, reach, 0.0f)).norm(), 1e-5f);
  }
}

TEST(Gjk, SpheresAreExact) {
  const Separation apart =
      fresh(sphere(0.5f), at(0.0f, 0.0f, 0.0f), sphere(0.25f, Vec3(1.0f, 0.0f, 0.0f)), at(1.0f, 0.0f, 0.0f));
  EXPECT_EQ(apart.distance, 1.25f);
  EXPECT_EQ(apart.pointA.x(), 0.5f);
  EXPECT_EQ(apart.pointB.x(), 1.75f);
  const Separation deep = fresh(sphere(0.5f), at(0.0f, 0.0f, 0.0f), sphere(0.25f), at(0.0f, 0.25f, 0.0f));
  EXPECT_EQ(deep.distance, -0.5f);
  EXPECT_EQ(deep.normal.y(), 1.0f);
  const Separation same = fresh(sphere(0.5f), at(1.0f, 0.0f, 0.0f), sphere(0.25f), at(1.0f, 0.0f, 0.0f));
  EXPECT_EQ(same.distance, -0.75f);
  expectSound(same);
}

TEST(Gjk, SphereAgainstBox) {
  const Convex b = box(Vec3(1.0f, 0.5f, 2.0f));
  const Separation above = fresh(proxy(b), at(0.0f, 0.0f, 0.0f), sphere(0.25f), at(0.3f, 1.0f, 0.2f));
  EXPECT_NEAR(above.distance, 0.25f, 1e-6f);
  EXPECT_NEAR(above.normal.y(), 1.0f, 1e-6f);
  const Separation shallow = fresh(sphere(0.25f), at(0.3f, 0.7f, 0.2f), proxy(b), at(0.0f, 0.0f, 0.0f));
  EXPECT_NEAR(shallow.distance, -0.05f, 1e-6f);
  EXPECT_NEAR(shallow.normal.y(), -1.0f, 1e-6f);
  const Separation inside = fresh(sphere(0.25f), at(0.3f, 0.4f, 0.2f), proxy(b), at(0.0f, 0.0f, 0.0f));
  EXPECT_NEAR(inside.distance, -0.35f, 1e-6f);
  EXPECT_NEAR(inside.normal.y(), -1.0f, 1e-6f);
  const Separation surface = fresh(proxy(b), at(0.0f, 0.0f, 0.0f), sphere(0.25f), at(0.3f, 0.5f, 0.2f));
  EXPECT_NEAR(surface.distance, -0.25f, 1e-6f);
  EXPECT_NEAR(surface.normal.y(), 1.0f, 1e-6f);
}

/// Scales from a plain hull to a sliver: aspect 1e-4 in one or two directions.
Vec3 randomScale(Random& random) {
  Vec3 scale;
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t kind = random.nextBelow(4);
    scale[i] = kind == 0 ? 1e-4f : (kind == 1 ? 1e-2f : random.nextFloat(0.3f, 1.0f));
  }
  scale[random.nextBelow(3)] = 1.0f;
  return scale;
}

void compareWithSlowAnswer(const Convex& a, const Transform& poseA, const Convex& b, const Transform& poseB,
                           float tolerance) {
  const std::vector<Vec3d> pa = test::worldPoints(a, poseA), pb = test::worldPoints(b, poseB);
  const double depth = test::slowSeparation(a, pa, b, pb);
  const double expected = depth > 0.0 ? test::slowDistance(a, pa, b, pb) : depth;
  const Separation s = fresh(proxy(a), poseA, proxy(b), poseB);
  expectSound(s);
  EXPECT_NEAR(s.distance, expected, tolerance);
  // The normal is a separating direction of that depth, and the points are that far apart along it.
  EXPECT_GE(test::widthAlong(pa, pb, s.normal.cast<double>()), expected - static_cast<double>(tolerance));
  EXPECT_NEAR((s.pointB - s.pointA).dot(s.normal), s.distance, tolerance);
}

TEST(Gjk, DistanceOfRandomHullsAgreesWithBruteForce) {
  Random random(21);
  for (int i = 0; i < 250; ++i) {
    const Convex a = randomHull(random, 12, Vec3::Ones()), b = randomHull(random, 10, Vec3::Ones());
    compareWithSlowAnswer(a, randomPose(random, 1.5f), b, randomPose(random, 1.5f), 1e-5f);
  }
}

TEST(Gjk, SliversAgreeWithBruteForce) {
  Random random(22);
  for (int i = 0; i < 250; ++i) {
    const Convex a = randomHull(random, 10, randomScale(random)), b = randomHull(random, 10, randomScale(random));
    compareWithSlowAnswer(a, randomPose(random, 0.6f), b, randomPose(random, 0.6f), 1e-5f);
  }
}

TEST(Gjk, DeepOverlapsAgreeWithBruteForce) {
  Random random(23);
  for (int i = 0; i < 150; ++i) {
    const Convex a = randomHull(random, 12, Vec3::Ones()), b = randomHull(random, 12, Vec3::Constant(0.5f));
    compareWithSlowAnswer(a, randomPose(random, 0.3f), b, randomPose(random, 0.3f), 1e-5f);
  }
}

TEST(Gjk, SmallShardsFarFromTheirFrameKeepTheirPrecision) {
  Random random(24);
  for (int i = 0; i < 100; ++i) {
    const Vec3 offset(3.0f, -2.0f, 1.0f);
    const Convex a = randomHull(random, 10, Vec3::Constant(0.01f), offset),
                 b = randomHull(random, 10, Vec3::Constant(0.01f), offset);
    const Transform pose = randomPose(random, 2.0f);
    Transform other = pose;
    for (int k = 0; k < 3; ++k) other.position[k] += random.nextFloat(-0.02f, 0.02f);
    compareWithSlowAnswer(a, pose, b, other, 1e-6f);
  }
}

TEST(Gjk, CoplanarNeighboursTouchAtZeroAlongTheirFace) {
  Random random(25);
  for (int i = 0; i < 100; ++i) {
    // Two boxes that share a face, in one body frame at any pose.
    const float cut = random.nextFloat(-0.5f, 0.5f);
    const Convex a = box(Vec3(0.5f * (1.0f + cut), 1.0f, 0.01f), Vec3(0.5f * (cut - 1.0f), 0.0f, 0.0f));
    const Convex b = box(Vec3(0.5f * (1.0f - cut), 1.0f, 0.01f), Vec3(0.5f * (1.0f + cut), 0.0f, 0.0f));
    const Transform pose = randomPose(random, 5.0f);
    const Separation s = fresh(proxy(a), pose, proxy(b), pose);
    expectSound(s);
    EXPECT_NEAR(s.distance, 0.0f, 2e-6f);
    EXPECT_LT((s.normal - pose.rotate(Vec3::UnitX())).norm(), 1e-3f);
  }
}

TEST(Gjk, SymmetricInItsArguments) {
  Random random(26);
  for (int i = 0; i < 200; ++i) {
    const Convex a = randomHull(random, 9, randomScale(random)), b = randomHull(random, 12, Vec3::Ones());
    const Transform poseA = randomPose(random, 1.0f), poseB = randomPose(random, 1.0f);
    const Separation ab = fresh(proxy(a), poseA, proxy(b), poseB), ba = fresh(proxy(b), poseB, proxy(a), poseA);
    EXPECT_NEAR(ab.distance, ba.distance, 2e-6f);
    if (ab.distance > 1e-3f) {
      EXPECT_LT((ab.normal + ba.normal).norm(), 1e-4f);
    }
  }
}

TEST(Gjk, WarmStartsGiveTheSameAnswerFromAnyCache) {
  Random random(27);
  const Convex a = randomHull(random, 12, Vec3::Ones()), b = randomHull(random, 12, Vec3(1.0f, 0.2f, 0.05f));
  SimplexCache cache;
  for (int i = 0; i < 500; ++i) {
    const Transform poseA = randomPose(random, 1.0f), poseB = randomPose(random, 1.0f);
    if (i % 5 == 0) {  // garbage, out of range indices too
      cache.count = static_cast<std::uint8_t>(random.nextBelow(256));
      cache.axis = random.nextBelow(80);
      for (int k = 0; k < 4; ++k) {
        cache.a[k] = static_cast<std::uint16_t>(random.nextBelow(16));
        cache.b[k] = static_cast<std::uint16_t>(random.nextBelow(16));
      }
    }
    const Separation warm = separation(proxy(a), poseA, proxy(b), poseB, cache);
    EXPECT_NEAR(warm.distance, fresh(proxy(a), poseA, proxy(b), poseB).distance, 2e-6f);
  }
}

TEST(Gjk, StoppingEarlyOnlySaysThatItIsTooFar) {
  Random random(29);
  const Convex a = randomHull(random, 12, Vec3::Ones()), b = randomHull(random, 12, Vec3(1.0f, 0.2f, 0.05f));
  SimplexCache cache;
  for (int i = 0; i < 2000; ++i) {
    const Transform poseA = randomPose(random, 1.5f), poseB = randomPose(random, 1.5f);
    const Separation exact = fresh(proxy(a), poseA, proxy(b), poseB);
    const float limit = i % 3 == 0 ? exact.distance : random.nextFloat(0.0f, 1.0f);
    const Separation early = separation(proxy(a), poseA, proxy(b), poseB, cache, limit);
    if (early.distance > limit) {
      EXPECT_LE(early.distance, exact.distance + 2e-6f);
      EXPECT_NEAR(early.normal.norm(), 1.0f, 1e-5f);
    } else {
      EXPECT_NEAR(early.distance, exact.distance, 2e-6f);
      EXPECT_LT((early.normal - exact.normal).norm(), 1e-2f);
    }
  }
}

TEST(Gjk, NothingIsEverNotFinite) {
  Random random(28);
  const Convex flat = box(Vec3(1.0f, 0.0f, 1.0f)), line = box(Vec3(1.0f, 0.0f, 0.0f)), point = box(Vec3::Zero()),
               cube = box(Vec3::Ones());
  const Convex* shapes[] = {&flat, &line, &point, &cube};
  for (const Convex* a : shapes)
    for (const Convex* b : shapes)
      for (int i = 0; i < 40; ++i) {
        Transform pose = i % 2 == 0 ? Transform{} : randomPose(random, 1.0f);
        if (i % 4 == 1) pose.rotation = Quat::Identity();
        expectSound(fresh(proxy(*a), Transform{}, proxy(*b), pose));
      }
}

TEST(Gjk, OverlapsAgreesWithTheDistance) {
  Random random(29);
  for (int i = 0; i < 500; ++i) {
    const Convex a = randomHull(random, 10, randomScale(random)), b = randomHull(random, 10, Vec3::Ones());
    const Transform poseA = randomPose(random, 1.2f), poseB = randomPose(random, 1.2f);
    const float distance = fresh(proxy(a), poseA, proxy(b), poseB).distance;
    const float margin = random.nextFloat(0.0f, 0.5f);
    if (std::abs(distance - margin) > 1e-5f) {
      EXPECT_EQ(overlaps(proxy(a), poseA, proxy(b), poseB, margin), distance < margin);
    }
    const Proxy ball = sphere(0.3f);
    const float reach = fresh(proxy(a), poseA, ball, poseB).distance;
    if (std::abs(reach - margin) > 1e-5f) {
      EXPECT_EQ(overlaps(proxy(a), poseA, ball, poseB, margin), reach < margin);
    }
  }
}

// Fresh neighbours touch along their cut, where edges of both lie in one plane and need not meet.
TEST(Gjk, ClosestPointsOfTouchingPiecesAreAsFarApartAsTheDistanceSays) {
  for (const std::uint64_t seed : {112, 113, 114, 115}) {
    CutCube<float> cube(CutMode::AtRandom, seed, 48);
    while (!cube.isFull()) cube.step();
    for (std::size_t i = 0; i < cube.count(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Separation s = fresh(proxy(cube.piece(i)), Transform{}, proxy(cube.piece(k)), Transform{});
        EXPECT_NEAR((s.pointB - s.pointA).norm(), std::abs(s.distance), 1e-5f) << "pieces " << i << " and " << k;
      }
    }
  }
}

}  // namespace
}  // namespace brittle::geometry
