#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "engine/core/random.h"
#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

constexpr std::uint32_t kAll = ~0u;

/// A floor, and boxes and balls strewn above it.
struct Strewn {
  World world;
  std::vector<BodyHandle> bodies;
  explicit Strewn(std::uint64_t seed) {
    Random random(seed);
    bodies.push_back(addFloor(world));
    for (int i = 0; i < 60; ++i) {
      Vec3 place;
      for (int k = 0; k < 3; ++k) place[k] = random.nextFloat(-8.0f, 8.0f);
      place.y() += 9.0f;
      BodyDef def = bodyAt(place);
      Vec3 axis;
      for (int k = 0; k < 3; ++k) axis[k] = random.nextFloat(-1.0f, 1.0f);
      def.pose.rotation = rotationAbout(axis.normalized(), 1.0f);
      const Vec3 velocity(random.nextFloat(-20.0f, 20.0f), 0.0f, 0.0f);
      if (i % 2 == 0) {
        def.velocity = velocity;
        bodies.push_back(addBox(world, def, Vec3(0.5f, 0.2f, 0.3f)));
      } else {
        bodies.push_back(addBall(world, place, velocity, 0.4f, 1.0f));
      }
    }
  }
  geometry::Proxy proxy(BodyHandle body) const {
    return proxyOf(world.shape(world.body(body).firstShape), world.meshes());
  }
};

Vec3 randomPlace(Random& random) {
  Vec3 place;
  for (int k = 0; k < 3; ++k) place[k] = random.nextFloat(-9.0f, 9.0f);
  return place + Vec3(0.0f, 9.0f, 0.0f);
}

TEST(Query, RaysFindTheNearestShapeThatBruteForceFinds) {
  Strewn scene(1);
  Random random(51);
  for (int tick = 0; tick < 5; ++tick, scene.world.step(kTick)) {
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
      const Vec3 from = randomPlace(random), to = randomPlace(random);
      const RayResult found = scene.world.castRay(from, to);
      geometry::RayHit best;
      for (const BodyHandle body : scene.bodies) {
        const geometry::RayHit hit = geometry::castRay(scene.proxy(body), scene.world.body(body).pose, from, to);
        if (hit.hit && hit.fraction < best.fraction) best = hit;
      }
      ASSERT_EQ(found.hit, best.hit) << "tick " << tick;
      EXPECT_EQ(found.fraction, best.fraction);
      hits += found.hit ? 1 : 0;
    }
    EXPECT_GT(hits, 5);
  }
}

TEST(Query, SpheresStopWhereTheyTouch) {
  Strewn scene(2);
  Random random(52);
  for (int tick = 0; tick < 3; ++tick, scene.world.step(kTick)) {
    int hits = 0;
    for (int i = 0; i < 200; ++i) {
      const Vec3 from = randomPlace(random), to = randomPlace(random);
      const geometry::Proxy ball{{}, Vec3::Zero(), 0.3f};
      const auto gapAt = [&](float fraction) {
        float gap = 100.0f;
        for (const BodyHandle body : scene.bodies) {
          geometry::SimplexCache cache;
          const Transform pose{from + (to - from) * fraction, Quat::Identity()};
          gap = std::min(
              gap, geometry::separation(ball, pose, scene.proxy(body), scene.world.body(body).pose, cache).distance);
        }
        return gap;
      };
      if (gapAt(0.0f) < 0.01f) continue;  // starts in something
      const RayResult found = scene.world.castSphere(from, to, 0.3f);
      if (found.hit) {
        ++hits;
        EXPECT_NEAR(gapAt(found.fraction), 0.0f, 0.001f);
        EXPECT_LT(found.normal.dot(to - from), 0.0f);
      }
      const float until = found.hit ? found.fraction : 1.0f;
      for (int k = 0; k < 20; ++k) ASSERT_GT(gapAt(until * static_cast<float>(k) / 20.0f), 0.0f);
    }
    EXPECT_GT(hits, 20);
  }
}

TEST(Query, OverlapsAreThoseOfBruteForceInSlotOrder) {
  Strewn scene(3);
  Random random(53);
  for (int tick = 0; tick < 5; ++tick, scene.world.step(kTick)) {
    for (int i = 0; i < 100; ++i) {
      const Vec3 center = randomPlace(random);
      const float radius = random.nextFloat(0.1f, 3.0f);
      const geometry::Proxy ball{{}, Vec3::Zero(), radius};
      std::set<std::uint32_t> expected;
      for (const BodyHandle body : scene.bodies)
        if (geometry::overlaps(ball, {center, Quat::Identity()}, scene.proxy(body), scene.world.body(body).pose, 0.0f))
          expected.insert(scene.world.body(body).firstShape.index);
      std::vector<std::uint32_t> found;
      scene.world.overlapSphere(center, radius, kAll, [&](ShapeHandle shape) {
        found.push_back(shape.index);
        return true;
      });
      ASSERT_EQ(found, std::vector<std::uint32_t>(expected.begin(), expected.end()));
    }
  }
}

TEST(Query, BoxesOverlapWhatTheyTouch) {
  World world;
  const BodyHandle floor = addFloor(world);
  const BodyHandle cube = addBox(world, bodyAt(Vec3(0.0f, 2.0f, 0.0f)), Vec3::Constant(0.5f));
  std::vector<BodyHandle> found;
  const auto collect = [&](ShapeHandle shape) {
    found.push_back(world.bodyOf(shape));
    return true;
  };
  world.overlapBox({Vec3(-0.1f, 1.0f, -0.1f), Vec3(0.1f, 1.6f, 0.1f)}, kAll, collect);
  EXPECT_EQ(found, std::vector<BodyHandle>{cube});
  found.clear();
  world.overlapBox({Vec3(-0.1f, -0.1f, -0.1f), Vec3(0.1f, 1.6f, 0.1f)}, kAll, collect);
  EXPECT_EQ(found, (std::vector<BodyHandle>{floor, cube}));
  int visits = 0;
  world.overlapBox({Vec3::Constant(-3.0f), Vec3::Constant(3.0f)}, kAll, [&](ShapeHandle) { return ++visits < 1; });
  EXPECT_EQ(visits, 1);
}

TEST(Query, MasksSelectByCategory) {
  World world;
  ShapeDef def = shapeDef();
  def.surface.category = 4;
  const BodyHandle cube = addBox(world, bodyAt(Vec3(0.0f, 2.0f, 0.0f)), Vec3::Constant(0.5f), def);
  const Vec3 from(0.0f, 5.0f, 0.0f), to(0.0f, 0.0f, 0.0f);
  EXPECT_EQ(world.bodyOf(world.castRay(from, to, 4).shape), cube);
  EXPECT_FALSE(world.castRay(from, to, ~4u).hit);
  EXPECT_TRUE(world.castSphere(from, to, 0.1f, 4).hit);
  EXPECT_FALSE(world.castSphere(from, to, 0.1f, ~4u).hit);
  EXPECT_NEAR(world.castSphere(from, to, 0.1f, 4).fraction, 0.48f, 1e-3f);
}

}  // namespace
}  // namespace brittle::physics
