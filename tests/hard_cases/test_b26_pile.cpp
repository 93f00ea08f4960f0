// B26: a pile of 1000 breakable boxes drops onto the floor, weak enough that everything breaks. Every tick ends within
// the allowed rounds; work per body stays bounded; no contact, joint or strike refers to what is gone; what is put off
// breaks in the next tick: none is lost.
#include <gtest/gtest.h>

#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr std::uint64_t kBoxes = 1000;

void expectNothingDangles(const State& state) {
  state.contacts.forEach([&](ContactHandle, const Contact& contact) {
    ASSERT_TRUE(state.shapes.contains(contact.a) && state.shapes.contains(contact.b));
  });
  state.shapes.forEach([&](ShapeHandle, const Shape& shape) { ASSERT_TRUE(state.bodies.contains(shape.body)); });
  state.bodies.forEach([&](BodyHandle handle, const Body& body) {
    std::uint32_t count = 0;
    for (ShapeHandle shape = body.firstShape; shape; shape = state.shapes[shape].next, ++count)
      ASSERT_EQ(state.shapes[shape].body, handle);
    ASSERT_EQ(count, body.shapeCount);
  });
  for (const Held& held : state.held) ASSERT_TRUE(state.bodies.contains(held.struck));
}

TEST(B26, APileInWhichEverythingBreaksIsDoneInTheAllowedRounds) {
  WorldDef def;
  def.accuracy.maxBodies = 100000;
  def.accuracy.patternDensity = 0.1f;
  World world(def);
  addFloor(world, 10.0f);
  std::vector<BodyHandle> boxes;
  for (int i = 0; i < static_cast<int>(kBoxes); ++i) {
    BodyDef box = bodyAt(Vec3(0.205f * static_cast<float>(i % 10), 0.3f + 0.205f * static_cast<float>(i / 100),
                              0.205f * static_cast<float>(i / 10 % 10)));
    box.velocity = Vec3(0.0f, -6.0f, 0.0f);
    box.breakable.strength = 0.05f;
    box.breakable.material.pattern = fracture::Pattern::Block;
    box.breakable.material.minVolume = 1.5e-3f;  // of 8e-3: few pieces each, the rest crumbs, and none breaks again
    boxes.push_back(addBox(world, box, Vec3(0.1f, 0.1f, 0.1f)));
  }
  std::uint64_t breaks = 0, pieces = 0, heldBefore = 0, broken = 0;
  const auto countBroken = [&] {
    std::uint64_t count = 0;
    for (const BodyHandle box : boxes) count += !world.isAlive(box) || world.body(box).brokenTick >= 0 ? 1 : 0;
    return count;
  };
  for (int tick = 0; tick < 60 && broken < kBoxes; ++tick) {
    world.step(kTick);
    broken = countBroken();
    const Counters& counters = world.counters();
    ASSERT_LE(counters.rounds, 3u) << tick;
    ASSERT_GE(counters.breaks, heldBefore > 0 ? 1u : 0u) << tick;
    ASSERT_LE(counters.contacts, 64u * counters.bodies) << tick;
    expectNothingDangles(world.state());
    heldBefore = counters.held;
    hard::reportWorst("rounds", counters.rounds);
    hard::reportWorst("contacts per body", double(counters.contacts) / counters.bodies);
    breaks += counters.breaks;
    pieces += counters.pieces;
  }
  while (!world.state().held.empty() && world.tick() < 70) world.step(kTick);
  EXPECT_EQ(broken, kBoxes) << breaks << " breaks";
  EXPECT_TRUE(world.state().held.empty());
  EXPECT_GE(breaks, kBoxes);
  EXPECT_LE(pieces, 40u * breaks);
  hard::reportSum("boxes broken", double(broken));
  hard::reportSum("still held", double(world.state().held.size()));
  world.forEachBody([&](BodyHandle, const Body& body) {
    ASSERT_TRUE(isFinite(body.center));
    ASSERT_LT(body.velocity.norm(), 20.0f);
  });
}

}  // namespace
}  // namespace brittle::physics
