// B27: a cascade. Of two kinds: one striker that breaks its way through, and pieces that push on. First the striker:
// breaking A lets the striker reach B in round 2, C in round 3 and D in round 4 of the same tick. With 3 rounds D is
// put off, reported as held, and breaks first thing in the next tick; with unbounded rounds all break at once. Either
// way the final momentum of the striker is the same to 1e-3 of what it had, and exact to 2 %.
#include <gtest/gtest.h>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr float kStrength = 1.9f;  // [N s]
constexpr float kSpeed = 50.0f;    // [m/s]: 0.83 m per tick

struct Cascade {
  std::vector<std::uint32_t> breaks, held, rounds;  // by tick, from the first break on
  float exitSpeed = 0.0f;
};

Cascade run(int rounds, int phase) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.fractureRounds = rounds;
  def.accuracy.fastRounds = 0;  // what is put off is the case
  def.accuracy.patternDensity = 0.5f;
  World world(def);
  for (int i = 0; i < 4; ++i)
    addPane(world, Vec3(0.0f, 0.0f, -0.05f * static_cast<float>(i)), Vec3(0.3f, 0.3f, 0.002f), kStrength, 2.0f);
  // Phases in which all four panes are within the way of the tick of the first break.
  const float gap = 0.3f + 0.25f * static_cast<float>(phase) / 64.0f;
  const BodyHandle ball = addBall(world, Vec3(0.003f, 0.002f, 0.052f + gap), Vec3(0.0f, 0.0f, -kSpeed), 0.05f, 1.0f);
  Cascade cascade;
  for (int tick = 0; tick < 8; ++tick) {
    world.step(kTick);
    const Counters& counters = world.counters();
    if (cascade.breaks.empty() && counters.breaks == 0) continue;
    cascade.breaks.push_back(counters.breaks);
    cascade.held.push_back(counters.held);
    cascade.rounds.push_back(counters.rounds);
  }
  cascade.exitSpeed = -world.body(ball).velocity.z();
  return cascade;
}

TEST(B27, WhatThreeRoundsPutOffBreaksInTheNextTick) {
  const float exact = kSpeed - 4.0f * kStrength;
  for (int phase = 0; phase < 64; ++phase) {
    const Cascade three = run(3, phase);
    ASSERT_GE(three.breaks.size(), 2u) << "phase " << phase;
    EXPECT_EQ(three.breaks[0], 3u) << "phase " << phase;
    EXPECT_EQ(three.rounds[0], 3u) << "phase " << phase;
    EXPECT_EQ(three.held[0], 1u) << "phase " << phase;
    EXPECT_EQ(three.breaks[1], 1u) << "phase " << phase;
    EXPECT_EQ(three.held[1], 0u) << "phase " << phase;
    const Cascade all = run(0, phase);
    ASSERT_GE(all.breaks.size(), 1u) << "phase " << phase;
    EXPECT_EQ(all.breaks[0], 4u) << "phase " << phase;
    EXPECT_EQ(all.held[0], 0u) << "phase " << phase;
    EXPECT_NEAR(three.exitSpeed, all.exitSpeed, 1e-3f * kSpeed) << "phase " << phase;
    hard::reportWorst("3 rounds and all differ by", double(std::abs(three.exitSpeed - all.exitSpeed) / kSpeed));
    EXPECT_NEAR(all.exitSpeed, exact, 0.02f * exact) << "phase " << phase;
  }
}

// Pieces that push on: the ball can touch nothing but A and what becomes of it, A only B, and so on. So nothing reaches
// B before A is broken, nor C before B is. Each slab costs the whole its strength, whoever pays it: what moves has M v
// - 4 J in the end, to 1e-4.
struct Dominoes {
  std::vector<std::uint32_t> breaks, held;  // by tick, from the first break on
  double before = 0.0;                      // momentum of all that moves, along the way [N s]
  double after = 0.0;
};

void addDomino(World& world, int i, float gap) {
  constexpr float kHalf = 0.02f;  // [m]
  BodyDef def = bodyAt(Vec3(0.0f, 0.0f, -(2.0f * kHalf + gap) * static_cast<float>(i)), BodyType::Static);
  def.breakable.strength = kStrength;
  ShapeDef shape = shapeDef(2500.0f);
  shape.anchored = true;
  shape.surface.category = 2u << i;
  shape.surface.mask = (1u << i) | (2u << i) | (4u << i);
  addBox(world, def, Vec3(0.2f, 0.2f, kHalf), shape);
}

Dominoes push(int rounds, float gap, int phase) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.fractureRounds = rounds;
  def.accuracy.fastRounds = 0;  // what is put off is the case
  World world(def);
  for (int i = 0; i < 4; ++i) addDomino(world, i, gap);
  BodyDef striker = bodyAt(Vec3(0.003f, 0.002f, 0.125f + 0.3f * static_cast<float>(phase) / 64.0f));
  striker.velocity = Vec3(0.0f, 0.0f, -kSpeed);
  ShapeDef steel = shapeDef(7800.0f);
  steel.surface.category = 1;
  steel.surface.mask = 2;
  world.addSphere(world.createBody(striker), steel, 0.1f);
  Dominoes result;
  result.before = -totalsOf(world).momentum.z();
  for (int tick = 0; tick < 8; ++tick) {
    world.step(kTick);
    if (result.breaks.empty() && world.counters().breaks == 0) continue;
    result.breaks.push_back(world.counters().breaks);
    result.held.push_back(world.counters().held);
  }
  result.after = -totalsOf(world).momentum.z();
  return result;
}

class B27Pieces : public testing::TestWithParam<float> {};

TEST_P(B27Pieces, PushOnAndOnlyTheFourthWaitsForTheNextTick) {
  for (int phase = 0; phase < 64; ++phase) {
    const Dominoes three = push(3, GetParam(), phase);
    ASSERT_GE(three.breaks.size(), 2u) << "phase " << phase;
    EXPECT_EQ(three.breaks[0], 3u) << "phase " << phase;
    EXPECT_EQ(three.held[0], 1u) << "phase " << phase;
    EXPECT_EQ(three.breaks[1], 1u) << "phase " << phase;
    EXPECT_EQ(three.held[1], 0u) << "phase " << phase;
    const Dominoes all = push(0, GetParam(), phase);
    ASSERT_GE(all.breaks.size(), 1u) << "phase " << phase;
    EXPECT_EQ(all.breaks[0], 4u) << "phase " << phase;
    EXPECT_EQ(all.held[0], 0u) << "phase " << phase;
    const double exact = all.before - 4.0 * static_cast<double>(kStrength);
    EXPECT_NEAR(three.after, exact, 1e-4 * exact) << "phase " << phase;
    EXPECT_NEAR(all.after, exact, 1e-4 * exact) << "phase " << phase;
    hard::reportWorst("momentum of pieces off by",
                      maxOf(std::abs(three.after - exact), std::abs(all.after - exact)) / exact);
  }
}

INSTANTIATE_TEST_SUITE_P(Gaps, B27Pieces, testing::Values(0.0001f, 0.002f, 0.02f));

}  // namespace
}  // namespace brittle::physics
