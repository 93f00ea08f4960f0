// Moving the origin moves what is somewhere, and nothing else.
#include <gtest/gtest.h>

#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

const Vec3 kShift(16.5f, 8.25f, -3.00390625f);  // [m], multiples of 2^-8

struct Scene {
  World world;
  BodyHandle box, lift;

  explicit Scene(const Vec3& origin) {
    addBox(world, bodyAt(Vec3(0.0f, -0.5f, 0.0f) - origin, BodyType::Static), Vec3(20.0f, 0.5f, 20.0f));
    box = addBox(world, bodyAt(Vec3(0.0f, 0.25f, 0.0f) - origin), Vec3(0.25f, 0.25f, 0.25f));
    lift = addBox(world, bodyAt(Vec3(3.0f, 1.0f, 0.0f) - origin, BodyType::Animated), Vec3(0.5f, 0.125f, 0.5f));
  }
  void sendLift(const Vec3& place) {
    Transform target;
    target.position = place;
    world.animate(world.body(lift).assembly, target);
  }
};

TEST(OriginShift, LeavesAloneWhatIsNowhere) {
  Scene scene(Vec3::Zero());
  scene.world.shiftOrigin(kShift);
  for (const BodyHandle handle : {scene.box, scene.lift})
    EXPECT_EQ(scene.world.body(handle).target.position, Vec3(Vec3::Zero()));
}

TEST(OriginShift, ATargetMovesWithIt) {
  Scene scene(Vec3::Zero());
  scene.sendLift(Vec3(3.0f, 1.25f, 0.0f));
  scene.world.shiftOrigin(kShift);
  scene.world.step(kTick);
  EXPECT_EQ(scene.world.body(scene.lift).pose.position, Vec3(3.0f, 1.25f, 0.0f) - kShift);
}

// Once it has been reached it is nowhere: the next shift has nothing to move.
TEST(OriginShift, ATargetThatWasReachedIsForgotten) {
  Scene scene(Vec3::Zero());
  scene.sendLift(Vec3(3.0f, 1.25f, 0.0f));
  scene.world.step(kTick);
  const Body& lift = scene.world.body(scene.lift);
  EXPECT_FALSE(lift.hasTarget);
  EXPECT_EQ(lift.target.position, Vec3(Vec3::Zero()));
  scene.world.shiftOrigin(kShift);
  EXPECT_EQ(lift.target.position, Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace brittle::physics
