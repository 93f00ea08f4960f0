// What the simulation tells of its sounds: who met whom, and the numbers of the rooms' acoustics.
#include <gtest/gtest.h>

#include "tests/game/sim/fixture.h"

namespace brittle::sim {
namespace {

TEST(SoundEvents, AHitNamesBothAndTheSizeOfTheStriker) {
  const content::MemorySource source =
      oneRoom("<obstacle pos=\"0 1 -12\" type=\"suspendwindow\" param0=\"width=3\" param1=\"height=2\"/>");
  const std::unique_ptr<Game> game = newTestGame(source);
  bool ballOnRoom = false, shardOnRoom = false;
  for (int tick = 0; tick < 300; ++tick) {
    game->tick(tick == 10 ? throwAt(0.0f, 0.0f) : replay::InputFrame{});
    for (const Event& event : game->events()) {
      if (event.type != EventType::Hit) continue;
      EXPECT_EQ(event.striker == Look::Ball, event.value == 1);
      EXPECT_NE(event.look, Look::Ball) << "one ball was thrown";
      if (event.striker == Look::Ball && event.look == Look::Static) {
        ballOnRoom = true;
        EXPECT_EQ(event.size, 0.0f);
      }
      if (event.striker == Look::Glass && event.look == Look::Static) {
        shardOnRoom = true;
        EXPECT_GT(event.size, 0.01f);
        EXPECT_LT(event.size, 0.6f);
      }
    }
  }
  EXPECT_TRUE(ballOnRoom);
  EXPECT_TRUE(shardOnRoom);
}

std::string problemsOf(const Game& game) {
  std::string all;
  for (const Problem& problem : game.problems()) all += problem.text + "\n";
  return all;
}

TEST(SoundEvents, ARoomsAcousticsAndWhoAskedForThem) {
  const content::MemorySource source =
      oneRoom("", 160.0f, "mgSegment('test/corridor', 0) mgReverb(0.4, 0.9, 0.2) mgEcho(0.3, 0.25, 0.5, 0.1)");
  const std::unique_ptr<Game> game = newTestGame(source);
  FramePacket packet;
  game->copyFrame(packet);
  EXPECT_FLOAT_EQ(packet.rooms.front().reverb[1], 0.9f);
  EXPECT_FLOAT_EQ(packet.rooms.front().echo[3], 0.1f);
  EXPECT_TRUE(game->effects().has(effects::Effect::Reverb));
  EXPECT_TRUE(game->effects().has(effects::Effect::Echo));
  EXPECT_FALSE(game->effects().has(effects::Effect::LowPass));
  bool named = false;
  for (const effects::Demand& demand : game->effects().demands())
    named = named || (demand.effect == effects::Effect::Reverb && demand.who.find("rooms/test/room.lua:1") == 0);
  EXPECT_TRUE(named);
  EXPECT_EQ(problemsOf(*game), "");
}

TEST(SoundEvents, AVolumeOfZeroDemandsNothing) {
  const content::MemorySource source =
      oneRoom("", 160.0f, "mgSegment('test/corridor', 0) mgReverb(0, 1, 0) mgEcho(0, 1, 0, 0) mgLowPass(0)");
  const std::unique_ptr<Game> game = newTestGame(source);
  for (const effects::Effect effect : {effects::Effect::Reverb, effects::Effect::Echo, effects::Effect::LowPass})
    EXPECT_FALSE(game->effects().has(effect));
}

TEST(SoundEvents, NumbersBeyondTheirRangeAreLimitedAndReported) {
  const content::MemorySource source =
      oneRoom("", 160.0f, "mgSegment('test/corridor', 0) mgReverb(0.5, 1e9, -3) mgEcho(0.5, 0.2, 7, 0) mgLowPass(2)");
  const std::unique_ptr<Game> game = newTestGame(source);
  FramePacket packet;
  game->copyFrame(packet);
  EXPECT_EQ(packet.rooms.front().reverb[1], 10.0f);
  EXPECT_EQ(packet.rooms.front().reverb[2], 0.0f);
  EXPECT_EQ(packet.rooms.front().echo[2], 0.95f);
  EXPECT_EQ(packet.rooms.front().lowPass, 1.0f);
  const std::string problems = problemsOf(*game);
  for (const char* line :
       {"rooms/test/room.lua:1: mgReverb: argument 2 is 1e+09, expected 0 to 10", "argument 3 is -3, expected 0 to 1",
        "argument 3 is 7, expected 0 to 0.95", "argument 1 is 2, expected 0 to 1"})
    EXPECT_NE(problems.find(line), std::string::npos) << problems;
}

TEST(SoundEvents, NotANumberIsRefusedInOneLine) {
  const content::MemorySource source = oneRoom("", 160.0f, "mgSegment('test/corridor', 0) mgReverb(0/0, 1, 0)");
  const std::unique_ptr<Game> game = newTestGame(source);
  FramePacket packet;
  game->copyFrame(packet);
  EXPECT_EQ(packet.rooms.front().reverb[0], 0.0f);
  EXPECT_EQ(game->problems().size(), 1u) << problemsOf(*game);
  EXPECT_FALSE(packet.rooms.front().segments.empty()) << "what came before the fault stays";
}

}  // namespace
}  // namespace brittle::sim
