// B34: bodies at rest are put to sleep; whatever ends their rest wakes them. A sleeping cluster of shards that is hit,
// one whose supporting shard is destroyed, and an island left without support: all that is touched wakes within 1 step,
// and nothing floats: half a second later no sleeping body is without support.
#include <gtest/gtest.h>

#include <string>

#include "engine/physics/contact_graph.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"
#include "tests/hard_cases/support.h"

namespace brittle::physics {
namespace {

constexpr float kTouches = 5e-5f;  // closer than this is touch [m]: less than the slop of the smallest shard

void run(World& world, int ticks) {
  for (int i = 0; i < ticks; ++i) world.step(kTick);
}

void expectNoneFloats(const World& world, const std::string& when) {
  const int floating = floatingSleepers(world);
  EXPECT_EQ(floating, 0) << when;
  hard::reportSum("looks", 1);
  hard::reportSum("floating", floating);
}

int sleepers(const World& world) {
  int count = 0;
  world.forEachBody([&](BodyHandle, const Body& body) { count += body.isDynamic() && !body.awake ? 1 : 0; });
  return count;
}

/// Dynamic bodies touching `body`.
std::vector<BodyHandle> touching(const World& world, BodyHandle body) {
  const State& state = world.state();
  std::vector<BodyHandle> found;
  world.forEachBody([&](BodyHandle handle, const Body& other) {
    if (handle == body || !other.isDynamic()) return;
    bool near = false;
    forEachShape(state, state.bodies[body], [&](ShapeHandle, const Shape& a) {
      forEachShape(state, other, [&](ShapeHandle, const Shape& b) { near = near || areNear(world, a, b, kTouches); });
    });
    if (near) found.push_back(handle);
  });
  return found;
}

/// A block of glass broken where it stood, asleep.
struct Cluster {
  World world;
  BodyHandle floor;
  Cluster() {
    floor = addFloor(world);
    BodyDef def = bodyAt(Vec3(0.0f, 0.3f, 0.0f));
    def.breakable.strength = 1e4f;
    def.breakable.material.pattern = fracture::Pattern::Block;
    const BodyHandle block = addBox(world, def, Vec3(0.3f, 0.3f, 0.3f), shapeDef(2500.0f));
    world.breakBody(block, Vec3(0.0f, 0.6f, 0.0f), -Vec3::UnitY(), 20.0f, 0.3f);
    for (int tick = 0; tick < 900 && (tick < 60 || world.counters().awakeBodies > 0); ++tick) world.step(kTick);
  }
};

TEST(B34, AHitClusterWakesWhereItIsTouched) {
  Cluster cluster;
  World& world = cluster.world;
  const int asleep = sleepers(world);
  ASSERT_GE(asleep, 20);
  ASSERT_EQ(floatingSleepers(world), 0);
  const BodyHandle ball = addBall(world, Vec3(0.0f, 0.25f, 3.0f), Vec3(0.0f, 0.0f, -15.0f), 0.1f, 5.0f);
  bool hit = false;
  for (int tick = 0; tick < 60; ++tick) {
    std::vector<BodyHandle> touched = touching(world, ball);
    world.step(kTick);
    for (const BodyHandle handle : touching(world, ball)) touched.push_back(handle);
    for (const BodyHandle handle : touched) {
      hit = true;
      EXPECT_TRUE(world.body(handle).awake) << "tick " << tick;
    }
    if (hit) break;
  }
  ASSERT_TRUE(hit);
  for (int tick = 0; tick < 300; ++tick) {
    world.step(kTick);
    if (tick % 30 != 29) continue;
    expectNoneFloats(world, "tick " + std::to_string(tick));
  }
}

TEST(B34, WhatADestroyedShardBoreWakesAndFalls) {
  Cluster cluster;
  World& world = cluster.world;
  for (int round = 0; round < 8; ++round) {
    BodyHandle lowest;
    std::vector<BodyHandle> borne;
    world.forEachBody([&](BodyHandle handle, const Body& body) {
      if (!body.isDynamic() || body.awake) return;
      const std::vector<BodyHandle> near = touching(world, handle);
      if (near.size() > borne.size()) {
        lowest = handle;
        borne = near;
      }
    });
    if (borne.empty()) break;
    world.destroyBody(lowest);
    world.step(kTick);
    for (const BodyHandle handle : borne) EXPECT_TRUE(world.body(handle).awake) << "round " << round;
    run(world, 29);
    expectNoneFloats(world, "half a second on, round " + std::to_string(round));
    for (int tick = 0; tick < 900 && world.counters().awakeBodies > 0; ++tick) world.step(kTick);
    expectNoneFloats(world, "at rest, round " + std::to_string(round));
  }
}

TEST(B34, AnIslandWithoutSupportFalls) {
  Cluster cluster;
  World& world = cluster.world;
  ASSERT_GE(sleepers(world), 20);
  world.destroyBody(cluster.floor);
  world.step(kTick);
  EXPECT_EQ(sleepers(world), 0);
  run(world, 29);
  EXPECT_EQ(sleepers(world), 0);
  world.forEachBody([&](BodyHandle, const Body& body) { EXPECT_LT(body.velocity.y(), -4.0f); });
}

/// A tower of boxes, its foot taken away in every way there is.
struct Tower {
  World world;
  BodyHandle support;
  std::vector<BodyHandle> boxes;
  explicit Tower(BodyType type, float strength = 0.0f) {
    BodyDef def = bodyAt(Vec3(0.0f, -0.05f, 0.0f), type);
    def.breakable.strength = strength;
    ShapeDef shape = shapeDef(2500.0f);
    shape.anchored = type == BodyType::Static;
    support = addBox(world, def, Vec3(0.5f, 0.05f, 0.5f), shape);
    for (int i = 0; i < 4; ++i)
      boxes.push_back(
          addBox(world, bodyAt(Vec3(0.0f, 0.1f + 0.2f * static_cast<float>(i), 0.0f)), Vec3(0.1f, 0.1f, 0.1f)));
    run(world, 120);
    for (const BodyHandle box : boxes) EXPECT_FALSE(world.body(box).awake);
  }
  void expectAllAwake() const {
    for (const BodyHandle box : boxes) EXPECT_TRUE(world.body(box).awake);
  }
};

TEST(B34, ATowerWakesWhenItsFloorBreaks) {
  Tower tower(BodyType::Static, 500.0f);
  tower.world.breakBody(tower.support, Vec3(0.0f, -0.1f, 0.0f), Vec3::UnitY(), 30.0f, 0.5f);
  tower.world.step(kTick);
  tower.expectAllAwake();
  run(tower.world, 29);
  expectNoneFloats(tower.world, "half a second on");
}

TEST(B34, ATowerWakesWhenItsFloorIsMovedAway) {
  Tower tower(BodyType::Static);
  Transform away;
  away.position = Vec3(5.0f, 0.0f, 0.0f);
  tower.world.setPose(tower.support, away);
  tower.world.step(kTick);
  tower.expectAllAwake();
  run(tower.world, 29);
  expectNoneFloats(tower.world, "half a second on");
}

TEST(B34, ATowerFollowsALiftThatSinksSlowerThanRest) {
  for (const float speed : {0.01f, 0.03f, 0.2f, 4.0f}) {
    Tower tower(BodyType::Animated);
    const std::uint32_t assembly = tower.world.body(tower.support).assembly;
    Transform at = tower.world.body(tower.support).pose;
    for (int tick = 0; tick < 240; ++tick) {
      at.position.y() -= speed * kTick;
      tower.world.animate(assembly, at);
      tower.world.step(kTick);
      if (tick % 30 != 29) continue;
      expectNoneFloats(tower.world, std::to_string(speed) + " m/s, tick " + std::to_string(tick));
    }
  }
}

}  // namespace
}  // namespace brittle::physics
