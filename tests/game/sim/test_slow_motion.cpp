#include "game/sim/slow_motion.h"

#include <gtest/gtest.h>

#include "tests/game/sim/power_up_games.h"

namespace brittle::sim {
namespace {

/// Slow for `slow` ticks, then on until the clock is at its full speed; how many ticks in all.
std::uint64_t bend(Clock& clock, int slow) {
  std::uint64_t ticks = 0;
  for (; static_cast<int>(ticks) < slow; ++ticks) passTime(clock, ticks, true);
  for (; clock.share < kWholeTick; ++ticks) passTime(clock, ticks, false);
  return ticks;
}

// Down and up again, 192 of 256 in steps of 6, take 64 ticks and 40 of the game's; in between a quarter passes.
TEST(SlowMotion, TimePassedIsTheSumOfItsParts) {
  Clock clock;
  const std::uint64_t ticks = bend(clock, rules::kSlowTicks);
  EXPECT_EQ(ticks, static_cast<std::uint64_t>(rules::kSlowTicks) + 32u);
  EXPECT_EQ(clock.after(ticks), kWholeTick * (40 + (rules::kSlowTicks - 32) / 4));
}

TEST(SlowMotion, WholeTicksEndAsOftenAsTheySumUpTo) {
  Clock clock;
  std::int32_t sum = 0, whole = 0;
  float seconds = 0.0f;
  for (std::uint64_t tick = 0; tick < 300; ++tick) {
    const TimeStep step = passTime(clock, tick, tick < 150);
    EXPECT_EQ(step.part, sum % kWholeTick) << tick;
    sum += step.share;
    whole += step.isWhole() ? 1 : 0;
    seconds += step.seconds();
    ASSERT_GE(step.seconds(), 1.0f / 1000.0f);
  }
  EXPECT_EQ(whole, sum / kWholeTick);
  EXPECT_NEAR(seconds, static_cast<float>(sum) / kWholeTick / 60.0f, 1e-4f);
}

TEST(SlowMotion, AWholeTickIsATickToTheBit) {
  EXPECT_EQ(TimeStep{}.seconds(), rules::kTickSeconds);
  EXPECT_TRUE(TimeStep{}.isWhole());
  EXPECT_EQ(TimeStep{}.partAfter(), 0);
}

// The camera's way is a function of the game's time: where an undisturbed game is after as much of it.
TEST(SlowMotion, TheWayIsThatOfTheTimePassed) {
  const content::MemorySource source = oneRoom(pickupAt("slowmotion"));
  const auto slow = newTestGame(source), plain = newTestGame(source);
  ASSERT_TRUE(collectAndUse(*slow));
  play(*slow, 650);
  FramePacket packet;
  slow->copyFrame(packet);
  ASSERT_EQ(packet.timeShare, 1.0f) << "it is over";
  const auto passed = static_cast<std::uint64_t>(packet.time);
  EXPECT_EQ(static_cast<double>(passed), packet.time) << "whole ticks";
  EXPECT_EQ(slow->tickCount() - passed, 512u - 152u);
  while (plain->tickCount() < passed) plain->tick({});
  EXPECT_EQ(slow->roomDistance(), plain->roomDistance());
}

TEST(SlowMotion, ThingsMoveSlowerAndSpeedsAreThoseOfTheGamesTime) {
  const content::MemorySource source = oneRoom(pickupAt("slowmotion"));
  const auto game = newTestGame(source);
  const float usual = game->camera().velocity.norm();
  ASSERT_TRUE(collectAndUse(*game));
  play(*game, 60);
  const float before = game->roomDistance();
  play(*game, 60);
  EXPECT_NEAR(game->roomDistance() - before, 0.25f * usual, 1e-3f) << "a quarter of a second's way in a second";
  EXPECT_NEAR(game->camera().velocity.norm(), usual, 1e-3f);
  EXPECT_FLOAT_EQ(game->timeShare(), 0.25f);
}

// mgTime, mgObstacleTime and beats are what scripts move things by: all of them go by the game's time.
TEST(SlowMotion, ScriptsSeeTheGamesTime) {
  content::MemorySource source = oneRoom(pickupAt("slowmotion") + "<obstacle pos=\"0 3 -20\" type=\"clock\"/>");
  source.add("obstacles/clock.lua", R"(
    function init() hand = mgCreateBody(0, 0, 0) mgMaterial("steel") mgStatic(2) mgCreateBox(hand, 0.1, 0.1, 0.1) end
    function tick() mgMove(hand, mgObstacleTime(), mgTime(), mgGetBeat(1)) end)");
  const auto game = newTestGame(source);
  ASSERT_TRUE(collectAndUse(*game));
  play(*game, 100);
  const auto handOf = [&game] {
    Vec3 place = Vec3::Zero();
    game->world(0)->forEachBody([&place](physics::BodyHandle, const physics::Body& body) {
      if (body.type == physics::BodyType::Animated) place = body.pose.position;
    });
    return place;
  };
  const Vec3 before = handOf();
  play(*game, 60);
  const Vec3 moved = handOf() - before;
  EXPECT_NEAR(moved.x(), 0.25f, 2e-3f) << "of a second, the obstacle's";
  EXPECT_NEAR(moved.y(), 0.25f, 2e-3f) << "the room's";
  EXPECT_NEAR(moved.z(), 0.5f, 0.2f) << "half a beat, eased";
}

TEST(SlowMotion, ARoomsMusicGoesByTheSameTime) {
  const content::MemorySource source = oneRoom(pickupAt("slowmotion"));
  const auto game = newTestGame(source);
  ASSERT_TRUE(collectAndUse(*game));
  FramePacket packet;
  std::int32_t last = -1;
  for (int i = 0; i < 700; ++i) {
    game->tick({});
    game->copyFrame(packet);
    ASSERT_LE(packet.rooms[0].ticks - last, i == 0 ? 1000 : 1) << "no tick of the music is left out";
    last = packet.rooms[0].ticks;
  }
  EXPECT_EQ(last, static_cast<std::int32_t>(packet.time));
}

}  // namespace
}  // namespace brittle::sim
