#include "engine/physics/sweep.h"

#include <gtest/gtest.h>

#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

const Vec3 kTile(0.05f, 0.01f, 0.05f);  // half extents [m]
const Vec3 kPlate(1.0f, 0.01f, 1.0f);

WorldDef weightless() {
  WorldDef def;
  def.gravity = Vec3::Zero();
  return def;
}

TEST(Sweep, WhatIsHitDoesNotFlyThroughWhatWasOutOfItsReach) {
  for (int phase = 0; phase < 32; ++phase) {
    World world(weightless());
    const BodyHandle rests = addBall(world, Vec3(0.0f, 0.0f, 0.0f), Vec3::Zero(), 0.05f, 1.0f);
    const Vec3 start(0.0f, 1.0f + 0.06f * static_cast<float>(phase), 0.0f);
    const BodyHandle flies = addBall(world, start, Vec3(0.0f, -120.0f, 0.0f), 0.05f, 2.0f);
    addBox(world, bodyAt(Vec3(0.0f, -0.7f, 0.0f), BodyType::Static), kPlate);
    for (int tick = 0; tick < 10; ++tick) {
      world.step(kTick);
      ASSERT_GT(world.body(rests).center.y(), -0.7f) << "phase " << phase << ", tick " << tick;
      ASSERT_GT(world.body(flies).center.y(), -0.7f) << "phase " << phase << ", tick " << tick;
    }
  }
}

// The plate is heavier than the balls by so little that the solver alone cannot hold them, and where they meet it
// depends on its having moved first.
TEST(Sweep, WhatIsHitDoesNotFlyThroughAPlateThatComesTowardsIt) {
  for (const float plateMass : {10.4f, 20.0f, 40.0f, 80.0f, 320.0f}) {
    for (int phase = 0; phase < 64; ++phase) {
      World world(weightless());
      const BodyHandle rests = addBall(world, Vec3(0.0f, 0.0f, 0.0f), Vec3::Zero(), 0.05f, 1.0f);
      const Vec3 start(0.0f, 1.0f + 0.03f * static_cast<float>(phase), 0.0f);
      const BodyHandle flies = addBall(world, start, Vec3(0.0f, -120.0f, 0.0f), 0.05f, 2.0f);
      BodyDef def = bodyAt(Vec3(0.0f, -0.9f, 0.0f));
      def.velocity = Vec3(0.0f, 12.0f, 0.0f);
      const BodyHandle plate = addBox(world, def, kPlate, shapeDef(plateMass / 0.08f));
      for (int tick = 0; tick < 8; ++tick) {
        world.step(kTick);
        const float middle = world.body(plate).center.y();
        ASSERT_GT(world.body(rests).center.y(), middle) << plateMass << " kg, phase " << phase << ", tick " << tick;
        ASSERT_GT(world.body(flies).center.y(), middle) << plateMass << " kg, phase " << phase << ", tick " << tick;
      }
    }
  }
}

// Each box is four times as heavy as the one below: none is so heavy that it would not give way, but together they
// press hard.
TEST(Sweep, WhatIsPressedStaysOnItsSide) {
  for (const float speed : {5.0f, 20.0f, 60.0f}) {
    World world(weightless());
    addBox(world, bodyAt(Vec3::Zero(), BodyType::Static), kPlate);
    std::vector<BodyHandle> boxes;
    for (int i = 0; i < 8; ++i) {
      BodyDef def = bodyAt(Vec3(0.0f, 0.021f + 0.0205f * static_cast<float>(i), 0.0f));
      def.velocity = Vec3(0.0f, i == 0 ? 0.0f : -speed, 0.0f);
      boxes.push_back(addBox(world, def, kTile, shapeDef(1000.0f * static_cast<float>(1 << (2 * i)))));
    }
    for (int tick = 0; tick < 60; ++tick) {
      world.step(kTick);
      for (std::size_t i = 0; i < boxes.size(); ++i)
        ASSERT_GT(world.body(boxes[i]).center.y(), 0.0f) << "box " << i << " at " << speed << " m/s, tick " << tick;
    }
  }
}

/// The lowest corner of all that moves. [m]
float lowestCorner(const World& world) {
  float lowest = 1.0f;
  const State& state = world.state();
  state.shapes.forEach([&](ShapeHandle, const Shape& shape) {
    const Body& body = state.bodyOf(shape);
    if (shape.isSphere() || !body.isDynamic()) return;
    for (const geometry::Vertex& vertex : state.meshes.view(shape.mesh).vertices)
      lowest = minOf(lowest, body.pose.toWorld(vertex.point).y());
  });
  return lowest;
}

// What is left of a pane has paid its strength to the floor when it broke there, and presses on: it may break again in
// the next tick, but it does not go through.
TEST(Sweep, WhatBreaksOnTheFloorStaysAboveIt) {
  const float halfThickness = 0.015f;
  for (const int substeps : {1, 2, 4, 8, 16}) {
    for (const float tilt : {0.0f, 0.1f}) {
      WorldDef def;
      def.accuracy.substeps = substeps;
      def.accuracy.patternDensity = 0.3f;
      World world(def);
      addFloor(world);
      BodyDef pane = bodyAt(Vec3(0.0f, 0.8f, 0.0f));
      pane.pose.rotation = integrateRotation(Quat::Identity(), Vec3(0.3f * tilt, 0.0f, tilt), 1.0f);
      pane.velocity = Vec3(0.0f, -8.0f, 0.0f);
      pane.breakable.strength = 10.0f;
      addBox(world, pane, Vec3(0.5f, 0.7f, halfThickness), shapeDef(2500.0f));
      std::uint32_t breaks = 0;
      for (int tick = 0; tick < 12; ++tick) {
        world.step(kTick);
        breaks += world.counters().breaks;
        ASSERT_GT(lowestCorner(world), -2.0f * halfThickness)
            << substeps << " sub-steps, tilted by " << tilt << ", tick " << tick;
      }
      EXPECT_GT(breaks, 1u) << substeps << " sub-steps, tilted by " << tilt;
    }
  }
}

}  // namespace
}  // namespace brittle::physics
