// B9: micro-shards. A pane of 1 m is carved with radii down to 1 mm by strikers down to 1 mm: every number stays
// finite, no body is lighter than the least volume allows, no shard is faster than the striker was (restitution 0). And
// 500 shards below 1 cm3 that fall on a floor cost per shard and step less than twice what 50 do. Work is counted, not
// timed: pairs tested and contact points solved, which is what a step's instructions are spent on (the same under
// `valgrind --tool=callgrind build/tools/hard_cases B9`).
//
// Not below: levels make nothing smaller than 2e-6 m3.
//
// The hole has a margin of 2 mm about the striker, so the smallest is one of about 3 mm whatever radius is asked for.
#include <gtest/gtest.h>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr float kDensity = 2500.0f;  // [kg/m3]

/// Shoots a pane of 1 m; every tick's bodies must be sound.
void shoot(float radius, float carveRadius, float speed, const Vec3& at, float minVolume) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  World world(def);
  BodyDef pane = bodyAt(Vec3::Zero(), BodyType::Static);
  pane.breakable.strength = 1e-6f;
  pane.breakable.material.carveRadius = carveRadius;
  pane.breakable.material.minVolume = minVolume;
  ShapeDef shape = shapeDef(kDensity);
  shape.anchored = true;
  addBox(world, pane, Vec3(0.5f, 0.5f, 0.002f), shape);
  const float mass = kDensity * 4.0f * radius * radius * radius;
  const BodyHandle ball = addBall(world, at + Vec3(0.0f, 0.0f, 0.05f), Vec3(0.0f, 0.0f, -speed), radius, mass);
  std::uint32_t breaks = 0;
  for (int tick = 0; tick < 8; ++tick) {
    world.step(kTick);
    breaks += world.counters().breaks;
    ASSERT_TRUE(world.events().quarantined.empty());
    world.forEachBody([&](BodyHandle handle, const Body& body) {
      ASSERT_TRUE(isFinite(body.center) && isFinite(body.velocity) && isFinite(body.angularVelocity));
      if (handle == ball || !body.isDynamic()) return;
      EXPECT_GE(body.mass, kDensity * minVolume * 0.999f);
      EXPECT_LE(body.velocity.norm(), speed * 1.0001f);
      hard::reportWorst("fastest shard, of the striker's speed,", body.velocity.norm() / speed);
    });
  }
  EXPECT_GE(breaks, 1u) << radius << " m, carve " << carveRadius << " m, " << speed << " m/s";
  hard::reportSum("shots", 1);
}

TEST(B9, SmallHolesMakeSoundShards) {
  Random random(121);
  for (const float radius : {0.001f, 0.003f, 0.01f})
    for (const float carveRadius : {0.001f, 0.003f, 0.01f})
      for (const float speed : {5.0f, 30.0f, 120.0f})
        for (int i = 0; i < hard::counted(1, 100); ++i) {
          const float x = random.nextFloat(-0.49f, 0.49f);
          const float y = random.nextFloat(-0.49f, 0.49f);
          shoot(radius, carveRadius, speed, Vec3(x, y, 0.002f), i % 2 == 0 ? 1e-9f : 1e-8f);
        }
}

/// Two tempered panes of 6 cm fall to so many dice each, and those onto a floor. Work per shard and step.
double workPerShard(float dieSize, std::size_t least, std::size_t most) {
  World world;
  addFloor(world);
  for (const float x : {-0.05f, 0.05f}) {
    BodyDef pane = bodyAt(Vec3(x, 0.05f, 0.0f));
    pane.breakable.strength = 1.0f;
    pane.breakable.material.pattern = fracture::Pattern::Tempered;
    pane.breakable.material.dieSize = dieSize;
    pane.breakable.material.minVolume = 1e-9f;
    const BodyHandle body = addBox(world, pane, Vec3(0.03f, 0.002f, 0.03f), shapeDef(kDensity));
    world.breakBody(body, Vec3(x, 0.052f, 0.0f), -Vec3::UnitY(), 10.0f, 0.005f);
  }
  std::size_t shards = 0;
  float largest = 0.0f;
  world.forEachBody([&](BodyHandle, const Body& body) {
    if (!body.isDynamic()) return;
    ++shards;
    largest = maxOf(largest, body.mass / kDensity);
  });
  EXPECT_GE(shards, least);
  EXPECT_LE(shards, most);
  EXPECT_LT(largest, 1e-6f) << "1 cm3";
  double work = 0.0;
  for (int tick = 0; tick < 60; ++tick) {
    world.step(kTick);
    work += world.counters().pairsTested + world.counters().points;
  }
  return work / (60.0 * static_cast<double>(shards));
}

TEST(B9, FiveHundredCostPerShardWhatFiftyDo) {
  const double few = workPerShard(0.0115f, 45, 60), many = workPerShard(0.0038f, 450, 560);
  EXPECT_LT(many, 2.0 * few);
  hard::reportWorst("work per shard, 500 to 50,", many / few);
}

}  // namespace
}  // namespace brittle::physics
