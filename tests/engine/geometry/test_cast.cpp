#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/geometry/gjk.h"
#include "tests/engine/geometry/shapes.h"

namespace brittle::geometry {
namespace {

using test::at;
using test::box;
using test::proxy;
using test::randomHull;
using test::randomPose;
using test::sphere;

Motion resting(const Transform& pose) {
  return {pose, pose.position, Vec3::Zero(), Vec3::Zero()};
}
Motion moving(const Transform& pose, const Vec3& velocity) {
  return {pose, pose.position, velocity, Vec3::Zero()};
}

float distanceAt(const Proxy& a, const Motion& motionA, const Proxy& b, const Motion& motionB, float time) {
  SimplexCache cache;
  return separation(a, poseAt(motionA, time), b, poseAt(motionB, time), cache).distance;
}

TEST(TimeOfImpact, BallAgainstAWall) {
  const Convex wall = box(Vec3(5.0f, 5.0f, 0.05f));
  const Motion ball = moving(at(0.3f, 0.2f, 3.0f), Vec3(0.0f, 0.0f, -40.0f));
  const Impact impact = timeOfImpact(sphere(0.25f), ball, proxy(wall), resting(at(0.0f, 0.0f, 0.0f)), 0.1f, 0.001f);
  ASSERT_TRUE(impact.hit);
  EXPECT_NEAR(impact.time, (3.0f - 0.25f - 0.05f) / 40.0f, 0.001f / 40.0f + 1e-6f);
  EXPECT_NEAR(impact.normal.z(), -1.0f, 1e-5f);
  EXPECT_NEAR(impact.point.z(), 0.05f, 0.001f);
}

TEST(TimeOfImpact, NothingPassesThroughAThinPaneAtAnySpeed) {
  const Convex pane = box(Vec3(1.0f, 1.0f, 0.002f));
  for (float speed = 1.0f; speed < 2000.0f; speed *= 1.7f) {
    const Motion ball = moving(at(0.1f, 0.1f, 0.5f), Vec3(0.3f, 0.2f, -1.0f) * speed);
    const Impact impact =
        timeOfImpact(sphere(0.01f), ball, proxy(pane), resting(at(0.0f, 0.0f, 0.0f)), 2.0f / speed, 0.0005f);
    ASSERT_TRUE(impact.hit) << speed;
    EXPECT_NEAR(impact.time * speed, 0.488f, 0.001f);
  }
}

TEST(TimeOfImpact, SpinningRodHitsTheWallWithItsTip) {
  // The tip of a rod of half length 1 turning at 10 rad/s is sin(10 t) off the axis.
  const Convex rod = box(Vec3(1.0f, 1e-4f, 1e-4f)), wall = box(Vec3(3.0f, 0.5f, 3.0f));
  Motion motion = resting(at(0.0f, 0.0f, 0.0f));
  motion.angularVelocity = Vec3(0.0f, 0.0f, 10.0f);
  const Impact impact = timeOfImpact(proxy(rod), motion, proxy(wall), resting(at(0.0f, -1.1f, 0.0f)), 0.5f, 0.001f);
  ASSERT_TRUE(impact.hit);
  EXPECT_NEAR(impact.time, std::asin(0.6f) / 10.0f, 0.0002f);
  EXPECT_NEAR(impact.normal.y(), -1.0f, 1e-4f);
}

TEST(TimeOfImpact, TheCentreOfTurningIsTheMotionsNotTheFrames) {
  const Convex rod = box(Vec3(0.1f, 0.1f, 0.1f), Vec3(5.0f, 0.0f, 0.0f));
  Motion motion{at(0.0f, 0.0f, 0.0f), Vec3(5.0f, 0.0f, 0.0f), Vec3(0.0f, -1.0f, 0.0f), Vec3(0.0f, 0.0f, 20.0f)};
  const Transform later = poseAt(motion, 0.5f);
  EXPECT_LT((later.toWorld(Vec3(5.0f, 0.0f, 0.0f)) - Vec3(5.0f, -0.5f, 0.0f)).norm(), 1e-5f);
  const Convex floor = box(Vec3(10.0f, 1.0f, 10.0f));
  EXPECT_FALSE(timeOfImpact(proxy(rod), motion, proxy(floor), resting(at(0.0f, -1.7f, 0.0f)), 0.5f, 0.001f).hit);
}

TEST(TimeOfImpact, WithinTheTargetHitsAtOnceOnlyIfApproaching) {
  const Convex cube = box(Vec3::Ones());
  const Motion floor = resting(at(0.0f, 0.0f, 0.0f)), above = resting(at(0.2f, 2.0005f, 0.1f));
  const auto cast = [&](const Vec3& velocity) {
    Motion motion = above;
    motion.velocity = velocity;
    return timeOfImpact(proxy(cube), floor, proxy(cube), motion, 1.0f / 60.0f, 0.001f);
  };
  EXPECT_TRUE(cast(Vec3(0.0f, -1.0f, 0.0f)).hit);
  EXPECT_EQ(cast(Vec3(0.0f, -1.0f, 0.0f)).time, 0.0f);
  EXPECT_FALSE(cast(Vec3(0.0f, 1.0f, 0.0f)).hit);
  EXPECT_FALSE(cast(Vec3(20.0f, 0.0f, 0.0f)).hit);
  EXPECT_FALSE(cast(Vec3::Zero()).hit);
}

/// Two random things on passing courses, spinning.
struct Passing {
  Convex a, b;
  Proxy proxyA, proxyB;
  Motion motionA, motionB;
  Passing(Random& random, bool ball) {
    a = randomHull(random, 8, Vec3(0.5f, 0.2f, 0.1f));
    b = randomHull(random, 8, Vec3(0.4f, 0.4f, 0.05f));
    proxyA = ball ? sphere(0.25f) : proxy(a);
    proxyB = proxy(b);
    motionA = resting(randomPose(random, 0.5f));
    motionB = resting(randomPose(random, 0.5f));
    motionB.pose.position.z() -= 3.0f;
    motionB.center = motionB.pose.position;
    for (int i = 0; i < 3; ++i) motionA.angularVelocity[i] = random.nextFloat(-8.0f, 8.0f);
    for (int i = 0; i < 3; ++i) motionB.angularVelocity[i] = random.nextFloat(-8.0f, 8.0f);
    motionA.velocity = Vec3(random.nextFloat(-1.0f, 1.0f), 0.0f, -30.0f);
    motionB.velocity = Vec3(0.0f, random.nextFloat(-2.0f, 2.0f), 0.0f);
  }
};

TEST(TimeOfImpact, GrazesNeverHitAndRealHitsAreNeverLateOrMissed) {
  Random random(31);
  const float duration = 0.2f, target = 0.002f;
  int hits = 0, misses = 0;
  for (int i = 0; i < 3000; ++i) {
    const Passing pass(random, i % 3 == 0);
    const Impact impact = timeOfImpact(pass.proxyA, pass.motionA, pass.proxyB, pass.motionB, duration, target);
    const auto gap = [&](float time) { return distanceAt(pass.proxyA, pass.motionA, pass.proxyB, pass.motionB, time); };
    if (impact.hit) {
      ++hits;
      ASSERT_LE(gap(impact.time), target * 1.001f);  // so the least distance is not above the target: no ghost
    } else {
      ++misses;
      ASSERT_EQ(impact.time, duration) << "gave up";
    }
    // Nothing closer than the aim before the time reported: neither late nor missed.
    const float until = impact.hit ? impact.time : duration;
    for (int k = 0; k < 40; ++k) ASSERT_GE(gap(until * static_cast<float>(k) / 40.0f), 0.75f * target - 1e-5f);
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 500);
}

TEST(TimeOfImpact, TenThousandGrazesAtATargetBelowTheirLeastDistanceMiss) {
  Random random(32);
  const Convex pane = box(Vec3(0.5f, 0.5f, 0.01f));
  for (int i = 0; i < 10000; ++i) {
    // A ball passes the pane's rim at a known least distance.
    const float radius = random.nextFloat(0.05f, 0.3f), gap = random.nextFloat(1e-4f, 0.05f),
                speed = random.nextFloat(1.0f, 200.0f);
    const Motion ball = moving(at(random.nextFloat(-0.4f, 0.4f), 0.5f + radius + gap, 1.0f), Vec3(0.0f, 0.0f, -speed));
    const Transform pose = at(0.0f, 0.0f, 0.0f);
    ASSERT_FALSE(timeOfImpact(sphere(radius), ball, proxy(pane), resting(pose), 2.0f / speed, 0.98f * gap).hit);
    ASSERT_TRUE(timeOfImpact(sphere(radius), ball, proxy(pane), resting(pose), 2.0f / speed, 1.4f * gap).hit);
  }
}

TEST(CastRay, AgainstABox) {
  const Convex b = box(Vec3(1.0f, 2.0f, 3.0f));
  const Transform pose{Vec3(1.0f, 0.0f, 0.0f), rotationAbout(Vec3::UnitZ(), 0.5f * kPi)};  // now 2 x 1 x 3
  const RayHit hit = castRay(proxy(b), pose, Vec3(1.5f, 5.0f, 0.5f), Vec3(1.5f, -5.0f, 0.5f));
  ASSERT_TRUE(hit.hit);
  EXPECT_NEAR(hit.fraction, 0.4f, 1e-6f);
  EXPECT_NEAR(hit.normal.y(), 1.0f, 1e-6f);
  EXPECT_FALSE(castRay(proxy(b), pose, Vec3(1.5f, 5.0f, 0.5f), Vec3(1.5f, 1.01f, 0.5f)).hit);  // too short
  EXPECT_FALSE(castRay(proxy(b), pose, Vec3(1.5f, 0.0f, 0.5f), Vec3(1.5f, 5.0f, 0.5f)).hit);   // starts inside
  EXPECT_FALSE(castRay(proxy(b), pose, Vec3(4.0f, 5.0f, 0.5f), Vec3(4.0f, -5.0f, 0.5f)).hit);  // beside
  EXPECT_FALSE(castRay(proxy(b), pose, Vec3(1.5f, 3.0f, 0.5f), Vec3(1.5f, 5.0f, 0.5f)).hit);   // away
}

TEST(CastRay, AgainstASphere) {
  const Proxy ball = sphere(0.5f, Vec3(0.0f, 1.0f, 0.0f));
  const RayHit hit = castRay(ball, at(2.0f, 0.0f, 0.0f), Vec3(0.0f, 1.0f, 0.0f), Vec3(4.0f, 1.0f, 0.0f));
  ASSERT_TRUE(hit.hit);
  EXPECT_NEAR(hit.fraction, 1.5f / 4.0f, 1e-6f);
  EXPECT_NEAR(hit.normal.x(), -1.0f, 1e-6f);
  EXPECT_FALSE(castRay(ball, at(2.0f, 0.0f, 0.0f), Vec3(2.0f, 1.0f, 0.0f), Vec3(4.0f, 1.0f, 0.0f)).hit);
  EXPECT_FALSE(castRay(ball, at(2.0f, 0.0f, 0.0f), Vec3(0.0f, 1.6f, 0.0f), Vec3(4.0f, 1.6f, 0.0f)).hit);
}

TEST(CastRay, EntersWhereThePointComesInside) {
  Random random(33);
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const Convex hull = randomHull(random, 10, Vec3(1.0f, 0.3f, 0.6f));
    const Transform pose = randomPose(random, 0.5f);
    const Vec3 from = randomPose(random, 2.0f).position, to = randomPose(random, 2.0f).position;
    const RayHit hit = castRay(proxy(hull), pose, from, to);
    const auto pointAt = [&](float t) { return Vec3(from + (to - from) * t); };
    if (!hit.hit) {
      if (containsPoint(proxy(hull), pose, from)) continue;
      for (int k = 0; k <= 50; ++k) {
        SimplexCache cache;
        const Proxy point = sphere(0.0f, pointAt(static_cast<float>(k) / 50.0f));
        ASSERT_GT(separation(proxy(hull), pose, point, Transform{}, cache).distance, -1e-5f);
      }
      continue;
    }
    ++hits;
    EXPECT_FALSE(containsPoint(proxy(hull), pose, pointAt(hit.fraction - 1e-4f)));
    EXPECT_LT(hit.normal.dot(to - from), 0.0f);
    SimplexCache cache;
    EXPECT_NEAR(separation(proxy(hull), pose, sphere(0.0f, pointAt(hit.fraction)), Transform{}, cache).distance, 0.0f,
                1e-5f);
  }
  EXPECT_GT(hits, 50);
}

TEST(ContainsPoint, TheSurfaceCounts) {
  const Convex b = box(Vec3(1.0f, 2.0f, 3.0f));
  Random random(34);
  for (int i = 0; i < 200; ++i) {
    const Transform pose = randomPose(random, 20.0f);
    for (const Vertex& vertex : b.vertices) {
      EXPECT_TRUE(containsPoint(proxy(b), pose, pose.toWorld(vertex.point)));
      EXPECT_FALSE(containsPoint(proxy(b), pose, pose.toWorld(vertex.point * 1.001f)));
    }
  }
}

TEST(BoundsOf, HoldAllVerticesAndNoMore) {
  Random random(35);
  for (int i = 0; i < 100; ++i) {
    const Convex hull = randomHull(random, 9, Vec3(1.0f, 0.3f, 0.6f));
    const Transform pose = randomPose(random, 5.0f);
    Aabb expected;
    for (const Vec3d& point : test::worldPoints(hull, pose)) expected.include(Vec3(point.cast<float>()));
    const Aabb bounds = boundsOf(proxy(hull), pose);
    EXPECT_LT((bounds.low - expected.low).norm() + (bounds.high - expected.high).norm(), 5e-6f);
  }
  const Aabb ball = boundsOf(sphere(0.5f, Vec3(1.0f, 0.0f, 0.0f)), at(1.0f, 2.0f, 3.0f));
  EXPECT_LT((ball.low - Vec3(1.5f, 1.5f, 2.5f)).norm() + (ball.high - Vec3(2.5f, 2.5f, 3.5f)).norm(), 1e-6f);
}

}  // namespace
}  // namespace brittle::geometry
