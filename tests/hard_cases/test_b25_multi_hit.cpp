// B25: 2, 8 and 64 balls strike one pane in the same tick, also one body with two contacts. The pane breaks once, each
// ball pays J once and leaves with v0 - J/M within 2 %, a body with two contacts too. Whoever was made first, the
// shards are the same to the bit: impacts on one body are taken in the order of their places. (Contacts between shards
// are solved in the order of their slots.)
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "engine/core/random.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr float kStrength = 1.9f;  // [N s]
constexpr float kSpeed = 20.0f;    // [m/s]

struct Outcome {
  std::vector<float> exitSpeeds;      // by place
  std::vector<std::uint64_t> shards;  // hashes of the shapes made in the tick of the break, sorted
  std::uint32_t breaks = 0;
};

void collectShards(const World& world, std::vector<std::uint64_t>& shards) {
  world.forEachBody([&](BodyHandle, const Body& body) {
    for (ShapeHandle shape = body.firstShape; shape; shape = world.shape(shape).next)
      if (world.shape(shape).isPiece) shards.push_back(world.shape(shape).meshHash);
  });
  std::sort(shards.begin(), shards.end());
}

/// Places on a square grid, near enough in depth that all arrive within one tick.
Vec3 placeOf(int i, int count) {
  const int side = count <= 2 ? count : (count <= 8 ? 4 : 8);
  const float spacing = 0.24f;
  const float x = spacing * (static_cast<float>(i % side) - 0.5f * static_cast<float>(side - 1));
  const float y = spacing * (static_cast<float>(i / side) - 0.5f * static_cast<float>((count - 1) / side));
  return Vec3(x + 0.003f, y - 0.002f, 0.1f + 0.001f * static_cast<float>(i * 7 % 13));
}

Outcome shoot(int count, const std::vector<int>& order) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.patternDensity = 0.3f;
  def.accuracy.maxBodies = 100000;
  World world(def);
  BodyDef pane = bodyAt(Vec3::Zero(), BodyType::Static);
  pane.breakable.strength = kStrength;
  pane.breakable.material.carveRadius = 0.04f;
  ShapeDef shape = shapeDef(1.0f);
  shape.anchored = true;
  addBox(world, pane, Vec3(1.05f, 1.05f, 0.005f), shape);
  std::vector<BodyHandle> balls(static_cast<std::size_t>(count));
  for (const int i : order)
    balls[static_cast<std::size_t>(i)] = addBall(world, placeOf(i, count), Vec3(0.0f, 0.0f, -kSpeed), 0.04f, 1.0f);
  Outcome outcome;
  for (int tick = 0; tick < 4; ++tick) {
    world.step(kTick);
    outcome.breaks += world.counters().breaks;
    if (world.counters().breaks > 0) collectShards(world, outcome.shards);
  }
  for (const BodyHandle ball : balls) outcome.exitSpeeds.push_back(-world.body(ball).velocity.z());
  return outcome;
}

void expectExit(float speed, const std::string& which) {
  const float exact = kSpeed - kStrength;
  EXPECT_NEAR(speed, exact, 0.02f * exact) << which;
  hard::reportWorst("exit speed off by", 100.0 * double(std::abs(speed - exact) / exact), "%");
}

class B25 : public testing::TestWithParam<int> {};

TEST_P(B25, EveryBallPaysOnceWhoeverWasMadeFirst) {
  const int count = GetParam();
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  const Outcome first = shoot(count, order);
  EXPECT_EQ(first.breaks, 1u);
  for (std::size_t i = 0; i < first.exitSpeeds.size(); ++i)
    expectExit(first.exitSpeeds[i], "ball " + std::to_string(i));
  Random random(25, static_cast<std::uint64_t>(count));
  for (int shuffle = 0; shuffle < 3; ++shuffle) {
    for (std::uint32_t i = 0; i + 1 < order.size(); ++i) {
      const std::uint32_t other = i + random.nextBelow(static_cast<std::uint32_t>(order.size()) - i);
      std::swap(order[i], order[other]);
    }
    if (shuffle == 0) std::reverse(order.begin(), order.end());
    const Outcome again = shoot(count, order);
    EXPECT_EQ(again.breaks, 1u);
    EXPECT_EQ(again.shards, first.shards) << "shuffle " << shuffle;
    hard::reportSum("shuffles alike", again.shards == first.shards ? 1 : 0);
    for (std::size_t i = 0; i < first.exitSpeeds.size(); ++i)
      expectExit(again.exitSpeeds[i], "ball " + std::to_string(i) + ", shuffle " + std::to_string(shuffle));
  }
}

INSTANTIATE_TEST_SUITE_P(Balls, B25, testing::Values(2, 8, 64));

TEST(B25Dumbbell, TwoContactsOfOneBodyPayOnce) {
  for (int phase = 0; phase < 64; ++phase) {
    WorldDef def;
    def.gravity = Vec3::Zero();
    def.accuracy.patternDensity = 0.3f;
    World world(def);
    addPane(world, Vec3::Zero(), Vec3(0.6f, 0.6f, 0.005f), kStrength, 1.0f);
    BodyDef body = bodyAt(Vec3(0.0f, 0.0f, 0.2f + kSpeed * kTick * static_cast<float>(phase) / 64.0f));
    body.velocity = Vec3(0.0f, 0.0f, -kSpeed);
    const BodyHandle dumbbell = world.createBody(body);
    const float radius = 0.05f;
    const float density = 0.5f / (4.0f / 3.0f * kPi * radius * radius * radius);
    world.addSphere(dumbbell, shapeDef(density), radius, Vec3(-0.1f, 0.0f, 0.0f));
    world.addSphere(dumbbell, shapeDef(density), radius, Vec3(0.1f, 0.0f, 0.0f));
    std::uint32_t breaks = 0;
    for (int tick = 0; tick < 5; ++tick) {
      world.step(kTick);
      breaks += world.counters().breaks;
    }
    EXPECT_EQ(breaks, 1u) << "phase " << phase;
    expectExit(-world.body(dumbbell).velocity.z(), "phase " + std::to_string(phase));
  }
}

}  // namespace
}  // namespace brittle::physics
