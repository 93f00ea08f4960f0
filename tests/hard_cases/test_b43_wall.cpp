// B43: a wall of 40 x 25 bricks in running bond, whole ones and at both ends halves, stands for 60 s awake: its top
// sinks by less than 20 mm, and its energy, potential and kinetic, never rises above the least it has been by 1e-6 of
// it.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

const Vec3 kBrick(0.2f, 0.1f, 0.1f);  // half extents [m]
constexpr float kJoint = 0.01f;       // between the bricks of a row [m]
constexpr int kRows = 25;

struct Brick {
  BodyHandle body;
  Vec3 laid = Vec3::Zero();
};

struct Wall {
  World world;
  std::vector<Brick> bricks;  // row by row from below

  explicit Wall(int columns) : world(alwaysAwake()) {
    addFloor(world);
    const float pitch = 2.0f * kBrick.x() + kJoint;
    const float half = 0.5f * kBrick.x() - 0.25f * kJoint;
    const float end = 0.5f * pitch * static_cast<float>(columns - 1) + kBrick.x();
    for (int row = 0; row < kRows; ++row) {
      const bool even = row % 2 == 0;
      const int whole = even ? columns : columns - 1;
      for (int i = 0; i < whole; ++i) lay(pitch * (static_cast<float>(i) - 0.5f * static_cast<float>(whole - 1)), row);
      if (even) continue;
      lay(half - end, row, half);
      lay(end - half, row, half);
    }
  }
  void lay(float x, int row, float halfLength = kBrick.x()) {
    const Vec3 place(x, kBrick.y() * static_cast<float>(1 + 2 * row), 0.0f);
    const Vec3 halfExtents(halfLength, kBrick.y(), kBrick.z());
    bricks.push_back({addBox(world, bodyAt(place), halfExtents, shapeDef(2000.0f)), place});
  }
  double energy() const {
    double sum = totalsOf(world).kineticEnergy;
    for (const Brick& brick : bricks) {
      const Body& body = world.body(brick.body);
      sum += 9.81 * static_cast<double>(body.mass) * static_cast<double>(body.center.y());
    }
    return sum;
  }
  /// How far the lowest brick of the top row is below where it was laid. [m]
  float sunk() const {
    const float top = bricks.back().laid.y();
    float most = 0.0f;
    for (const Brick& brick : bricks)
      if (brick.laid.y() == top) most = maxOf(most, top - world.body(brick.body).center.y());
    return most;
  }
  /// How far the worst brick has gone sideways. [m]
  float aside() const {
    float most = 0.0f;
    for (const Brick& brick : bricks) {
      const Vec3 gone = world.body(brick.body).center - brick.laid;
      most = maxOf(most, std::sqrt(gone.x() * gone.x() + gone.z() * gone.z()));
    }
    return most;
  }
};

TEST(B43, TheWallStands) {
  Wall wall(hard::counted(20, 40));
  const int ticks = 60 * hard::counted(5, 60);
  const double start = wall.energy();
  double least = start, rise = 0.0;
  float sunk = 0.0f;
  for (int tick = 0; tick < ticks; ++tick) {
    wall.world.step(kTick);
    const double now = wall.energy();
    rise = maxOf(rise, (now - least) / start);
    least = minOf(least, now);
    sunk = maxOf(sunk, wall.sunk());
    ASSERT_LT(sunk, 0.02f) << "tick " << tick;
    ASSERT_LT(rise, 1e-6) << "tick " << tick;
  }
  EXPECT_EQ(wall.world.counters().awakeBodies, wall.bricks.size());
  hard::reportSum("bricks", static_cast<double>(wall.bricks.size()));
  hard::reportWorst("top sinks", 1000.0 * static_cast<double>(sunk), "mm");
  hard::reportWorst("a brick moves aside", 1000.0 * static_cast<double>(wall.aside()), "mm");
  hard::reportWorst("energy rises by", rise);
}

}  // namespace
}  // namespace brittle::physics
