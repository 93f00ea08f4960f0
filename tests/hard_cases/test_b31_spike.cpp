// B31: the tick in which a pane breaks is the heaviest there is. Its work grows linearly with the number of shards: per
// shard at most 1.5 times as much with 480 as with 30, contacts and passes of the solver bounded; and once the world
// has broken such panes before, it asks for no memory: neither a carve of 30 shards nor a pane that breaks as a whole.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"
#include "tests/hard_cases/work.h"
#include "tests/allocations.h"

namespace brittle::physics {
namespace {

constexpr float kPaneSize = 4.0f;  // [m]

fracture::FractureMaterial diceOf(int shards) {
  fracture::FractureMaterial material;
  material.pattern = fracture::Pattern::Tempered;
  material.dieSize = kPaneSize / std::sqrt(static_cast<float>(shards));
  return material;
}

/// Cracks about the impact, as many as give some 30 shards.
fracture::FractureMaterial carve() {
  fracture::FractureMaterial material;
  material.carveRadius = 0.5f;
  material.density = 1.45f;
  return material;
}

struct Spike {
  double seconds = 0.0;         // of the processor, in the tick of the break
  std::size_t allocations = 0;  // in it
  Counters counters;
};

/// A world in which one pane after another is hung up, shot and swept away.
class Range {
 public:
  Range() : floor_(addFloor(world_)) {}
  Spike shoot(const fracture::FractureMaterial& material) {
    BodyDef pane = bodyAt(Vec3(0.0f, 2.1f, 0.0f), BodyType::Static);
    pane.breakable.strength = 50.0f;
    pane.breakable.material = material;
    ShapeDef glass = shapeDef(2500.0f);
    glass.anchored = true;
    addBox(world_, pane, Vec3(0.5f * kPaneSize, 0.5f * kPaneSize, 0.03f), glass);
    addBall(world_, Vec3(0.1f, 2.0f, 0.6f), Vec3(0.0f, 0.0f, -25.0f), 0.25f, 500.0f);
    Spike spike;
    do spike = step();
    while (spike.counters.breaks == 0);
    for (int i = 0; i < 3; ++i) world_.step(kTick);
    sweep();
    return spike;
  }

 private:
  Spike step() {
    Spike spike;
    const std::size_t before = allocationCount();
    const double start = hard::cpuSeconds();
    world_.step(kTick);
    spike.seconds = hard::cpuSeconds() - start;
    spike.allocations = allocationCount() - before;
    spike.counters = world_.counters();
    return spike;
  }
  void sweep() {
    std::vector<BodyHandle> all;
    world_.forEachBody([&](BodyHandle body, const Body&) { all.push_back(body); });
    for (const BodyHandle body : all)
      if (!(body == floor_)) world_.destroyBody(body);
    world_.step(kTick);
    world_.meshes().clearDirty();  // as whoever draws it does
  }
  World world_;
  BodyHandle floor_;
};

TEST(B31, AWarmBreakAsksForNoMemory) {
  Range range;
  const int warm = hard::counted(10, 40);
  const int shots = hard::counted(6, 200);
  for (const fracture::FractureMaterial& material : {carve(), diceOf(100)}) {
    for (int i = 0; i < warm; ++i) range.shoot(material);
    for (int i = 0; i < shots; ++i) {
      const Spike spike = range.shoot(material);
      EXPECT_EQ(spike.allocations, 0u) << "shot " << i;
      EXPECT_GE(spike.counters.pieces, 20u);
      hard::reportSum("allocations", static_cast<double>(spike.allocations));
    }
  }
}

TEST(B31, WorkIsLinearInShards) {
  Range range;
  const hard::Spread spread = hard::spreadOf({30, 60, 120, 240, 480}, hard::counted(5, 20), 1.5, [&](int shards) {
    const Spike spike = range.shoot(diceOf(shards));
    EXPECT_GE(spike.counters.pieces, static_cast<std::uint32_t>(shards) * 3 / 4);
    EXPECT_LE(spike.counters.contacts, 8 * spike.counters.pieces);
    EXPECT_LE(spike.counters.passes, 3u);
    return spike.seconds / spike.counters.pieces;
  });
  EXPECT_LE(spread.ratio(), 1.5);
  hard::reportWorst("most work per shard over least", spread.ratio());
}

}  // namespace
}  // namespace brittle::physics
