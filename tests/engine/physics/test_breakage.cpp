// What breaks within one round breaks together.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace brittle::physics
