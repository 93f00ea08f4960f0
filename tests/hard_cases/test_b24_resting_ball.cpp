// B24: a ball rests on a cracked pane that holds its weight: 10 s with less than 1 mm of drift and no break. Then the
// strength is lowered below the weight: the pane breaks once, and the ball falls with v = g t within 2 %.
#include <gtest/gtest.h>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

void restAndFall(bool deactivation, float dt) {
  WorldDef def;
  def.accuracy.deactivation = deactivation;
  World world(def);
  BodyDef pane = bodyAt(Vec3::Zero(), BodyType::Static);
  pane.breakable.strength = 1.0f;  // [N s]; the ball presses 0.16
  pane.breakable.material.carveRadius = 0.15f;
  pane.breakable.material.density = 0.5f;
  ShapeDef shape = shapeDef(5.0f);  // light shards: they take nothing from the falling ball
  shape.anchored = true;
  const BodyHandle glass = addBox(world, pane, Vec3(0.6f, 0.01f, 0.6f), shape);
  world.breakBody(glass, Vec3(0.45f, 0.01f, 0.45f), Vec3(0.0f, -1.0f, 0.0f), 10.0f, 0.02f);
  ASSERT_TRUE(world.isAlive(glass));
  const BodyHandle ball = addBall(world, Vec3(-0.1f, 0.11f, -0.15f), Vec3::Zero(), 0.1f, 1.0f);
  const auto seconds = [&](float time) { return static_cast<int>(time / dt + 0.5f); };
  for (int i = 0; i < seconds(0.25f); ++i) world.step(dt);
  const Vec3 start = world.body(ball).center;
  for (int i = 0; i < seconds(10.0f); ++i) {
    world.step(dt);
    ASSERT_EQ(world.counters().breaks, 0u) << i;
  }
  EXPECT_LT((world.body(ball).center - start).norm(), 1e-3f);
  hard::reportWorst("drift", 1000.0 * double((world.body(ball).center - start).norm()), "mm");

  Breakable weak = world.body(glass).breaking;
  weak.strength = 0.02f;
  world.setBreakable(glass, weak);
  std::uint32_t broken = 0;
  int fallen = 0;
  for (int i = 0; i < seconds(0.5f); ++i) {
    world.step(dt);
    broken += world.counters().breaks;
    fallen += broken > 0 ? 1 : 0;
  }
  EXPECT_EQ(broken, 1u);
  ASSERT_GT(fallen, seconds(0.45f));
  const float exact = 9.81f * dt * static_cast<float>(fallen);
  EXPECT_NEAR(-world.body(ball).velocity.y(), exact, 0.02f * exact);
  hard::reportWorst("fall off by", 100.0 * double(std::abs(-world.body(ball).velocity.y() - exact) / exact), "%");
}

TEST(B24, TheBallRestsThenFalls) {
  for (const float dt : {1.0f / 30.0f, 1.0f / 60.0f, 1.0f / 120.0f, 1.0f / 240.0f}) {
    SCOPED_TRACE(1.0f / dt);
    restAndFall(false, dt);
  }
}

TEST(B24, ASleepingBallFallsAsWell) {
  restAndFall(true, 1.0f / 60.0f);
}

}  // namespace
}  // namespace brittle::physics
