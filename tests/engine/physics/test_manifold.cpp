#include "engine/physics/manifold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/geometry/make.h"

namespace brittle::physics {
namespace {

using geometry::Convex;
using geometry::Proxy;

Convex box(float x, float y, float z) {
  return geometry::makeBox<float>(Vec3(x, y, z));
}
Proxy proxy(const Convex& convex) {
  return {convex.view(), Vec3::Zero(), 0.0f};
}
Proxy ball(float radius) {
  return {{}, Vec3::Zero(), radius};
}
Transform at(float x, float y, float z) {
  return {Vec3(x, y, z), Quat::Identity()};
}

constexpr ManifoldSettings kClipped{ManifoldKind::Clipped, 0.0f};
constexpr ManifoldSettings kRecycling{ManifoldKind::Clipped, 0.1f};
constexpr ManifoldSettings kIncremental{ManifoldKind::Incremental, 0.1f};

/// What every manifold promises: anchors that are `separation` apart along a unit normal, points within the margin.
void expectConsistent(const Manifold& m, const Transform& poseA, const Transform& poseB, float margin) {
  ASSERT_GE(m.count, 0);
  ASSERT_LE(m.count, kMaxPoints);
  EXPECT_NEAR(m.normal.norm(), 1.0f, 1e-5f);
  for (int i = 0; i < m.count; ++i) {
    const Vec3 apart = poseB.toWorld(m.points[i].localB) - poseA.toWorld(m.points[i].localA);
    EXPECT_NEAR(apart.dot(m.normal), m.points[i].separation, 1e-5f);
    EXPECT_LE(m.points[i].separation, margin + 1e-5f);
  }
}

Manifold fresh(const Convex& a, const Transform& poseA, const Convex& b, const Transform& poseB, float margin,
               float size = 0.5f) {
  Manifold m;
  updateManifold(proxy(a), poseA, size, proxy(b), poseB, size, margin, kClipped, m);
  expectConsistent(m, poseA, poseB, margin);
  return m;
}

/// True if some point lies at (x, z) in the world.
bool hasPointAt(const Manifold& m, const Transform& poseA, float x, float z) {
  for (int i = 0; i < m.count; ++i) {
    const Vec3 p = poseA.toWorld(m.points[i].localA);
    if (std::abs(p.x() - x) < 1e-4f && std::abs(p.z() - z) < 1e-4f) return true;
  }
  return false;
}

TEST(Manifold, BoxOnBoxHasFourPointsAtTheCornersOfTheCommonArea) {
  const Convex floor = box(2.0f, 0.5f, 2.0f), cube = box(0.5f, 0.5f, 0.5f);
  for (const float gap : {-0.01f, 0.0f, 0.01f, 0.5f}) {
    const Transform above = at(1.75f, 1.0f + gap, 0.25f);
    const Manifold m = fresh(floor, at(0.0f, 0.0f, 0.0f), cube, above, 0.6f);
    ASSERT_EQ(m.count, 4) << gap;
    EXPECT_NEAR(m.normal.y(), 1.0f, 1e-6f);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(m.points[i].separation, gap, 1e-6f);
    for (const float x : {1.25f, 2.0f})
      for (const float z : {-0.25f, 0.75f})
        EXPECT_TRUE(hasPointAt(m, Transform{}, x, z)) << gap << " " << x << " " << z;
    const Manifold turned = fresh(cube, above, floor, at(0.0f, 0.0f, 0.0f), 0.6f);
    EXPECT_EQ(turned.count, 4);
    EXPECT_NEAR(turned.normal.y(), -1.0f, 1e-6f);
  }
}

TEST(Manifold, NoPointsBeyondTheMargin) {
  const Convex cube = box(0.5f, 0.5f, 0.5f);
  EXPECT_EQ(fresh(cube, at(0.0f, 0.0f, 0.0f), cube, at(0.0f, 1.021f, 0.0f), 0.02f).count, 0);
  EXPECT_EQ(fresh(cube, at(0.0f, 0.0f, 0.0f), cube, at(0.0f, 1.019f, 0.0f), 0.02f).count, 4);
}

TEST(Manifold, TiltedBoxTouchesWithItsEdge) {
  const Convex floor = box(2.0f, 0.5f, 2.0f), cube = box(0.5f, 0.5f, 0.5f);
  for (const float angle : {0.02f, 0.3f, 0.25f * kPi}) {
    const float reach = 0.5f * (cosine(angle) + sine(angle));
    const Transform pose{Vec3(0.0f, 0.5f + reach - 0.001f, 0.0f), rotationAbout(Vec3::UnitZ(), angle)};
    const Manifold m = fresh(floor, Transform{}, cube, pose, 0.005f);
    ASSERT_EQ(m.count, 2) << angle;
    EXPECT_NEAR(m.normal.y(), 1.0f, 1e-4f);
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(m.points[i].separation, -0.001f, 1e-5f);
  }
}

TEST(Manifold, AFoldedUndersideIsHeldByAllItsCorners) {
  // The corners of the underside are not in one plane: two triangles, of which only one can be the incident face.
  const Convex floor = box(2.0f, 0.5f, 2.0f);
  const std::vector<Vec3> points = {Vec3(-0.1f, 0.0f, -0.1f), Vec3(0.1f, 0.0005f, -0.1f), Vec3(0.1f, 0.0f, 0.1f),
                                    Vec3(-0.1f, 0.0005f, 0.1f), Vec3(0.01f, 0.02f, 0.0f)};
  const auto shard = geometry::makeHull(points);
  ASSERT_TRUE(static_cast<bool>(shard));
  for (const bool swapped : {false, true}) {
    Manifold m;
    const Transform above = at(0.0f, 0.4999f, 0.0f);
    if (swapped)
      updateManifold(proxy(shard.value()), above, 0.01f, proxy(floor), Transform{}, 0.5f, 0.005f, kClipped, m);
    else
      updateManifold(proxy(floor), Transform{}, 0.5f, proxy(shard.value()), above, 0.01f, 0.005f, kClipped, m);
    EXPECT_EQ(m.count, 4);
  }
}

TEST(Manifold, NearlyParallelFacesAtADistanceGiveFourPoints) {
  const Convex floor = box(2.0f, 0.5f, 2.0f), cube = box(0.5f, 0.5f, 0.5f);
  const Transform pose{Vec3(0.0f, 1.5f, 0.0f), rotationAbout(Vec3(0.6f, 0.0f, 0.8f), 0.01f)};
  const Manifold m = fresh(floor, Transform{}, cube, pose, 1.0f);
  EXPECT_EQ(m.count, 4);
  EXPECT_NEAR(m.normal.y(), 1.0f, 1e-6f);
}

TEST(Manifold, CrossedEdgesHaveOnePoint) {
  const Convex a = box(0.5f, 0.5f, 3.0f), b = box(3.0f, 0.5f, 0.5f);
  const float reach = 0.5f * std::sqrt(2.0f);
  const Transform poseA{Vec3::Zero(), rotationAbout(Vec3::UnitZ(), 0.25f * kPi)};
  const Transform poseB{Vec3(0.0f, 2.0f * reach - 0.002f, 0.0f), rotationAbout(Vec3::UnitX(), 0.25f * kPi)};
  const Manifold m = fresh(a, poseA, b, poseB, 0.02f);
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.normal.y(), 1.0f, 1e-5f);
  EXPECT_NEAR(m.points[0].separation, -0.002f, 1e-5f);
}

TEST(Manifold, BallsHaveOnePointWhateverTheKind) {
  const Convex cube = box(0.5f, 0.5f, 0.5f);
  for (const ManifoldSettings& settings : {kClipped, kRecycling, kIncremental}) {
    Manifold m;
    for (int tick = 0; tick < 20; ++tick) {
      const Transform pose{Vec3(0.02f * static_cast<float>(tick), 0.74f, 0.0f),
                           rotationAbout(Vec3::UnitZ(), 0.3f * static_cast<float>(tick))};
      updateManifold(proxy(cube), Transform{}, 0.5f, ball(0.25f), pose, 0.25f, 0.02f, settings, m);
      expectConsistent(m, Transform{}, pose, 0.02f);
      ASSERT_EQ(m.count, 1);
      EXPECT_NEAR(m.points[0].separation, -0.01f, 1e-6f);
      if (tick > 0) {
        EXPECT_EQ(m.points[0].normalImpulse, 7.0f);
      }
      m.points[0].normalImpulse = 7.0f;
    }
  }
}

TEST(Manifold, ASlidingTurningBoxKeepsItsImpulses) {
  const Convex floor = box(5.0f, 0.5f, 5.0f), cube = box(0.5f, 0.5f, 0.5f);
  for (const ManifoldSettings& settings : {kClipped, kRecycling}) {
    Manifold m;
    for (int tick = 0; tick < 120; ++tick) {
      const float t = static_cast<float>(tick) / 60.0f;
      const Transform pose{Vec3(t, 0.999f, 0.5f * t), rotationAbout(Vec3::UnitY(), t)};
      updateManifold(proxy(floor), Transform{}, 0.5f, proxy(cube), pose, 0.5f, 0.02f, settings, m);
      expectConsistent(m, Transform{}, pose, 0.02f);
      ASSERT_EQ(m.count, 4);
      EXPECT_NEAR(m.normal.y(), 1.0f, 1e-5f);
      // Impulses are named by the corner of the cube they belong to.
      for (int i = 0; i < 4; ++i) {
        const Vec3& corner = m.points[i].localB;
        const float name = (corner.x() > 0.0f ? 1.0f : 2.0f) + (corner.z() > 0.0f ? 10.0f : 20.0f);
        if (tick > 0) {
          EXPECT_EQ(m.points[i].normalImpulse, name) << "tick " << tick;
        }
        m.points[i].normalImpulse = name;
      }
    }
  }
}

TEST(Manifold, RestingPairIsOnlyRefreshedButWithItsTrueSeparations) {
  const Convex floor = box(5.0f, 0.5f, 5.0f), cube = box(0.5f, 0.5f, 0.5f);
  Manifold m;
  updateManifold(proxy(floor), Transform{}, 0.5f, proxy(cube), at(0.0f, 1.0f, 0.0f), 0.5f, 0.02f, kRecycling, m);
  ASSERT_TRUE(m.computed);
  const Transform computedAt = m.computedAt;
  const float angle = 0.002f;
  const Transform rocked{Vec3(0.0f, 1.001f, 0.0f), rotationAbout(Vec3::UnitZ(), angle)};
  updateManifold(proxy(floor), Transform{}, 0.5f, proxy(cube), rocked, 0.5f, 0.02f, kRecycling, m);
  EXPECT_EQ(m.computedAt.position, computedAt.position);  // not computed again
  ASSERT_EQ(m.count, 4);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(m.points[i].separation, rocked.toWorld(m.points[i].localB).y() - 0.5f, 1e-6f);
  // Both turning together by a lot is not moving either, and the normal turns with them.
  const Transform world{Vec3(3.0f, 1.0f, -2.0f), rotationAbout(Vec3(0.6f, 0.0f, 0.8f), 1.2f)};
  updateManifold(proxy(floor), world, 0.5f, proxy(cube), world * rocked, 0.5f, 0.02f, kRecycling, m);
  EXPECT_LT((m.computedAt.position - computedAt.position).norm(), 1e-9f);
  EXPECT_LT((m.normal - world.rotate(Vec3::UnitY())).norm(), 1e-5f);
  expectConsistent(m, world, world * rocked, 0.02f);
}

TEST(Manifold, ALongPlateIsComputedAgainBeforeItsFarEndMoved) {
  // Half a degree is nothing to a cube and 9 mm to the end of a plate of 1 m: the far points have to appear.
  const Convex floor = box(5.0f, 0.5f, 5.0f), plate = box(1.0f, 0.02f, 0.2f);
  Manifold m;
  const auto tilted = [](float angle) {  // about its left lower edge
    const Quat q = rotationAbout(Vec3::UnitZ(), angle);
    return Transform{Vec3(-1.0f, 0.5f, 0.0f) + q * Vec3(1.0f, 0.02f, 0.0f), q};
  };
  updateManifold(proxy(floor), Transform{}, 0.5f, proxy(plate), tilted(0.010f), 0.02f, 0.01f, kRecycling, m);
  ASSERT_EQ(m.count, 2);
  for (float angle = 0.010f; angle > -1e-4f; angle -= 0.0005f) {
    updateManifold(proxy(floor), Transform{}, 0.5f, proxy(plate), tilted(angle), 0.02f, 0.01f, kRecycling, m);
    float deepest = 1.0f, expected = 1.0f;
    for (int i = 0; i < m.count; ++i) deepest = std::min(deepest, m.points[i].separation);
    for (const geometry::Vertex& vertex : plate.vertices)
      expected = std::min(expected, tilted(angle).toWorld(vertex.point).y() - 0.5f);
    EXPECT_NEAR(deepest, expected, 0.1f * 0.02f);
    if (2.0f * angle < 0.008f) {
      EXPECT_EQ(m.count, 4) << angle;
    }
  }
}

TEST(Manifold, TheNormalOfARestingStackStaysTheSame) {
  Random random(41);
  const Convex cube = box(0.5f, 0.5f, 0.5f);
  Manifold m;
  for (int tick = 0; tick < 200; ++tick) {
    Transform pose = at(0.1f, 0.9995f, 0.05f);
    for (int i = 0; i < 3; ++i) pose.position[i] += random.nextFloat(-1e-5f, 1e-5f);
    Vec3 axis;
    for (int i = 0; i < 3; ++i) axis[i] = random.nextFloat(-1.0f, 1.0f);
    pose.rotation = rotationAbout(axis.normalized(), 1e-5f);
    updateManifold(proxy(cube), Transform{}, 0.5f, proxy(cube), pose, 0.5f, 0.02f, kClipped, m);
    EXPECT_EQ(m.count, 4);
    EXPECT_EQ(m.normal, Vec3(Vec3::UnitY()));  // A's face is the reference, always
  }
}

TEST(Manifold, BigFacesAreReducedToFourWideApart) {
  const Convex table = geometry::makeCylinder(1.0f, 0.1f, 200), plate = geometry::makeCylinder(0.8f, 0.1f, 96);
  const Manifold m = fresh(table, Transform{}, plate, at(0.0f, 0.199f, 0.0f), 0.02f, 0.1f);
  ASSERT_EQ(m.count, 4);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(m.points[i].separation, -0.001f, 1e-5f);
    for (int k = 0; k < i; ++k) EXPECT_GT((m.points[i].localA - m.points[k].localA).norm(), 1.0f);
  }
}

TEST(Manifold, IncrementalGathersPointsOfARockingBoxAndDropsThemWhenItLeaves) {
  const Convex floor = box(5.0f, 0.5f, 5.0f), cube = box(0.5f, 0.5f, 0.5f);
  Manifold m;
  int most = 0;
  for (int tick = 0; tick < 40; ++tick) {
    const float phase = 0.8f * static_cast<float>(tick);
    const Vec3 axis = Vec3(cosine(phase), 0.0f, sine(phase));
    const Transform pose{Vec3(0.0f, 1.0005f, 0.0f), rotationAbout(axis, 0.001f)};
    updateManifold(proxy(floor), Transform{}, 0.5f, proxy(cube), pose, 0.5f, 0.02f, kIncremental, m);
    expectConsistent(m, Transform{}, pose, 0.02f);
    most = std::max(most, m.count);
  }
  EXPECT_EQ(most, 4);
  EXPECT_EQ(m.count, 4);
  updateManifold(proxy(floor), Transform{}, 0.5f, proxy(cube), at(0.0f, 1.5f, 0.0f), 0.5f, 0.02f, kIncremental, m);
  EXPECT_EQ(m.count, 0);
}

TEST(Manifold, IncrementalTakesAllPointsOfADeepOverlapAtOnce) {
  const Convex floor = box(5.0f, 0.5f, 5.0f), plate = box(0.2f, 0.01f, 0.2f);
  const Transform pose = at(0.0f, 0.5f, 0.0f);
  Manifold m;
  updateManifold(proxy(floor), Transform{}, 0.5f, proxy(plate), pose, 0.01f, 0.01f, kIncremental, m);
  ASSERT_EQ(m.count, 4);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(m.points[i].separation, -0.01f, 1e-6f);
  expectConsistent(m, Transform{}, pose, 0.01f);
}

TEST(Manifold, IncrementalDropsWhatDriftsSideways) {
  const Convex floor = box(5.0f, 0.5f, 5.0f), cube = box(0.5f, 0.5f, 0.5f);
  Manifold m;
  for (int tick = 0; tick < 60; ++tick) {
    const Transform pose = at(0.05f * static_cast<float>(tick), 1.001f, 0.0f);
    updateManifold(proxy(floor), Transform{}, 0.5f, proxy(cube), pose, 0.5f, 0.02f, kIncremental, m);
    for (int i = 0; i < m.count; ++i) {
      const Vec3 apart = pose.toWorld(m.points[i].localB) - m.points[i].localA;
      EXPECT_LT((apart - m.points[i].separation * m.normal).norm(), 0.25f * 0.5f + 1e-4f);
    }
  }
  EXPECT_GE(m.count, 1);
}

TEST(Manifold, RandomHullsAreConsistentAndTheDeepestPointIsAmongTheirs) {
  Random random(42);
  for (int i = 0; i < 2000; ++i) {
    std::vector<Vec3> points[2];
    for (auto& cloud : points)
      for (int k = 0; k < 10; ++k) {
        Vec3 p;
        for (int c = 0; c < 3; ++c) p[c] = random.nextFloat(-0.1f, 0.1f);
        p.z() *= i % 2 == 0 ? 1.0f : 0.02f;
        cloud.push_back(p);
      }
    const auto a = geometry::makeHull(points[0]), b = geometry::makeHull(points[1]);
    ASSERT_TRUE(static_cast<bool>(a) && static_cast<bool>(b));
    Transform poseA, poseB;
    for (int c = 0; c < 3; ++c) poseB.position[c] = random.nextFloat(-0.2f, 0.2f);
    Vec3 axis;
    for (int c = 0; c < 3; ++c) axis[c] = random.nextFloat(-1.0f, 1.0f);
    poseB.rotation = rotationAbout(axis.normalized(), 2.0f);
    const float margin = i % 3 == 0 ? 1.0f : 0.01f;
    geometry::SimplexCache cache;
    const geometry::Separation s = geometry::separation(proxy(a.value()), poseA, proxy(b.value()), poseB, cache);
    Manifold m;
    updateManifold(proxy(a.value()), poseA, 0.02f, proxy(b.value()), poseB, 0.02f, margin, kClipped, m);
    expectConsistent(m, poseA, poseB, margin);
    ASSERT_EQ(m.count > 0, s.distance <= margin);
    float deepest = 1.0f;
    for (int k = 0; k < m.count; ++k) deepest = std::min(deepest, m.points[k].separation);
    // A face's normal may stand in for a direction up to 11 degrees off, which shortens a gap by 2 % and deepens an
    // overlap.
    if (m.count > 0 && s.distance > 0.0f) {
      EXPECT_NEAR(deepest, s.distance, 0.02f * s.distance + 0.02f * 0.02f + 1e-5f);
    }
    if (m.count > 0 && s.distance <= 0.0f) {
      EXPECT_LE(deepest, s.distance + 0.02f * 0.02f + 1e-5f);
    }
  }
}

}  // namespace
}  // namespace brittle::physics
