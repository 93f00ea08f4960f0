// Lasers, and effects that are only seen: what demands them, and what they change.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/game/sim/fixture.h"

namespace brittle::sim {
namespace {

using effects::Effect;

/// A room with one obstacle of this script, 8 m ahead at the height of the camera.
content::MemorySource scripted(const std::string& script, const std::string& elements = "") {
  content::MemorySource source = oneRoom("<obstacle pos=\"0 1 -8\" type=\"probe\"/>" + elements);
  source.add("obstacles/probe.lua", script);
  return source;
}

const char* const kBeam = "function init() end\nfunction tick()\n\tmgLaser(-2, 0.5, 0, 1, 0, 0)\nend\n";

RoomView roomOf(const Game& game) {
  FramePacket packet;
  game.copyFrame(packet);
  return packet.rooms[0];
}

TEST(Lasers, EndWhereARayMeetsSomething) {
  const std::unique_ptr<Game> game = newTestGame(scripted(kBeam));
  play(*game, 1);
  const RoomView room = roomOf(*game);
  ASSERT_EQ(room.beams.size(), 1u);
  EXPECT_TRUE(room.beams[0].hits);
  EXPECT_NEAR(room.beams[0].from.x(), -2.0f, 1e-5f);
  EXPECT_NEAR(room.beams[0].to.x(), 4.0f, 1e-4f) << "the wall";
  EXPECT_NEAR(room.beams[0].to.y(), 1.5f, 1e-4f);
}

TEST(Lasers, ReachSoFarAndNoFarther) {
  const std::unique_ptr<Game> game =
      newTestGame(scripted("function init() end function tick() mgLaser(0, 1, 0, 0, 0, -1) end"));
  play(*game, 1);
  const RoomView room = roomOf(*game);
  ASSERT_EQ(room.beams.size(), 1u);
  EXPECT_FALSE(room.beams[0].hits);
  EXPECT_NEAR((room.beams[0].to - room.beams[0].from).norm(), rules::kLaserReach, 1e-3f);
}

TEST(Lasers, AreDemandedOnceByTheLineThatAsksFirst) {
  const std::unique_ptr<Game> game = newTestGame(scripted(kBeam));
  play(*game, 30);
  EXPECT_EQ(game->effects().count(Effect::Lasers), 1u);
  for (const effects::Demand& demand : game->effects().demands())
    if (demand.effect == Effect::Lasers) {
      EXPECT_EQ(demand.who, "obstacles/probe.lua:3");
    }
}

TEST(Lasers, AreNotWhereNobodyWantsThem) {
  const content::MemorySource source = scripted(kBeam);
  GameDef def;
  def.level = "test";
  def.without = effects::EffectMask().with(Effect::Lasers);
  const std::unique_ptr<Game> game = newGame(source, def);
  play(*game, 3);
  EXPECT_TRUE(game->effects().has(Effect::Lasers));
  EXPECT_THAT(roomOf(*game).beams, ::testing::IsEmpty());
}

TEST(ShippedLaser, BurnsUntilItsEmitterIsBroken) {
  content::MemorySource source = oneRoom("<obstacle pos=\"0 1 -8\" type=\"laser\" param1=\"raycast=true\"/>");
  const Result<std::string> text = shippedAssets().read("obstacles/laser.lua");
  ASSERT_TRUE(text) << text.error().message;
  source.add("obstacles/laser.lua", *text);
  const std::unique_ptr<Game> game = newTestGame(source);
  play(*game, 2);
  EXPECT_EQ(roomOf(*game).beams.size(), 5u);
  const std::unique_ptr<Game> other = newTestGame(source);
  EXPECT_GE(play(*other, 130)[EventType::Crash], 1) << "whoever does nothing is burnt";
  game->tick(throwAt(-3.77f / 8.0f, 0.0f));
  std::map<EventType, int> seen = play(*game, 127);
  EXPECT_EQ(seen[EventType::Cleared], 1);
  EXPECT_EQ(seen[EventType::Crash], 0);
  EXPECT_THAT(roomOf(*game).beams, ::testing::IsEmpty());
  EXPECT_THAT(game->problems(), ::testing::IsEmpty());
}

TEST(SeenEffects, AreDemandedByTheirCalls) {
  const auto who = [](const Game& game, Effect effect) {
    for (const effects::Demand& demand : game.effects().demands())
      if (demand.effect == effect) return demand.who;
    return std::string();
  };
  const std::unique_ptr<Game> room = newTestGame(
      oneRoom("", 160.0f, "mgSegment('test/corridor', 0) mgDepthOfField(6, 8, 0.5) mgSetRotation(1) mgLength(160)"));
  EXPECT_EQ(who(*room, Effect::DepthOfField), "rooms/test/room.lua:1");
  EXPECT_EQ(who(*room, Effect::CameraRoll), "rooms/test/room.lua:1");
  EXPECT_THAT(roomOf(*room).focus, ::testing::ElementsAre(6.0f, 8.0f, 0.5f));
  const std::unique_ptr<Game> smoky =
      newTestGame(scripted("function init() end\nfunction tick() mgSmoke(0, 0, 0, 0, 1, 0) end"));
  play(*smoky, 2);
  EXPECT_EQ(who(*smoky, Effect::Smoke), "obstacles/probe.lua:2");
  EXPECT_EQ(smoky->effects().count(Effect::Smoke), 1u);
  const std::unique_ptr<Game> pane = newTestGame(oneRoom("<obstacle pos=\"0 1 -12\" type=\"framedwindow\"/>"));
  play(*pane, 2);
  EXPECT_EQ(who(*pane, Effect::Splinters).find("obstacles/framedwindow.lua:"), 0u);
  const std::unique_ptr<Game> plain = newTestGame(oneRoom(""));
  play(*plain, 2);
  for (const Effect effect :
       {Effect::DepthOfField, Effect::CameraRoll, Effect::Smoke, Effect::Splinters, Effect::Lasers, Effect::Water})
    EXPECT_FALSE(plain->effects().has(effect)) << effects::nameOf(effect);
}

TEST(SeenEffects, DepthOfFieldSaysWhatIsBeyondItsRange) {
  const std::unique_ptr<Game> room =
      newTestGame(oneRoom("", 160.0f, "mgSegment('test/corridor', 0) mgDepthOfField(6, 0) mgLength(160)"));
  ASSERT_EQ(room->problems().size(), 1u);
  EXPECT_EQ(room->problems()[0].text, "rooms/test/room.lua:1: mgDepthOfField: argument 2 is 0, expected 0.1 to 100");
}

TEST(SeenEffects, SwitchedOffTheyLeaveTheGameAsItIs) {
  const content::MemorySource source = scripted("function init() end function tick() mgSmoke(0, 0, 0, 0, 1, 0) end",
                                                "<obstacle pos=\"0 1 -14\" type=\"framedwindow\"/>");
  GameDef def;
  def.level = "test";
  const std::unique_ptr<Game> with = newGame(source, def);
  def.without = effects::maskOf(effects::Kind::Seen);
  const std::unique_ptr<Game> without = newGame(source, def);
  for (int i = 0; i < 120; ++i) {
    const replay::InputFrame input = i == 20 ? throwAt(0.0f, 0.0f) : replay::InputFrame{};
    with->tick(input);
    without->tick(input);
    ASSERT_EQ(with->stateHash(), without->stateHash()) << "tick " << i;
  }
  EXPECT_GE(with->totalBreaks(), 1u);
}

}  // namespace
}  // namespace brittle::sim
