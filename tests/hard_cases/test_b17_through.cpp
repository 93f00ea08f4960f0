// B17: a ball of 0.1 kg and 2 cm radius at 100 m/s meets a 2 cm anchored pane head-on; it travels 1.67 m per tick. From
// 64 phases of the gap it is neither stopped nor does it pass without breaking; momentum balances to 1e-5 with the J
// the anchors took; the exit speed is at most v0 - J/M, and within 2 % of it when the shards in its path are light;
// kinetic energy never rises.
#include <gtest/gtest.h>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr float kStrength = 1.9f;  // [N s]
constexpr float kMass = 0.1f;      // [kg]
constexpr float kSpeed = 100.0f;   // [m/s]

struct Shot {
  World world;
  BodyHandle ball;
  explicit Shot(int phase, float density) : world(weightless()) {
    addPane(world, Vec3::Zero(), Vec3(0.5f, 0.5f, 0.01f), kStrength, density);
    const float gap = 0.2f + kSpeed * kTick * static_cast<float>(phase) / 64.0f;
    ball = addBall(world, Vec3(0.01f, -0.02f, 0.03f + gap), Vec3(0.0f, 0.0f, -kSpeed), 0.02f, kMass);
  }
  static WorldDef weightless() {
    WorldDef def;
    def.gravity = Vec3::Zero();
    return def;
  }
};

TEST(B17, TheMomentumPaidIsExactlyTheStrength) {
  for (int phase = 0; phase < 64; ++phase) {
    Shot shot(phase, 2500.0f);
    const Vec3d before = totalsOf(shot.world).momentum;
    double energy = totalsOf(shot.world).kineticEnergy;
    int broken = 0;
    for (int tick = 0; tick < 4; ++tick) {
      shot.world.step(kTick);
      broken += static_cast<int>(shot.world.counters().breaks);
      const Totals now = totalsOf(shot.world);
      EXPECT_LE(now.kineticEnergy, energy * (1.0 + 1e-6)) << "phase " << phase << ", tick " << tick;
      energy = now.kineticEnergy;
    }
    ASSERT_EQ(broken, 1) << "phase " << phase;
    const double given = totalsOf(shot.world).momentum.z() - before.z();
    EXPECT_NEAR(given, kStrength, 1e-5 * kMass * kSpeed) << "phase " << phase;
    hard::reportWorst("momentum off by", std::abs(given - double(kStrength)) / double(kMass * kSpeed));
    EXPECT_LE(-shot.world.body(shot.ball).velocity.z(), kSpeed - kStrength / kMass + 1e-4f) << "phase " << phase;
    EXPECT_LT(shot.world.body(shot.ball).center.z(), -0.05f) << "phase " << phase;
  }
}

TEST(B17, LightShardsTakeNothing) {
  for (int phase = 0; phase < 64; ++phase) {
    Shot shot(phase, 1.0f);
    for (int tick = 0; tick < 6; ++tick) shot.world.step(kTick);
    const float exact = kSpeed - kStrength / kMass;
    const float exit = -shot.world.body(shot.ball).velocity.z();
    EXPECT_NEAR(exit, exact, 0.02f * exact) << "phase " << phase;
    hard::reportWorst("exit speed off by", 100.0 * double(std::abs(exit - exact) / exact), "%");
  }
}

}  // namespace
}  // namespace brittle::physics
