// B20: a body made 10 % deep inside something breakable breaks nothing while it is pushed out: only an impulse of
// relative velocity counts. A weak pane and a weak block, balls and boxes, with and without gravity, in every fracture
// mode. Engines that push out with velocities break here in the naive mode; ours pushes positions only, so its naive
// mode does not either.
#include <gtest/gtest.h>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

struct Arrangement {
  FractureMode mode = FractureMode::InStep;
  bool ball = true;
  bool gravity = false;
  bool block = false;  // a block that may move, instead of a pane that may not
};

BodyHandle addStruck(World& world, const Arrangement& how) {
  BodyDef def = bodyAt(Vec3(0.0f, how.block ? -0.2f : -0.01f, 0.0f), how.block ? BodyType::Dynamic : BodyType::Static);
  def.breakable.strength = how.gravity ? 1.0f : 1e-3f;  // with gravity: twice and more of what the weights press
  def.gravityScale = 0.0f;
  def.breakable.material.pattern = how.block ? fracture::Pattern::Block : fracture::Pattern::Pane;
  ShapeDef shape = shapeDef(2500.0f);
  shape.anchored = !how.block;
  return addBox(world, def, how.block ? Vec3(0.3f, 0.2f, 0.3f) : Vec3(0.5f, 0.01f, 0.5f), shape);
}

/// Both are 0.2 m high: a tenth of it, 2 cm, is inside.
BodyHandle addPenetrating(World& world, const Arrangement& how) {
  const Vec3 place(0.03f, 0.08f, -0.02f);
  if (how.ball) return addBall(world, place, Vec3::Zero(), 0.1f, 2.0f);
  return addBox(world, bodyAt(place), Vec3(0.1f, 0.1f, 0.1f), shapeDef(250.0f));
}

TEST(B20, PushingOutBreaksNothing) {
  for (const FractureMode mode : {FractureMode::InStep, FractureMode::AfterStep, FractureMode::AfterStepBlended}) {
    for (int i = 0; i < 8; ++i) {
      const Arrangement how{mode, (i & 1) != 0, (i & 2) != 0, (i & 4) != 0};
      WorldDef def;
      def.accuracy.fractureMode = mode;
      if (!how.gravity) def.gravity = Vec3::Zero();
      World world(def);
      const BodyHandle struck = addStruck(world, how);
      const BodyHandle body = addPenetrating(world, how);
      float fastest = 0.0f;
      for (int tick = 0; tick < 120; ++tick) {
        world.step(kTick);
        ASSERT_EQ(world.counters().breaks, 0u)
            << "mode " << static_cast<int>(mode) << ", how " << i << ", tick " << tick;
        fastest = maxOf(fastest, world.body(body).velocity.norm());
        hard::reportSum("breaks", world.counters().breaks);
      }
      if (how.gravity) continue;
      // Pushed out by positions: nothing has gained speed, and nothing of the depth is left.
      EXPECT_LT(fastest, 1e-4f) << "arrangement " << i;
      hard::reportWorst("pushed out at", double(fastest), "m/s");
      const float top = world.body(struck).center.y() + (how.block ? 0.2f : 0.01f);
      EXPECT_GT(world.body(body).center.y() - top, 0.1f - 0.001f) << "arrangement " << i;
    }
  }
}

}  // namespace
}  // namespace brittle::physics
