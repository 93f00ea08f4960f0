// B27: a cascade. Breaking A lets the striker reach B in round 2, C in round 3 and D in round 4 of the same tick. With 3 rounds D is
// put off, reported as held, and breaks first thing in the next tick; with unbounded rounds all break at once. Either way the final
// momentum of the striker is the same to 1e-3 of what it had, and exact to 2 %.
#include <gtest/gtest.h>

#include "tests/engine/physics/scene.h"

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
    EXPECT_NEAR(all.exitSpeed, exact, 0.02f * exact) << "phase " << phase;
  }
}

}  // namespace
}  // namespace brittle::physics
