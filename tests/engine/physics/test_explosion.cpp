#include "engine/physics/explosion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

WorldDef weightless() {
  WorldDef def;
  def.gravity = Vec3::Zero();
  return def;
}

ExplosionDef blastAt(const Vec3& center) {
  ExplosionDef def;
  def.center = center;
  def.breakReach = 1.5f;
  def.pushReach = 4.0f;
  def.pressure = 60.0f;
  def.mostSpeed = 1000.0f;
  return def;
}

TEST(Explosion, ACubesOutlineIsItsFaceOrASixthCornerMore) {
  const geometry::Convex cube = geometry::makeBox<float>(Vec3::Constant(0.5f));
  EXPECT_NEAR(outlineArea(cube.view(), Vec3::UnitX()), 1.0f, 1e-6f);
  EXPECT_NEAR(outlineArea(cube.view(), Vec3::Ones().normalized()), std::sqrt(3.0f), 1e-5f);
}

// The closed form: pressure times the area that faces the centre times (1 - d / reach)^2, over the mass.
TEST(Explosion, WhatIsLooseGainsWhatItsOutlineCatches) {
  for (const float distance : {0.5f, 1.0f, 2.0f, 3.0f, 3.9f}) {
    World world(weightless());
    const BodyHandle ball = addBall(world, Vec3(distance, 0.0f, 0.0f), Vec3::Zero(), 0.2f, 8.0f);
    const BodyHandle box = addBox(world, bodyAt(Vec3(0.0f, 0.0f, -distance)), Vec3(0.3f, 0.2f, 0.1f));
    const Explosion done = explode(world, blastAt(Vec3::Zero()));
    const float share = (1.0f - distance / 4.0f) * (1.0f - distance / 4.0f);
    const float onBall = 60.0f * share * kPi * 0.04f, onBox = 60.0f * share * 0.6f * 0.4f;
    EXPECT_NEAR(world.body(ball).velocity.x(), onBall / 8.0f, 1e-5f) << distance;
    EXPECT_NEAR(world.body(box).velocity.z(), -onBox / world.body(box).mass, 1e-5f) << distance;
    EXPECT_LT(world.body(box).angularVelocity.norm(), 1e-4f) << "its middle is pushed straight away";
    EXPECT_NEAR(done.impulse, onBall + onBox, 1e-4f);
    EXPECT_EQ(done.pushed, 2u);
  }
}

TEST(Explosion, BeyondItsReachIsNothing) {
  World world(weightless());
  const BodyHandle ball = addBall(world, Vec3(4.1f, 0.0f, 0.0f), Vec3::Zero(), 0.2f, 8.0f);
  EXPECT_EQ(explode(world, blastAt(Vec3::Zero())).pushed, 0u);
  EXPECT_EQ(world.body(ball).velocity, Vec3(Vec3::Zero()));
}

TEST(Explosion, LightThingsGainNoMoreThanTheBlastsOwnSpeed) {
  World world(weightless());
  ExplosionDef def = blastAt(Vec3::Zero());
  def.mostSpeed = 5.0f;
  const BodyHandle ball = addBall(world, Vec3(1.0f, 0.0f, 0.0f), Vec3::Zero(), 0.2f, 0.01f);
  explode(world, def);
  EXPECT_NEAR(world.body(ball).velocity.x(), 5.0f * shareAt(1.0f, 4.0f), 1e-4f);
}

TEST(Explosion, WhatStandsBetweenShields) {
  for (const bool isShielded : {false, true}) {
    World world(weightless());
    const BodyHandle ball = addBall(world, Vec3(2.0f, 0.0f, 0.0f), Vec3::Zero(), 0.2f, 8.0f);
    const BodyHandle pane = addPane(world, Vec3(0.0f, 0.0f, -1.2f), Vec3(0.8f, 0.8f, 0.02f), 100.0f);
    if (isShielded) addBox(world, bodyAt(Vec3(1.0f, 0.0f, 0.0f), BodyType::Static), Vec3(0.1f, 1.0f, 1.0f));
    if (isShielded) addBox(world, bodyAt(Vec3(0.0f, 0.0f, -0.6f), BodyType::Static), Vec3(1.5f, 1.5f, 0.1f));
    const Explosion done = explode(world, blastAt(Vec3::Zero()));
    EXPECT_EQ(done.breaks.empty(), isShielded);
    EXPECT_EQ(world.isAlive(pane) && world.body(pane).mass > 30.0f, isShielded);
    EXPECT_EQ(world.body(ball).velocity.x() > 0.0f, !isShielded);
  }
}

TEST(Explosion, GlassThatBurstsDoesNotShieldWhatIsBehindIt) {
  World world(weightless());
  for (const float z : {-0.6f, -1.0f, -1.4f, -1.8f})
    addPane(world, Vec3(0.0f, 0.0f, z), Vec3(0.6f, 0.6f, 0.02f), 100.0f);
  const Explosion done = explode(world, blastAt(Vec3::Zero()));
  ASSERT_EQ(done.breaks.size(), 3u) << "the fourth is out of reach";
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(done.breaks[i].point.z(), -0.58f - 0.4f * static_cast<float>(i), 1e-3f) << "nearest first";
    EXPECT_EQ(done.breaks[i].impulse, 100.0f);
    EXPECT_GT(done.breaks[i].pieces, 3u);
  }
}

TEST(Explosion, TheMomentumItReportsIsTheWorlds) {
  World world(weightless());
  addPane(world, Vec3(0.0f, 0.0f, -0.8f), Vec3(1.0f, 1.0f, 0.02f), 100.0f);
  addBall(world, Vec3(1.0f, 1.5f, 0.3f), Vec3(0.0f, 1.0f, 0.0f), 0.2f, 8.0f);
  addBox(world, bodyAt(Vec3(-1.5f, 0.4f, 0.8f)), Vec3(0.4f, 0.2f, 0.3f));
  const auto momentum = [&world] {
    Vec3 sum = Vec3::Zero();
    world.forEachBody([&sum](BodyHandle, const Body& body) {
      if (body.isDynamic()) sum += body.mass * body.velocity;
    });
    return sum;
  };
  const Vec3 before = momentum();
  const Explosion done = explode(world, blastAt(Vec3(0.1f, 0.2f, 0.0f)));
  EXPECT_GT(done.pushed, 5u);
  EXPECT_LT((momentum() - before - done.momentum).norm(), 1e-4f * done.impulse);
}

TEST(Explosion, TheSameBlastGivesTheSameBits) {
  std::uint64_t hashes[2];
  for (std::uint64_t& hash : hashes) {
    World world;
    addFloor(world);
    addPane(world, Vec3(0.0f, 1.0f, -0.8f), Vec3(1.0f, 1.0f, 0.02f), 100.0f);
    addBox(world, bodyAt(Vec3(-1.0f, 0.2f, 0.5f)), Vec3(0.4f, 0.2f, 0.3f));
    world.step(kTick);
    explode(world, blastAt(Vec3(0.0f, 1.0f, 0.0f)));
    for (int i = 0; i < 60; ++i) world.step(kTick);
    hash = world.stateHash();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace brittle::physics
