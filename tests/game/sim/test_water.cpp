#include "game/sim/water.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/geometry/make.h"
#include "engine/math/trig.h"
#include "game/sim/ball.h"
#include "tests/game/sim/fixture.h"

namespace brittle::sim {
namespace {

/// A world with gravity and a lake whose surface is at y = 0.
class Lake : public ::testing::Test {
 protected:
  explicit Lake(float gravity = rules::kGravity) : world_(worldOf(gravity)), gravity_(gravity) {}
  static physics::WorldDef worldOf(float gravity) {
    physics::WorldDef def;
    def.gravity = Vec3(0.0f, -gravity, 0.0f);
    return def;
  }
  physics::BodyHandle addBall(const Vec3& place, const Vec3& velocity) {
    return makeBall(world_, {place, velocity}, 1);
  }
  physics::BodyHandle addCube(const Vec3& place, float half, float density) {
    physics::BodyDef def;
    def.type = physics::BodyType::Dynamic;
    def.pose.position = place;
    const physics::BodyHandle body = world_.createBody(def);
    physics::ShapeDef shape;
    shape.surface.density = density;
    world_.addConvex(body, shape, geometry::makeBox<float>(Vec3::Constant(half)));
    return body;
  }
  void tick() {
    waters_.slow(world_, lake_, 0.0f, gravity_ / rules::kGravity);
    world_.step(rules::kTickSeconds);
  }
  void tick(int ticks) {
    for (int i = 0; i < ticks; ++i) tick();
  }

  physics::World world_;
  Waters waters_;
  float gravity_;
  std::vector<PlannedWater> lake_ = {{Vec3::Zero(), Vec2(50.0f, 50.0f), {32, 32}}};
};

class StillLake : public Lake {
 protected:
  StillLake() : Lake(0.0f) {}
};

constexpr float kBallArea = kPi * rules::kBallRadius * rules::kBallRadius;
constexpr float kBallVolume = 4.0f / 3.0f * kPi * rules::kBallRadius * rules::kBallRadius * rules::kBallRadius;

TEST(SunkShare, IsThatOfACapOfABall) {
  EXPECT_EQ(sunkShare(0.2f, 0.2f), 0.0f);
  EXPECT_EQ(sunkShare(-0.2f, 0.2f), 1.0f);
  for (const float height : {-0.15f, -0.05f, 0.0f, 0.12f}) {
    const float r = 0.2f, deep = r - height;
    const float cap = kPi * deep * deep * (3.0f * r - deep) / 3.0f;
    EXPECT_NEAR(sunkShare(height, r), cap / (4.0f / 3.0f * kPi * r * r * r), 1e-6f) << height;
  }
}

TEST_F(Lake, ABallSinksWithItsTerminalSpeed) {
  const physics::BodyHandle ball = addBall(Vec3(0.0f, -1.0f, 0.0f), Vec3::Zero());
  tick(600);
  const float heavier = rules::kBallDensity - rules::kWaterDensity;
  const float terminal =
      std::sqrt(2.0f * heavier * kBallVolume * rules::kGravity / (rules::kWaterDensity * rules::kBallDrag * kBallArea));
  // A tick's gravity comes after the drag: half of it, 0.08 m/s, is what the tick's length costs.
  EXPECT_NEAR(-world_.body(ball).velocity.y(), terminal, 0.025f * terminal);
}

TEST_F(StillLake, DragIsTheSquareLawsSolutionHoweverLongTheTicks) {
  const physics::BodyHandle ball = addBall(Vec3(0.0f, -3.0f, 0.0f), Vec3(20.0f, 0.0f, 0.0f));
  const float c = 0.5f * rules::kWaterDensity * rules::kBallDrag * kBallArea / world_.body(ball).mass;
  for (const int ticks : {1, 20, 100}) {
    while (world_.tick() < ticks) tick();
    const float t = static_cast<float>(ticks) * rules::kTickSeconds;
    EXPECT_NEAR(world_.body(ball).velocity.x(), 20.0f / (1.0f + c * 20.0f * t), 1e-3f) << ticks;
  }
}

TEST_F(Lake, WhatIsLighterFloatsAsDeepAsItIsHeavy) {
  const physics::BodyHandle cube = addCube(Vec3(0.0f, 1.0f, 0.0f), 0.3f, 0.5f * rules::kFormatWaterDensity);
  tick(1200);
  EXPECT_NEAR(world_.body(cube).center.y(), 0.0f, 0.02f);  // half of it below
  EXPECT_LT(world_.body(cube).velocity.norm(), 0.1f);
}

TEST_F(Lake, GlassAndSteelSink) {
  const physics::BodyHandle cube = addCube(Vec3(0.0f, -1.0f, 0.0f), 0.1f, rules::kDensityUnit);
  tick(120);
  EXPECT_LT(world_.body(cube).velocity.y(), -0.5f);
}

TEST_F(Lake, WhatLiesOnTheGroundComesToRest) {
  physics::BodyDef ground;
  ground.type = physics::BodyType::Static;
  ground.pose.position = Vec3(0.0f, -2.2f, 0.0f);
  world_.addConvex(world_.createBody(ground), {}, geometry::makeBox<float>(Vec3(5.0f, 0.2f, 5.0f)));
  const physics::BodyHandle cube = addCube(Vec3(0.0f, 0.5f, 0.0f), 0.1f, rules::kDensityUnit);
  tick(400);
  EXPECT_FALSE(world_.body(cube).awake);
  EXPECT_NEAR(world_.body(cube).center.y(), -1.9f, 0.02f);
}

TEST_F(Lake, BesideItAllFallsAsEver) {
  lake_[0].halfExtents = Vec2(1.0f, 1.0f);
  const physics::BodyHandle beside = addBall(Vec3(1.5f, -1.0f, 0.0f), Vec3::Zero());
  tick(30);
  EXPECT_NEAR(world_.body(beside).velocity.y(), -rules::kGravity * 30.0f * rules::kTickSeconds, 1e-4f);
}

TEST_F(Lake, AnEntryIsToldOnceAndWhereItIs) {
  const physics::BodyHandle ball = addBall(Vec3(0.5f, 1.0f, -2.0f), Vec3::Zero());
  int entries = 0;
  for (int i = 0; i < 120; ++i) {
    tick();
    for (const Waters::Entry& entry : waters_.entries(world_, lake_, 0.0f)) {
      ++entries;
      EXPECT_EQ(entry.body, ball);
      EXPECT_EQ(entry.point.y(), 0.0f);
      EXPECT_NEAR(entry.point.x(), 0.5f, 1e-4f);
      const float fallen = std::sqrt(2.0f * rules::kGravity * (1.0f - rules::kBallRadius));
      EXPECT_NEAR(-entry.velocity.y(), fallen, 0.25f);  // of the tick before
      EXPECT_NEAR(entry.size, std::cbrt(kBallVolume), 1e-3f);
    }
  }
  EXPECT_EQ(entries, 1);
}

TEST_F(Lake, ManyEntriesOfATickAreBounded) {
  for (int i = 0; i < 40; ++i) addBall(Vec3(0.4f * static_cast<float>(i), 0.2f, 0.0f), Vec3(0.0f, -9.0f, 0.0f));
  tick();
  EXPECT_EQ(waters_.entries(world_, lake_, 0.0f).size(), rules::kMaxSplashes);
  EXPECT_EQ(waters_.refused(), 40u - rules::kMaxSplashes);
}

TEST_F(Lake, KeepsItsMemoryFromTickToTick) {
  addBall(Vec3(0.0f, 0.1f, 0.0f), Vec3(0.0f, -3.0f, 0.0f));
  tick();
  const auto* const first = waters_.entries(world_, lake_, 0.0f).data();
  for (int i = 0; i < 20; ++i) tick();
  EXPECT_EQ(waters_.entries(world_, lake_, 0.0f).data(), first);
}

const char* const kPool = "<water pos=\"0 -0.5 -8\" size=\"4 8\" resolution=\"16 24\"/>";

TEST(WaterOfARoom, IsDemandedByFileAndLineAndShown) {
  const std::unique_ptr<Game> game = newTestGame(oneRoom(kPool));
  ASSERT_EQ(game->effects().count(effects::Effect::Water), 1u);
  for (const effects::Demand& demand : game->effects().demands())
    if (demand.effect == effects::Effect::Water) {
      EXPECT_EQ(demand.who, "segments/test/corridor.xml:1");
    }
  FramePacket packet;
  game->copyFrame(packet);
  ASSERT_EQ(packet.rooms[0].waters.size(), 1u);
  EXPECT_EQ(packet.rooms[0].waters[0].center, Vec3(0.0f, -0.5f, -8.0f));
  EXPECT_EQ(packet.rooms[0].waters[0].cells, (std::array<int, 2>{16, 24}));
  EXPECT_THAT(game->problems(), ::testing::IsEmpty());
}

TEST(WaterOfARoom, IsSplashedByABallThrownIntoIt) {
  const std::unique_ptr<Game> game = newTestGame(oneRoom(kPool));
  game->tick(throwAt(0.0f, -0.4f));
  std::vector<Event> splashes;
  for (int i = 0; i < 60; ++i) {
    game->tick({});
    for (const Event& event : game->events())
      if (event.type == EventType::Splash) splashes.push_back(event);
  }
  ASSERT_EQ(splashes.size(), 1u);
  EXPECT_EQ(splashes[0].value, 1);
  EXPECT_EQ(splashes[0].point.y(), -0.5f);
  EXPECT_GT(splashes[0].speed, 15.0f);
}

TEST(WaterOfARoom, StaysWhereItIsWhenTheOriginMoves) {
  content::MemorySource source =
      oneRoom("", 400.0f, "for i = 0, 3 do mgSegment('test/corridor', -32 * i) end mgSegment('test/pool', -72)");
  source.add("segments/test/pool.xml", "<segment size=\"12 10 16\"><water pos=\"0 -0.5 -8\" size=\"4 8\"/></segment>");
  const std::unique_ptr<Game> game = newTestGame(source);
  while (game->roomDistance() < 70.0f) game->tick({});
  FramePacket packet;
  game->copyFrame(packet);
  ASSERT_EQ(packet.rooms[0].waters.size(), 1u);
  const float ahead = packet.camera.position.z() - packet.rooms[0].waters[0].center.z();
  EXPECT_NEAR(ahead, 80.0f - game->roomDistance(), 1e-3f);
  game->tick(throwAt(0.0f, -0.3f));
  EXPECT_EQ(play(*game, 60)[EventType::Splash], 1);
}

TEST(WaterOfARoom, HasOnlySoMany) {
  std::string many;
  for (std::uint32_t i = 0; i <= rules::kMaxWatersPerRoom; ++i) many += kPool;
  const std::unique_ptr<Game> game = newTestGame(oneRoom(many));
  EXPECT_EQ(game->effects().count(effects::Effect::Water), rules::kMaxWatersPerRoom);
  ASSERT_EQ(game->problems().size(), 1u);
  EXPECT_EQ(game->problems()[0].text,
            "segments/test/corridor.xml:1: more than 64 waters in a room: the rest is left out");
}

}  // namespace
}  // namespace brittle::sim
