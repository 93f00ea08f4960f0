// Stacks: they stand when they must, fall when they must, and low ones take no more rounds.
#include "engine/physics/stack.h"

#include <gtest/gtest.h>

#include "engine/physics/contact_rows.h"
#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

const Vec3 kBox(0.2f, 0.1f, 0.2f);  // half extents [m]

/// Boxes on a floor, each further to the side than the one below. [m]
struct Stack {
  World world;
  BodyHandle floor;
  std::vector<BodyHandle> boxes;

  explicit Stack(int count, float aside = 0.0f, float friction = 0.5f) : world(alwaysAwake()) {
    floor = addFloor(world);
    for (int i = 0; i < count; ++i)
      boxes.push_back(addBox(world, bodyAt(placeOf(i, aside)), kBox, shapeDef(2000.0f, friction)));
  }
  static Vec3 placeOf(int i, float aside = 0.0f) {
    return Vec3(aside * static_cast<float>(i), kBox.y() * static_cast<float>(1 + 2 * i), 0.0f);
  }
  const Body& top() const { return world.body(boxes.back()); }
  void step(int ticks) {
    for (int i = 0; i < ticks; ++i) world.step(kTick);
  }
  /// What the floor carried in the last tick. [N s]
  float onTheFloor() const {
    float sum = 0.0f;
    world.state().contacts.forEach([&](ContactHandle, const Contact& contact) {
      if (world.bodyOf(contact.a) != floor && world.bodyOf(contact.b) != floor) return;
      for (int i = 0; i < contact.manifold.count; ++i) sum += contact.manifold.points[i].normalImpulse;
    });
    return sum;
  }
};

TEST(Stack, StandsFromTheFirstTickOn) {
  Stack stack(25);
  for (int tick = 0; tick < 600; ++tick) {
    stack.world.step(kTick);
    ASSERT_LT((stack.top().center - Stack::placeOf(24)).norm(), 1e-3f) << "tick " << tick;
  }
}

// Then the usual sweeps have it alone: too few for 25, so it gives way as it would in a build without the module.
TEST(Stack, SwitchedOffIsNotTreatedAndMayBeSwitchedOffLater) {
  Stack on(25), off(25);
  Accuracy accuracy = off.world.accuracy();
  accuracy.stacks = false;
  off.world.setAccuracy(accuracy);
  on.step(60);
  off.step(60);
  EXPECT_EQ(on.world.counters().tallest, 25u);
  EXPECT_EQ(off.world.counters().tallest, 0u);
  EXPECT_GT((off.top().center - Stack::placeOf(24)).norm(), 10.0f * (on.top().center - Stack::placeOf(24)).norm());
  on.world.setAccuracy(accuracy);
  on.step(1);
  EXPECT_EQ(on.world.counters().tallest, 0u);
}

TEST(Stack, TheFloorCarriesItsWholeWeight) {
  Stack stack(25);
  stack.step(60);
  const auto weight = static_cast<float>(totalsOf(stack.world).mass * 9.81);
  EXPECT_NEAR(stack.onTheFloor() / (weight * kTick), 1.0f, 0.01f);
}

constexpr int kHeights[] = {3, 4, 6, 12};

/// Puts the centre of what stands on the lowest box so far from its middle, whose edge is at 20 cm. [m]
float asideFor(int count, float lean) {
  return 2.0f * lean / static_cast<float>(count);
}

TEST(Stack, LeansAsFarAsItsLoadAllows) {
  for (const int count : kHeights) {
    const float aside = asideFor(count, 0.18f);
    Stack stack(count, aside);
    stack.step(600);
    EXPECT_LT((stack.top().center - Stack::placeOf(count - 1, aside)).norm(), 0.005f) << count;
  }
}

TEST(Stack, FallsIfItLeansTooFar) {
  for (const int count : kHeights) {
    Stack stack(count, asideFor(count, 0.28f));
    stack.step(120);
    EXPECT_LT(stack.top().center.y(), Stack::placeOf(count - 1).y() - kBox.y()) << count;
  }
}

// Two boxes are the least that is held.
TEST(Stack, ABoxFallsOffAnotherItLeansTooFarOver) {
  Stack stack(2, 0.25f);
  stack.step(120);
  EXPECT_LT(stack.top().center.y(), Stack::placeOf(1).y() - kBox.y());
}

TEST(Stack, FallsFreelyOnceTheFloorIsGone) {
  Stack stack(12);
  stack.step(30);
  stack.world.destroyBody(stack.floor);
  stack.step(12);
  const Totals totals = totalsOf(stack.world);
  EXPECT_NEAR(totals.momentum.y() / totals.mass, -9.81 * 0.2, 1e-3);
}

TEST(Stack, WhatIsHitKeepsTheMomentumOfTheHit) {
  Stack stack(12, 0.0f, 0.0f);
  addBall(stack.world, Stack::placeOf(11) - Vec3(0.4f, 0.0f, 0.0f), Vec3(5.0f, 0.0f, 0.0f), 0.08f, 8.0f);
  const double before = totalsOf(stack.world).momentum.x();
  stack.step(5);
  EXPECT_GT(stack.top().velocity.x(), 0.5f);
  EXPECT_NEAR(totalsOf(stack.world).momentum.x() / before, 1.0, 1e-3);
}

TEST(Stack, OnlyTallOnesTakeMoreRounds) {
  for (const int count : {3, 4}) {
    Stack stack(count);
    stack.step(2);
    EXPECT_EQ(stack.world.state().stacks.rounds() > 0, count == 4) << count;
  }
  Stack falling(12);
  falling.world.destroyBody(falling.floor);
  falling.step(2);
  EXPECT_EQ(falling.world.state().stacks.rounds(), 0);
}

/// Square plates laid on a floor with gaps of a hundredth of their thickness, each further to the side than the one
/// below. [m]
std::vector<BodyHandle> layPlates(World& world, int count, float thickness, float width, float aside = 0.0f) {
  addFloor(world);
  std::vector<BodyHandle> plates;
  for (int i = 0; i < count; ++i) {
    const auto level = static_cast<float>(i);
    plates.push_back(addBox(world, bodyAt(Vec3(aside * level, thickness * (0.5f + 1.01f * level), 0.0f)),
                            Vec3(0.5f * width, 0.5f * thickness, 0.5f * width), shapeDef(2500.0f)));
  }
  return plates;
}

// What the sweeps leave to a plate is a part of the 2.7 mm that gravity moves it in a tick: more than it is thick.
TEST(Stack, ThinPlatesDoNotSinkIntoEachOtherAtAnyHeight) {
  for (const float thickness : {1e-4f, 1e-3f, 1e-2f, 3e-2f})
    for (const int count : {2, 5, 12}) {
      World world(alwaysAwake());
      const std::vector<BodyHandle> plates = layPlates(world, count, thickness, 10.0f * thickness);
      for (int tick = 0; tick < 120; ++tick) {
        world.step(kTick);
        for (int i = 0; i < count; ++i) {
          const float level = world.body(plates[i]).center.y() / thickness;
          ASSERT_GT(level, 0.495f + static_cast<float>(i)) << thickness << " m, plate " << i << ", tick " << tick;
        }
      }
    }
}

// Five plates of 20 cm, each 6 cm further: the centre of those above the lowest is 15 cm from its middle.
TEST(Stack, ThinPlatesFallIfTheyLeanTooFar) {
  World world(alwaysAwake());
  const std::vector<BodyHandle> plates = layPlates(world, 5, 0.01f, 0.2f, 0.06f);
  for (int tick = 0; tick < 60; ++tick) world.step(kTick);
  EXPECT_LT(world.body(plates.back()).center.y(), 0.035f);
}

// Between the rounds for tall stacks impulses go on along their way, below zero too: what slides by nothing then has no
// friction, and stays a number.
TEST(Stack, ImpulsesBelowZeroHaveNoFriction) {
  ContactRows<float> rows;
  rows.friction = 0.5f;
  rows.point[0].impulse = -1.0f;
  PairVelocity<float> v{};
  rows.solveFriction(v);
  EXPECT_EQ(rows.slide[0].impulse, 0.0f);
  EXPECT_EQ(rows.slide[1].impulse, 0.0f);
  EXPECT_EQ(rows.twistImpulse, 0.0f);
}

}  // namespace
}  // namespace brittle::physics
