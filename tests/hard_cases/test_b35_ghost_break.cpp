// B35: a fast ball passes a pane within the speculative margin, at a speed that would break it, but misses it. In 1e4
// random grazes with a least distance above 0 none breaks, and the ball goes on as if there were no pane; those that
// cut into it break it.
#include <gtest/gtest.h>

#include "engine/core/random.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr float kRadius = 0.05f;
const Vec3 kPane(0.4f, 0.3f, 0.01f);  // half extents [m]

double distanceToPane(const Vec3d& point) {
  const Vec3d outside = (point.cwiseAbs() - kPane.cast<double>()).cwiseMax(0.0);
  return outside.norm();
}

/// Least distance of the ball's surface from the pane on the way from `start` in `direction`: convex in the way, so
/// thirds find it.
double leastDistance(const Vec3d& start, const Vec3d& direction, double length) {
  double low = 0.0, high = length;
  for (int i = 0; i < 200; ++i) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    if (distanceToPane(start + direction * a) < distanceToPane(start + direction * b))
      high = b;
    else
      low = a;
  }
  return distanceToPane(start + direction * (0.5 * (low + high))) - static_cast<double>(kRadius);
}

struct Graze {
  Vec3 start = Vec3::Zero(), velocity = Vec3::Zero();
  double distance = 0.0;
};

Vec3 randomDirection(Random& random) {
  for (;;) {
    const float x = 2.0f * random.nextFloat() - 1.0f;
    const float y = 2.0f * random.nextFloat() - 1.0f;
    const float z = 2.0f * random.nextFloat() - 1.0f;
    const Vec3 v(x, y, z);
    const float length = v.norm();
    if (length > 0.1f && length < 1.0f) return v / length;
  }
}

/// A way past an edge or a corner of the pane at about `wanted` from it.
Graze randomGraze(Random& random, float wanted) {
  for (;;) {
    const Vec3 direction = randomDirection(random);
    // A place on the rim, and a way out from it across the direction of flight.
    Vec3 rim(kPane.x(), kPane.y(), kPane.z());
    const std::uint32_t axis = random.nextBelow(4);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const float along = 2.0f * random.nextFloat() - 1.0f;
      rim[k] *= k == axis ? along : (along < 0.0f ? -1.0f : 1.0f);
    }
    const Vec3 out = direction.cross(randomDirection(random));
    if (out.norm() < 0.1f) continue;
    const Vec3 side = out.normalized() * (out.dot(rim) < 0.0f ? -1.0f : 1.0f);
    const Vec3 nearest = rim + side * (kRadius + wanted);
    const float speed = 20.0f + 100.0f * random.nextFloat();
    const float before = 0.6f + speed * kTick * random.nextFloat();
    Graze graze;
    graze.start = nearest - direction * before;
    graze.velocity = direction * speed;
    if (distanceToPane(graze.start.cast<double>()) < static_cast<double>(kRadius) + 0.05) continue;
    graze.distance = leastDistance(graze.start.cast<double>(), graze.velocity.cast<double>().normalized(), 10.0);
    return graze;
  }
}

struct Outcome {
  bool broke = false;
  float change = 0.0f;  // of velocity, relative
};

Outcome fly(const Graze& graze) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.patternDensity = 0.2f;
  World world(def);
  addPane(world, Vec3::Zero(), kPane, 0.05f, 1.0f);
  const BodyHandle ball = addBall(world, graze.start, graze.velocity, kRadius, 1.0f);
  const int ticks = static_cast<int>(2.5f / (graze.velocity.norm() * kTick)) + 2;
  Outcome outcome;
  for (int tick = 0; tick < ticks && !outcome.broke; ++tick) {
    world.step(kTick);
    outcome.broke = world.counters().breaks > 0;
  }
  outcome.change = (world.body(ball).velocity - graze.velocity).norm() / graze.velocity.norm();
  return outcome;
}

TEST(B35, WhatMissesBreaksNothing) {
  Random random(35, 1);
  int tried = 0, ghosts = 0, disturbed = 0;
  float worst = 0.0f;
  while (tried < 10000) {
    const Graze graze = randomGraze(random, 0.02f * random.nextFloat() * random.nextFloat());
    if (graze.distance < 1e-5 || graze.distance > 0.02) continue;
    ++tried;
    const Outcome outcome = fly(graze);
    ghosts += outcome.broke ? 1 : 0;
    disturbed += outcome.change > 1e-6f ? 1 : 0;
    worst = maxOf(worst, outcome.change);
    if (outcome.broke) ADD_FAILURE() << "broke at a distance of " << graze.distance;
  }
  EXPECT_EQ(ghosts, 0);
  hard::reportSum("grazes", tried);
  hard::reportSum("breaks without a touch", ghosts);
  EXPECT_EQ(disturbed, 0) << "worst relative change of velocity " << worst;
}

TEST(B35, WhatCutsDeepEnoughBreaks) {
  Random random(35, 2);
  int tried = 0, broke = 0;
  while (tried < 500) {
    const Graze graze = randomGraze(random, -0.03f * random.nextFloat());
    if (graze.distance > -0.01) continue;
    ++tried;
    broke += fly(graze).broke ? 1 : 0;
  }
  EXPECT_EQ(broke, tried);
}

}  // namespace
}  // namespace brittle::physics
