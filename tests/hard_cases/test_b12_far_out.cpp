// B12: the same fracture at 0, 1e3, 1e4 and 1e5 m from where the world began. The origin follows: it is shifted there
// in steps of 1000 m before the scene is made, or the scene is made first and is carried out and back. Either way every
// shard is the same bits in its frame, and so are places and velocities, in every tick. For contrast without shifts: a
// pane out there is cut in its own frame, so its shards are whole and lose no volume, but contacts are floats of 1e5 m
// and the shards are others.
#include <gtest/gtest.h>

#include "engine/core/hash.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

/// On a grid of 1/16 m, which floats of 1e5 m still hold.
void addScene(World& world, const Vec3& origin) {
  BodyDef pane = bodyAt(origin + Vec3(0.0f, 1.0f, 0.0f), BodyType::Static);
  pane.breakable.strength = 1.0f;
  ShapeDef shape = shapeDef(2500.0f);
  shape.anchored = true;
  addBox(world, pane, Vec3(0.5f, 0.5f, 0.005f), shape);
  BodyDef block = bodyAt(origin + Vec3(0.25f, 0.5f, -1.0f));
  block.breakable.strength = 1.0f;
  block.breakable.material.pattern = fracture::Pattern::Block;
  addBox(world, block, Vec3(0.25f, 0.25f, 0.25f), shapeDef(2500.0f));
  addBox(world, bodyAt(origin + Vec3(0.0f, -0.5f, 0.0f), BodyType::Static), Vec3(10.0f, 0.5f, 10.0f));
  addBall(world, origin + Vec3(0.0625f, 1.125f, 0.5f), Vec3(0.3f, -1.0f, -20.0f), 0.05f, 1.0f);
  addBall(world, origin + Vec3(0.25f, 0.5f, 0.25f), Vec3(0.0f, 0.0f, -15.0f), 0.05f, 1.0f);
}

/// Of every body: its shapes in their frame, its place, its velocities.
std::uint64_t hashOf(const World& world) {
  StateHash hash;
  const auto add = [&](const Vec3& v) {
    for (int i = 0; i < 3; ++i) hash.add(v[i]);
  };
  world.forEachBody([&](BodyHandle, const Body& body) {
    add(body.velocity);
    add(body.angularVelocity);
    add(body.pose.position);
    for (ShapeHandle shape = body.firstShape; shape; shape = world.shape(shape).next)
      hash.add(world.shape(shape).meshHash);
  });
  return hash.value();
}

/// The hash before each tick. At least two bodies break.
std::vector<std::uint64_t> play(World& world) {
  std::vector<std::uint64_t> hashes;
  std::uint32_t breaks = 0;
  for (int tick = 0; tick < hard::counted(20, 600); ++tick) {
    hashes.push_back(hashOf(world));
    world.step(kTick);
    breaks += world.counters().breaks;
  }
  EXPECT_GE(breaks, 2u);
  hard::reportSum("ticks compared", static_cast<double>(hashes.size()));
  return hashes;
}

/// In steps as a game makes them.
void travel(World& world, float distance) {
  const float step = distance < 0.0f ? -1000.0f : 1000.0f;
  for (float gone = 0.0f; gone < std::abs(distance); gone += 1000.0f) world.shiftOrigin(Vec3(step, 0.0f, -step));
}

class B12 : public testing::TestWithParam<float> {};

TEST_P(B12, WhatIsMadeOutThereBreaksTheSame) {
  std::vector<std::uint64_t> played[2];
  for (const bool isFar : {false, true}) {
    World world;
    const BodyHandle left =
        addBox(world, bodyAt(Vec3(0.0f, 500.0f, 0.0f), BodyType::Static), Vec3::Ones());  // where it began
    travel(world, isFar ? GetParam() : 1000.0f);
    world.destroyBody(left);  // else it is in the tree, whose order contacts follow
    addScene(world, Vec3::Zero());
    played[isFar] = play(world);
  }
  EXPECT_EQ(played[0], played[1]);
}

TEST_P(B12, WhatTravelledOutAndBackBreaksTheSame) {
  World stayed, travelled;
  addScene(stayed, Vec3::Zero());
  addScene(travelled, Vec3::Zero());
  travel(travelled, GetParam());
  travel(travelled, -GetParam());
  EXPECT_EQ(play(travelled), play(stayed));
}

/// What the shifts are for.
TEST_P(B12, WithoutAShiftShardsAreOthersButStillWhole) {
  if (GetParam() > 1e4f) GTEST_SKIP() << "the world takes no bodies so far out";
  World world, far;
  addScene(world, Vec3::Zero());
  addScene(far, Vec3(GetParam(), 0.0f, GetParam()));
  double volumes[2] = {0.0, 0.0};
  for (World* one : {&world, &far}) {
    for (int tick = 0; tick < 10; ++tick) one->step(kTick);
    one->forEachBody([&](BodyHandle, const Body& body) {
      for (ShapeHandle at = body.firstShape; at; at = one->shape(at).next) {
        const Shape& shape = one->shape(at);
        volumes[one == &far] += static_cast<double>(shape.massProperties.volume);
        if (shape.isSphere()) continue;
        EXPECT_STREQ(geometry::findTopologyError(one->meshes().view(shape.mesh)), nullptr);
      }
    });
    for (const Crumb& crumb : one->debris().crumbs) volumes[one == &far] += static_cast<double>(crumb.volume);
  }
  EXPECT_NEAR(volumes[1] / volumes[0], 1.0, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Metres, B12, testing::Values(0.0f, 1e3f, 1e4f, 1e5f));

}  // namespace
}  // namespace brittle::physics
