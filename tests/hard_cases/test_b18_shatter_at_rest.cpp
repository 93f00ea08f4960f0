// B18: a block of 1 m at rest, no gravity, is cut into 100 shards in place without an impulse. The shards stay where
// they are: none is faster than 1e-3 m/s after 1 s, none has moved by more than the slop.
#include <gtest/gtest.h>

#include "engine/physics/collide.h"
#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

/// The smallest slop that any contact of this body may have. [m]
float slopOf(const State& state, const Body& body) {
  const Shape& shape = state.shapes[body.firstShape];
  return contactSlop(shape, shape);
}

void shatterAndWait(fracture::Pattern pattern, const Vec3& point, float turn, std::size_t least) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.deactivation = false;
  World world(def);
  BodyDef block = bodyAt(Vec3(0.3f, 1.7f, -2.1f));
  block.pose.rotation = integrateRotation(Quat::Identity(), Vec3(0.3f, 0.5f, 0.2f) * turn, 1.0f);
  block.breakable.strength = 1.0f;
  block.breakable.material.pattern = pattern;
  block.breakable.material.carveRadius = 0.6f;
  block.breakable.material.density = 10.0f;
  block.breakable.material.dieSize = 0.41f;
  const BodyHandle body = addBox(world, block, Vec3(0.5f, 0.5f, 0.5f), shapeDef(2500.0f));
  world.breakBody(body, block.pose.toWorld(point), Vec3(0.0f, -1.0f, 0.0f), 10.0f, 0.05f);
  std::vector<BodyHandle> shards;
  std::vector<Vec3> places;
  world.forEachBody([&](BodyHandle handle, const Body& shard) {
    shards.push_back(handle);
    places.push_back(shard.center);
  });
  ASSERT_GE(shards.size(), least);
  for (int i = 0; i < 60; ++i) world.step(kTick);
  float fastest = 0.0f;
  for (std::size_t i = 0; i < shards.size(); ++i) {
    const Body& shard = world.body(shards[i]);
    const float moved = (shard.center - places[i]).norm();
    EXPECT_LT(moved, slopOf(world.state(), shard)) << "shard " << i << " of radius " << shard.radius;
    hard::reportWorst("moved by", double(moved / slopOf(world.state(), shard)), "slops");
    fastest = maxOf(fastest, shard.velocity.norm() + shard.angularVelocity.norm() * shard.radius);
  }
  EXPECT_LT(fastest, 1e-3f);
  hard::reportWorst("fastest shard", double(fastest), "m/s");
}

TEST(B18, DiceOfABlockStayWhereTheyWereCut) {
  shatterAndWait(fracture::Pattern::Tempered, Vec3(0.1f, 0.5f, -0.05f), 0.0f, 100);
}

TEST(B18, DiceOfATurnedBlockStayWhereTheyWereCut) {
  shatterAndWait(fracture::Pattern::Tempered, Vec3(-0.2f, 0.5f, 0.1f), 1.0f, 100);
}

TEST(B18, ShardsOfABlockStayWhereTheyWereCut) {
  shatterAndWait(fracture::Pattern::Block, Vec3(0.1f, 0.5f, -0.05f), 0.4f, 80);
}

}  // namespace
}  // namespace brittle::physics
