// What breaks within one round breaks together, and what the older ways of breaking cost.
#include <gtest/gtest.h>

#include "engine/core/random.h"
#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

/// Three blocks in a row, one behind the other and touching, run into each other: the first is struck by the second,
/// which is struck by the third. All contacts exceed what the blocks hold.
TEST(Breakage, WhatIsStruckAndStrikesBreaksWithWhatItStruck) {
  for (int turned = 0; turned < 2; ++turned) {
    WorldDef def;
    def.gravity = Vec3::Zero();
    World world(def);
    std::vector<BodyHandle> blocks;
    for (int i = 0; i < 3; ++i) {
      const int place = turned != 0 ? 2 - i : i;  // the order in which they are made is the order in which they break
      BodyDef block = bodyAt(Vec3(0.0f, 0.0f, -0.199f * static_cast<float>(place)));
      block.velocity = Vec3(0.0f, 0.0f, -10.0f + 10.0f * static_cast<float>(place));
      block.breakable.strength = 0.5f + 0.1f * static_cast<float>(place);
      block.breakable.material.pattern = fracture::Pattern::Block;
      blocks.push_back(addBox(world, block, Vec3::Constant(0.1f), shapeDef(2500.0f)));
    }
    const Vec3d before = totalsOf(world).momentum;
    world.step(kTick);
    EXPECT_GE(world.counters().breaks, 2u);
    EXPECT_NEAR((totalsOf(world).momentum - before).norm(), 0.0, 1e-5 * 20.0 * 10.0);  // of one block
    for (int i = 0; i < 10; ++i) world.step(kTick);
  }
}

/// Balls, one after another, through two standing panes: how many pieces a breaking makes, over so many seeds.
double piecesOf(int iterations) {
  double pieces = 0.0, breaks = 0.0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(12, seed);
    WorldDef def;
    def.accuracy.iterations = iterations;
    World world(def);
    addFloor(world);
    for (const float z : {0.5f, -1.0f}) {
      BodyDef pane = bodyAt(Vec3(0.0f, 1.0f, z), BodyType::Static);
      pane.breakable.strength = 20.0f;
      world.anchor(addBox(world, pane, Vec3(1.5f, 1.0f, 0.015f), shapeDef(2500.0f)));
    }
    for (int i = 0; i < 6; ++i) {
      const float flight = 0.05f + 0.15f * static_cast<float>(i);  // until it is at the first pane [s]
      const float x = random.nextFloat(-1.2f, 1.2f);
      const float y = random.nextFloat(0.4f, 1.6f);
      addBall(world, Vec3(x, y, 1.5f + 18.0f * flight), Vec3(0.0f, 4.9f * flight, -18.0f), 0.1f, 8.0f, 0.2f);
    }
    for (int tick = 0; tick < 90; ++tick) {
      world.step(kTick);
      for (const BreakEvent& event : world.events().breaks) pieces += event.pieces;
      breaks += static_cast<double>(world.events().breaks.size());
    }
  }
  return pieces / breaks;
}

// Shards that a ball drives before it strike the second pane with it and share what breaks it. When each of them opened
// a hole of its own, ten sweeps made half as many pieces again as eleven.
TEST(Breakage, HowFinelyGlassBreaksIsNoQuestionOfSweeps) {
  const double ten = piecesOf(10);
  for (const int iterations : {9, 11, 12}) EXPECT_NEAR(piecesOf(iterations) / ten, 1.0, 0.15) << iterations;
}

/// Breakings of a standing pane that a ball goes through, within a second. It is so light that shards by themselves
/// break nothing.
std::uint32_t breaksOfOnePane(int substeps, float dt, const Vec3& at) {
  WorldDef def;
  def.accuracy.substeps = substeps;
  World world(def);
  addFloor(world);
  BodyDef pane = bodyAt(Vec3(0.0f, 1.0f, 0.0f), BodyType::Static);
  pane.breakable.strength = 20.0f;
  world.anchor(addBox(world, pane, Vec3(1.5f, 1.0f, 0.015f), shapeDef(400.0f)));
  addBall(world, at + Vec3(0.0f, 0.0f, 1.0f), Vec3(0.0f, 0.0f, -18.0f), 0.1f, 8.0f, 0.2f);
  for (int tick = 0; tick < static_cast<int>(1.0f / dt); ++tick) world.step(dt);
  return static_cast<std::uint32_t>(world.counters().totalBreaks);
}

// Shards that slide down beside the rest of the pane spend on the ball's account: while that still had what the first
// breaking cost, the rest had no strength left, and broke once or twice more at eight sub-steps.
TEST(Breakage, WhatBrokeIsPaidForWhateverTheStep) {
  for (const Vec3& at : {Vec3(-0.43f, 0.64f, 0.0f), Vec3(0.2f, 1.0f, 0.0f), Vec3(0.77f, 0.8f, 0.0f)}) {
    for (const int substeps : {1, 2, 4, 8}) EXPECT_EQ(breaksOfOnePane(substeps, kTick, at), 1u) << substeps;
    for (const float part : {2.0f, 4.0f}) EXPECT_EQ(breaksOfOnePane(1, kTick / part, at), 1u) << part;
  }
}

struct Shot {
  std::uint32_t breaks = 0;
  float exitSpeed = 0.0f;  // [m/s]
};

/// A ball of 1 kg at 20 m/s against a light pane that takes 1.9 N s.
Shot shoot(FractureMode mode, float blend, int phase) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.fractureMode = mode;
  def.accuracy.impulseCap = mode == FractureMode::InStep;
  def.accuracy.blend = blend;
  World world(def);
  addPane(world, Vec3::Zero(), Vec3(0.3f, 0.3f, 0.002f), 1.9f, 2.0f);
  const Vec3 start(0.003f, 0.002f, 0.3f + 20.0f / 60.0f * static_cast<float>(phase) / 16.0f);
  const BodyHandle ball = addBall(world, start, Vec3(0.0f, 0.0f, -20.0f), 0.05f, 1.0f);
  Shot shot;
  for (int tick = 0; tick < 10; ++tick) {
    world.step(kTick);
    shot.breaks += world.counters().breaks;
  }
  shot.exitSpeed = -world.body(ball).velocity.z();
  return shot;
}

struct Passage {
  std::uint32_t held = 0, mostRounds = 0;
  float exitSpeed = 0.0f;  // [m/s]
};

/// A ball of 10 cm and 1 kg through twelve light panes.
Passage pass(float speed, float spacing, std::int32_t fastRounds) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.fastRounds = fastRounds;
  def.accuracy.patternDensity = 0.3f;
  World world(def);
  for (int i = 0; i < 12; ++i)
    addPane(world, Vec3(0.0f, 0.0f, -spacing * static_cast<float>(i)), Vec3(0.3f, 0.3f, 0.002f), 0.1f, 0.5f);
  const BodyHandle ball = addBall(world, Vec3(0.003f, 0.002f, 0.07f), Vec3(0.0f, 0.0f, -speed), 0.05f, 1.0f);
  Passage passage;
  for (int tick = 0; tick < 12; ++tick) {
    world.step(kTick);
    passage.held += world.counters().held;
    passage.mostRounds = maxOf(passage.mostRounds, world.counters().rounds);
  }
  passage.exitSpeed = -world.body(ball).velocity.z();
  return passage;
}

TEST(Breakage, WhatIsFastBreaksOnInTheSameTickUpToItsBound) {
  const Passage three = pass(100.0f, 0.05f, 0), eight = pass(100.0f, 0.05f, 8), twelve = pass(100.0f, 0.05f, 12);
  EXPECT_EQ(three.mostRounds, 3u);
  EXPECT_EQ(three.held, 3u);
  EXPECT_EQ(eight.mostRounds, 8u);
  EXPECT_EQ(eight.held, 1u);
  EXPECT_EQ(twelve.mostRounds, 12u);
  EXPECT_EQ(twelve.held, 0u);
  for (const Passage& passage : {three, eight, twelve}) EXPECT_NEAR(passage.exitSpeed, 98.8f, 0.5f);
}

// 5 m/s are 8 cm in a tick: less than the ball. It would not be seen to hang.
TEST(Breakage, WhatIsSlowKeepsToTheRoundsThatAllHave) {
  const Passage none = pass(5.0f, 0.015f, 0), all = pass(5.0f, 0.015f, 64);
  EXPECT_EQ(none.mostRounds, 3u);
  EXPECT_GT(none.held, 0u);
  EXPECT_EQ(all.mostRounds, 3u);
  EXPECT_EQ(all.held, none.held);
  EXPECT_EQ(all.exitSpeed, none.exitSpeed);
}

// What they are kept for: to show that without care for when the glass breaks the phase of the tick decides.
TEST(Breakage, TheOlderWaysBreakAndCostWhatThePhaseOfTheTickSays) {
  float slowest = 20.0f;
  float fastest = 0.0f;
  for (int phase = 0; phase < 16; ++phase) {
    const Shot inStep = shoot(FractureMode::InStep, 0.5f, phase);
    EXPECT_EQ(inStep.breaks, 1u) << "phase " << phase;
    EXPECT_NEAR(inStep.exitSpeed, 18.1f, 0.02f * 18.1f) << "phase " << phase;
    const Shot after = shoot(FractureMode::AfterStep, 0.5f, phase);
    EXPECT_EQ(after.breaks, 1u) << "phase " << phase;
    slowest = minOf(slowest, after.exitSpeed);
    fastest = maxOf(fastest, after.exitSpeed);
    for (const float blend : {0.0f, 0.25f, 0.5f, 1.0f}) {
      const Shot blended = shoot(FractureMode::AfterStepBlended, blend, phase);
      EXPECT_EQ(blended.breaks, 1u) << "phase " << phase;
      const float mixed = 20.0f * blend + after.exitSpeed * (1.0f - blend);
      EXPECT_LT(blended.exitSpeed, mixed + 0.1f) << "phase " << phase << ", blend " << blend;
      EXPECT_GT(blended.exitSpeed, mixed - 1.9f)
          << "phase " << phase << ", blend " << blend;  // what is left may take J
    }
  }
  EXPECT_LT(slowest, 0.1f * 18.1f);
  EXPECT_GT(fastest - slowest, 0.5f * 18.1f);
}

}  // namespace
}  // namespace brittle::physics
