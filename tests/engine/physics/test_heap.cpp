#include "engine/physics/heap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

BodyHandle addCube(World& world, float x, float y, BodyType type = BodyType::Dynamic) {
  return addBox(world, bodyAt(Vec3(x, y, 0.0f), type), Vec3::Constant(0.1f));
}

Heap heapOf(const World& world, BodyHandle body) {
  Heap heap;
  world.heapOf(body, heap);
  std::sort(heap.bodies.begin(), heap.bodies.end());
  return heap;
}

TEST(Heap, IsAllThatTouchesAndEndsAtWhatStandsStill) {
  World world;
  addFloor(world);
  const BodyHandle low = addCube(world, 0.0f, 0.1f), middle = addCube(world, 0.0f, 0.3f),
                   high = addCube(world, 0.0f, 0.5f);
  const BodyHandle beside = addCube(world, 1.0f, 0.1f);
  for (int i = 0; i < 60; ++i) world.step(kTick);
  for (const BodyHandle body : {low, middle, high})
    EXPECT_EQ(heapOf(world, body).bodies, (std::vector<BodyHandle>{low, middle, high}));
  EXPECT_EQ(heapOf(world, beside).bodies, std::vector<BodyHandle>{beside});
  EXPECT_FALSE(heapOf(world, high).isCarried);
}

TEST(Heap, IsCarriedByALift) {
  World world;
  addCube(world, 0.0f, 0.1f, BodyType::Animated);
  const BodyHandle low = addCube(world, 0.0f, 0.3f), high = addCube(world, 0.0f, 0.5f);
  for (int i = 0; i < 60; ++i) world.step(kTick);
  EXPECT_TRUE(heapOf(world, high).isCarried);
  EXPECT_TRUE(heapOf(world, low).isCarried);
}

TEST(Heap, IsCarriedByAJoint) {
  World world;
  addFloor(world);
  const BodyHandle low = addCube(world, 0.0f, 0.1f), high = addCube(world, 0.0f, 0.3f);
  JointDef rope;
  rope.type = JointType::Rope;
  rope.a = world.body(low).firstShape;
  rope.anchorA = Vec3(0.1f, 0.1f, 0.0f);
  rope.anchorB = Vec3(0.5f, 0.1f, 0.0f);
  const JointHandle joint = world.createJoint(rope);
  for (int i = 0; i < 30; ++i) world.step(kTick);
  EXPECT_TRUE(heapOf(world, high).isCarried);
  world.destroyJoint(joint);
  EXPECT_FALSE(heapOf(world, high).isCarried);
}

TEST(Heap, IsCarriedByADrive) {
  World world;
  addFloor(world);
  const BodyHandle low = addCube(world, 0.0f, 0.1f), high = addCube(world, 0.0f, 0.3f);
  DriveDef pull;
  pull.assembly = world.body(low).assembly;
  pull.drivePosition = true;
  pull.position = Vec3(0.0f, 0.1f, 0.0f);
  const DriveHandle drive = world.createDrive(pull);
  for (int i = 0; i < 30; ++i) world.step(kTick);
  EXPECT_TRUE(heapOf(world, high).isCarried);
  world.destroyDrive(drive);
  EXPECT_FALSE(heapOf(world, high).isCarried);
}

}  // namespace
}  // namespace brittle::physics
