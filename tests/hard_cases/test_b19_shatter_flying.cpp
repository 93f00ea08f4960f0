// B19: a block that flies and spins at 10 rad/s is cut into shards. Every shard goes on with v + w x r to 1e-5; linear
// and angular momentum are conserved to 1e-5, at the cut and by the contacts of the tick after it. (A body in free
// flight keeps its angular velocity, not its angular momentum, while it turns: the tick is compared at the poses it
// began with.)
#include <gtest/gtest.h>

#include <vector>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

struct Flight {
  World world;
  BodyHandle block;
  static WorldDef weightless() {
    WorldDef def;
    def.gravity = Vec3::Zero();
    return def;
  }
  explicit Flight(const Vec3& axis) : world(weightless()) {
    BodyDef def = bodyAt(Vec3(0.4f, -0.2f, 0.9f));
    def.velocity = Vec3(3.0f, -4.0f, 5.0f);
    def.angularVelocity = axis.normalized() * 10.0f;
    def.pose.rotation = integrateRotation(Quat::Identity(), Vec3(0.7f, -0.4f, 0.2f), 1.0f);
    def.breakable.strength = 1.0f;
    def.breakable.material.pattern = fracture::Pattern::Block;
    def.breakable.material.carveRadius = 0.6f;
    def.breakable.material.density = 6.0f;
    def.breakable.material.minVolume = 1e-9f;
    block = addBox(world, def, Vec3(0.5f, 0.4f, 0.3f), shapeDef(2500.0f));
  }
  void shatter() {
    const Body& body = world.body(block);
    world.breakBody(block, body.pose.toWorld(Vec3(0.1f, 0.4f, 0.05f)), Vec3(0.0f, -1.0f, 0.0f), 10.0f, 0.05f);
  }
};

double relativeDifference(const Vec3d& a, const Vec3d& b) {
  return (a - b).norm() / b.norm();
}

Totals afterOneTickAtTheOldPoses(World& world) {
  std::vector<BodyHandle> handles;
  std::vector<Transform> poses;
  world.forEachBody([&](BodyHandle handle, const Body& body) {
    handles.push_back(handle);
    poses.push_back(body.pose);
  });
  world.step(kTick);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const Vec3 velocity = world.body(handles[i]).velocity;
    const Vec3 spin = world.body(handles[i]).angularVelocity;
    world.setPose(handles[i], poses[i]);
    world.setVelocity(handles[i], velocity, spin);
  }
  return totalsOf(world);
}

class B19 : public testing::TestWithParam<int> {};

TEST_P(B19, ShardsGoOnAsTheyWereMoving) {
  const Vec3 axes[] = {Vec3(0.0f, 1.0f, 0.0f), Vec3(1.0f, 0.0f, 0.0f), Vec3(1.0f, 2.0f, -3.0f)};
  Flight flight(axes[GetParam()]);
  for (int i = 0; i < 7; ++i) flight.world.step(kTick);
  const Body whole = flight.world.body(flight.block);
  const Totals before = totalsOf(flight.world);
  flight.shatter();
  int shards = 0;
  const float scale = whole.velocity.norm() + whole.angularVelocity.norm() * whole.radius;
  flight.world.forEachBody([&](BodyHandle, const Body& shard) {
    ++shards;
    hard::reportWorst("velocities off by", double((shard.velocity - whole.velocityAt(shard.center)).norm() / scale));
    EXPECT_LT((shard.velocity - whole.velocityAt(shard.center)).norm(), 1e-5f * scale);
    EXPECT_LT((shard.angularVelocity - whole.angularVelocity).norm(), 1e-5f * whole.angularVelocity.norm());
  });
  EXPECT_GE(shards, 50);
  ASSERT_TRUE(flight.world.debris().crumbs.empty());
  const Totals cut = totalsOf(flight.world);
  EXPECT_LT(relativeDifference(cut.momentum, before.momentum), 1e-5);
  EXPECT_LT(relativeDifference(cut.angularMomentum, before.angularMomentum), 1e-5);
  EXPECT_NEAR(cut.kineticEnergy, before.kineticEnergy, 1e-5 * before.kineticEnergy);
  const Totals after = afterOneTickAtTheOldPoses(flight.world);
  EXPECT_LT(relativeDifference(after.momentum, before.momentum), 1e-5);
  EXPECT_LT(relativeDifference(after.angularMomentum, before.angularMomentum), 1e-5);
  hard::reportWorst("momentum off by", relativeDifference(after.momentum, before.momentum));
  hard::reportWorst("angular momentum off by", relativeDifference(after.angularMomentum, before.angularMomentum));
  EXPECT_LE(after.kineticEnergy, cut.kineticEnergy * (1.0 + 1e-6));
}

INSTANTIATE_TEST_SUITE_P(Axes, B19, testing::Values(0, 1, 2));

}  // namespace
}  // namespace brittle::physics
