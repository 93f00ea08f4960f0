// What a body or a contact does not need costs it nothing: limits, sweeps, lists of joints.
#include <gtest/gtest.h>

#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

/// A box that slides over a floor into another one; `strength` [N s] of that one.
World& slideInto(World& world, float strength) {
  addFloor(world);
  BodyDef still = bodyAt(Vec3(0.0f, 0.1f, 0.0f));
  still.breakable.strength = strength;
  addBox(world, still, Vec3::Constant(0.1f));
  BodyDef moving = bodyAt(Vec3(-0.3f, 0.1f, 0.0f));
  moving.velocity = Vec3(3.0f, 0.0f, 0.0f);
  addBox(world, moving, Vec3::Constant(0.1f));
  for (int i = 0; i < 4; ++i) world.step(kTick);
  return world;
}

std::size_t contactsWithStrike(const World& world) {
  std::size_t count = 0;
  world.state().contacts.forEach(
      [&](ContactHandle, const Contact& contact) { count += contact.strike != kNoStrike ? 1 : 0; });
  return count;
}

TEST(Need, APairThatDoesNotBreakHasNoLimit) {
  World rigid, brittle;
  slideInto(rigid, 0.0f);
  ASSERT_GT(rigid.counters().points, 0u);
  EXPECT_TRUE(rigid.state().strikes.list.empty());
  EXPECT_TRUE(rigid.state().budgets.empty());
  EXPECT_EQ(contactsWithStrike(rigid), 0u);
  slideInto(brittle, 1e6f);
  EXPECT_FALSE(brittle.state().strikes.list.empty());
  EXPECT_GT(contactsWithStrike(brittle), 0u);
}

TEST(Need, WhatIsSlowIsNotSwept) {
  for (const float speed : {0.5f, 60.0f}) {
    World world;
    addBox(world, bodyAt(Vec3::Zero(), BodyType::Static), Vec3(1.0f, 1.0f, 0.01f));
    addBall(world, Vec3(0.0f, 0.0f, 0.5f), Vec3(0.0f, 0.0f, -speed), 0.1f, 1.0f);
    std::uint32_t swept = 0, sweeps = 0;
    for (int i = 0; i < 3; ++i) {
      world.step(kTick);
      swept += world.counters().swept;
      sweeps += world.counters().sweeps;
    }
    EXPECT_EQ(swept > 0, speed > 1.0f) << speed;
    if (speed < 1.0f) {
      EXPECT_EQ(sweeps, 0u);
    }
  }
}

TEST(Need, WithoutJointsNobodyListsThem) {
  World world;
  slideInto(world, 0.0f);
  EXPECT_TRUE(world.state().jointedBodies.empty());
  const BodyHandle hung = addBox(world, bodyAt(Vec3(0.0f, 3.0f, 0.0f)), Vec3::Constant(0.1f));
  JointDef joint;
  joint.a = world.body(hung).firstShape;
  joint.anchorA = Vec3(0.0f, 3.1f, 0.0f);
  world.createJoint(joint);
  for (int i = 0; i < 30; ++i) world.step(kTick);
  EXPECT_FALSE(world.state().jointedBodies.empty());
}

}  // namespace
}  // namespace brittle::physics
