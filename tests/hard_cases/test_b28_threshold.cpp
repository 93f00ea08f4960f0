// B28: the threshold is an edge. A ball whose momentum is J (1 - 1e-6) breaks nothing and rebounds as from a rigid
// wall; one of J (1 + 1e-6) breaks the pane. Over 1000 speeds there is one crossing only.
#include <gtest/gtest.h>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr float kStrength = 1.9f;  // [N s]

struct Outcome {
  bool broke = false;
  float speed = 0.0f;  // after [m/s], back towards where it came from
};

/// A ball of 1 kg with `ratio` of the momentum that breaks the pane. `strength` 0: a rigid wall.
Outcome hit(double ratio, float strength, float gap, float restitution) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.patternDensity = 0.2f;
  World world(def);
  addPane(world, Vec3::Zero(), Vec3(0.3f, 0.3f, 0.01f), strength, 1.0f);
  const BodyHandle ball = addBall(world, Vec3(0.01f, 0.02f, 0.06f + gap), Vec3::Zero(), 0.05f, 1.0f, restitution);
  const double speed = static_cast<double>(kStrength) * ratio / static_cast<double>(world.body(ball).mass);
  world.setVelocity(ball, Vec3(0.0f, 0.0f, -static_cast<float>(speed)), Vec3::Zero());
  Outcome outcome;
  for (int tick = 0; tick < 8; ++tick) {
    world.step(kTick);
    outcome.broke = outcome.broke || world.counters().breaks > 0;
  }
  outcome.speed = world.body(ball).velocity.z();
  return outcome;
}

TEST(B28, AMillionthBelowReboundsAndAMillionthAboveBreaks) {
  for (int phase = 0; phase < 64; ++phase) {
    const float gap = kStrength * kTick * (0.5f + static_cast<float>(phase) / 64.0f);
    for (const float restitution : {0.0f, 0.5f, 1.0f}) {
      const Outcome below = hit(1.0 - 1e-6, kStrength, gap, restitution);
      const Outcome rigid = hit(1.0 - 1e-6, 0.0f, gap, restitution);
      EXPECT_FALSE(below.broke) << "phase " << phase << ", restitution " << restitution;
      EXPECT_NEAR(below.speed, rigid.speed, 1e-5f * kStrength) << "phase " << phase << ", restitution " << restitution;
      hard::reportWorst("rebound off by", double(std::abs(below.speed - rigid.speed) / kStrength));
      EXPECT_NEAR(below.speed, restitution * kStrength, 1e-4f * kStrength)
          << "phase " << phase << ", restitution " << restitution;
      EXPECT_TRUE(hit(1.0 + 1e-6, kStrength, gap, restitution).broke)
          << "phase " << phase << ", restitution " << restitution;
    }
  }
}

TEST(B28, OneCrossingOverAThousandSpeeds) {
  int crossings = 0;
  bool last = false;
  for (int i = 0; i <= 1000; ++i) {
    const bool broke = hit(0.5 + static_cast<double>(i) / 1000.0 + 5e-5, kStrength, 0.02f, 0.3f).broke;
    crossings += broke != last ? 1 : 0;
    last = broke;
  }
  EXPECT_TRUE(last);
  EXPECT_EQ(crossings, 1);
  hard::reportWorst("crossings", crossings);
}

TEST(B28, OneCrossingOverAThousandSpeedsNearTheEdge) {
  int crossings = 0;
  bool last = false;
  for (int i = 0; i <= 1000; ++i) {
    const bool broke = hit(1.0 + 1e-7 * static_cast<double>(i - 500), kStrength, 0.02f, 0.3f).broke;
    crossings += broke != last ? 1 : 0;
    last = broke;
  }
  EXPECT_TRUE(last);
  EXPECT_EQ(crossings, 1);
  hard::reportWorst("crossings", crossings);
}

}  // namespace
}  // namespace brittle::physics
