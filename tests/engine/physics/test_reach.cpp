#include "engine/physics/reach.h"

#include <gtest/gtest.h>

#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

/// Five boxes in a row on a floor, each against the next.
struct Row {
  World world;
  BodyHandle floor;
  std::vector<BodyHandle> boxes;
  Reach reach;

  Row() {
    floor = addFloor(world);
    for (int i = 0; i < 5; ++i)
      boxes.push_back(addBox(world, bodyAt(Vec3(0.2f * static_cast<float>(i), 0.1f, 0.0f)), Vec3::Constant(0.1f)));
    world.step(kTick);
  }
  State& state() { return world.state(); }
  /// Whether the contact of two bodies is in the list.
  bool holds(BodyHandle a, BodyHandle b) {
    for (const std::uint32_t slot : reach.contacts) {
      const Contact& contact = state().contacts.at(slot);
      const BodyHandle bodyA = state().shapes[contact.a].body;
      const BodyHandle bodyB = state().shapes[contact.b].body;
      if ((bodyA == a && bodyB == b) || (bodyA == b && bodyB == a)) return true;
    }
    return false;
  }
};

TEST(Reach, EndsAfterTheGivenStepsAndTakesEveryContactOnce) {
  Row row;
  reachFrom(row.state(), {row.boxes[0]}, 2, row.reach);
  EXPECT_EQ(row.reach.contacts.size(), 4u);
  EXPECT_TRUE(std::is_sorted(row.reach.contacts.begin(), row.reach.contacts.end()));
  EXPECT_TRUE(row.holds(row.floor, row.boxes[0]) && row.holds(row.boxes[0], row.boxes[1]));
  EXPECT_TRUE(row.holds(row.floor, row.boxes[1]) && row.holds(row.boxes[1], row.boxes[2]));
  EXPECT_TRUE(row.reach.takesIn(row.boxes[1], row.boxes[2]));
  EXPECT_FALSE(row.reach.takesIn(row.boxes[2], row.boxes[3]));
}

TEST(Reach, DoesNotLeadThroughWhatCannotMove) {
  Row row;
  const BodyHandle apart = addBox(row.world, bodyAt(Vec3(3.0f, 0.1f, 0.0f)), Vec3::Constant(0.1f));
  row.world.step(kTick);
  reachFrom(row.state(), {row.boxes[0]}, 100, row.reach);
  EXPECT_EQ(row.reach.contacts.size(), 9u);
  EXPECT_FALSE(row.holds(row.floor, apart));
  reachFrom(row.state(), {row.floor}, 1, row.reach);  // a changed floor: all that stands on it
  EXPECT_EQ(row.reach.contacts.size(), 6u);
  EXPECT_TRUE(row.holds(row.floor, apart));
}

TEST(Reach, FollowsJoints) {
  Row row;
  const BodyHandle apart = addBox(row.world, bodyAt(Vec3(3.0f, 0.1f, 0.0f)), Vec3::Constant(0.1f));
  JointDef rope;
  rope.type = JointType::Rope;
  rope.a = row.world.body(row.boxes[4]).firstShape;
  rope.b = row.world.body(apart).firstShape;
  rope.anchorA = row.world.body(row.boxes[4]).center;
  rope.anchorB = row.world.body(apart).center;
  row.world.createJoint(rope);
  row.world.step(kTick);
  reachFrom(row.state(), {row.boxes[4]}, 1, row.reach);
  EXPECT_FALSE(row.holds(row.floor, apart));
  reachFrom(row.state(), {row.boxes[4]}, 2, row.reach);
  EXPECT_TRUE(row.holds(row.floor, apart));
}

TEST(Reach, AllIsEveryContactWithPoints) {
  Row row;
  reachAll(row.state(), row.reach);
  EXPECT_EQ(row.reach.contacts.size(), 9u);
  EXPECT_TRUE(row.reach.takesIn(row.floor, row.boxes[3]));
}

}  // namespace
}  // namespace brittle::physics
