// B21: N anchored panes 5 cm apart, a ball of 1 kg. It leaves with v0 - N J / M whatever the phase of the gap within
// the tick, the tick length or the speed; when what it has left is less than J it is stopped by the next pane.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr float kStrength = 1.9f;  // [N s]
constexpr float kMass = 1.0f;      // [kg]
constexpr float kRadius = 0.05f;   // [m]
constexpr float kThickness = 0.004f;

struct Outcome {
  float exitSpeed = 0.0f;
  int broken = 0;
  int ticks = 0;
  float position = 0.0f;
};

/// Panes light enough that all the shards in the way weigh at most 0.1 % of the ball.
Outcome shoot(int panes, float speed, float dt, int phase) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.patternDensity = 0.3f;  // fewer shards: what is tested is the striker; all else is the default's
  const float density = minOf(2.0f, 8.0f / static_cast<float>(panes));
  World world(def);
  for (int i = 0; i < panes; ++i)
    addPane(world, Vec3(0.0f, 0.0f, -0.05f * static_cast<float>(i)), Vec3(0.3f, 0.3f, 0.5f * kThickness), kStrength,
            density);
  const float gap = 0.5f + speed * dt * static_cast<float>(phase) / 64.0f;
  const BodyHandle ball = addBall(world, Vec3(0.003f, 0.002f, gap), Vec3(0.0f, 0.0f, -speed), kRadius, kMass);
  Outcome outcome;
  int stoppedTicks = 0;
  std::set<std::uint32_t> broken;  // what is left of a pane may break again: it counts once
  const int most =
      static_cast<int>(3.0f / (dt * maxOf(speed - kStrength * static_cast<float>(panes), 1.0f))) + panes + 10;
  for (int tick = 0; tick < most; ++tick) {
    world.step(dt);
    for (const BreakEvent& event : world.events().breaks) broken.insert(event.assembly);
    outcome.ticks = tick + 1;
    const Body& now = world.body(ball);
    stoppedTicks = std::abs(now.velocity.z()) < 0.02f ? stoppedTicks + 1 : 0;
    if (now.center.z() < -0.05f * static_cast<float>(panes) - 0.5f || stoppedTicks == 5) break;
  }
  outcome.broken = static_cast<int>(broken.size());
  outcome.exitSpeed = -world.body(ball).velocity.z();
  outcome.position = world.body(ball).center.z();
  return outcome;
}

class B21 : public testing::TestWithParam<int> {};

void expectExactExit(int panes, float speed, float dt) {
  const float left = speed - static_cast<float>(panes) * kStrength / kMass;
  for (int phase = 0; phase < 64; ++phase) {
    const Outcome outcome = shoot(panes, speed, dt, phase);
    EXPECT_EQ(outcome.broken, panes) << speed << " m/s, dt 1/" << 1.0f / dt << ", phase " << phase;
    EXPECT_NEAR(outcome.exitSpeed, left, 0.02f * left) << speed << " m/s, dt 1/" << 1.0f / dt << ", phase " << phase;
    hard::reportWorst("exit speed off by", 100.0 * std::abs(outcome.exitSpeed - left) / left, "%");
    hard::reportSum("shots", 1);
  }
}

/// It breaks as many panes as it has J for and comes to rest before the next.
void expectStop(int panes, float speed, float dt) {
  const int broken = static_cast<int>(kMass * speed / kStrength);
  for (int phase = 0; phase < 64; ++phase) {
    const Outcome outcome = shoot(panes, speed, dt, phase);
    EXPECT_EQ(outcome.broken, broken) << speed << " m/s, dt 1/" << 1.0f / dt << ", phase " << phase;
    EXPECT_NEAR(outcome.exitSpeed, 0.0f, 0.02f) << speed << " m/s, dt 1/" << 1.0f / dt << ", phase " << phase;
    hard::reportSum("shots", 1);
    EXPECT_GT(outcome.position, -0.05f * static_cast<float>(broken)) << "phase " << phase;
  }
}

void shootAtAll(int panes, float dt) {
  for (const float speed : {5.0f, 10.0f, 20.0f, 50.0f, 100.0f, 200.0f}) {
    if (speed > static_cast<float>(panes) * kStrength / kMass) {
      expectExactExit(panes, speed, dt);
    } else {
      expectStop(panes, speed, dt);
    }
  }
}

TEST_P(B21, ExitSpeedIsExactInEveryPhase) {
  shootAtAll(GetParam(), 1.0f / 60.0f);
  if (!hard::isFull()) return;
  for (const float dt : {1.0f / 30.0f, 1.0f / 120.0f, 1.0f / 240.0f}) shootAtAll(GetParam(), dt);
}

INSTANTIATE_TEST_SUITE_P(Panes, B21, testing::Values(1, 3, 6, 16));

}  // namespace
}  // namespace brittle::physics
