// Which effects a room calls for, and that each names who asked.
#include <gtest/gtest.h>

#include "tests/game/sim/fixture.h"

namespace brittle::sim {
namespace {

std::string whoDemands(const Game& game, effects::Effect effect) {
  for (const effects::Demand& demand : game.effects().demands())
    if (demand.effect == effect) return demand.who;
  return "";
}

TEST(Demands, GlassDemandsFractureAndWhatItLeaves) {
  const std::unique_ptr<Game> game =
      newTestGame(oneRoom("<obstacle pos=\"0 1 -12\" type=\"suspendwindow\" param0=\"width=3\"/>"));
  play(*game, 2);
  for (const effects::Effect effect : {effects::Effect::Fracture, effects::Effect::Debris, effects::Effect::Joints})
    EXPECT_EQ(whoDemands(*game, effect).find("obstacles/suspendwindow.lua:"), 0u) << nameOf(effect);
  EXPECT_EQ(game->effects().count(effects::Effect::Fracture), 1u) << "one pane";
}

TEST(Demands, ARoomWithoutGlassDemandsNoFracture) {
  const std::unique_ptr<Game> game = newTestGame(oneRoom(""));
  play(*game, 2);
  EXPECT_FALSE(game->effects().has(effects::Effect::Fracture));
  EXPECT_FALSE(game->effects().has(effects::Effect::Debris));
  EXPECT_TRUE(game->effects().has(effects::Effect::Fog));
}

TEST(Demands, ARoomDemandsNothingForTheOthers) {
  content::MemorySource source = oneRoom("");
  source.add("levels/test.xml", "<level><room type=\"test/room\"/><room type=\"test/cave\"/></level>");
  source.add("rooms/test/cave.lua", "function init() mgSegment(\"test/corridor\", 0) mgEcho(0.3, 0.25, 0.5, 0.1) end");
  GameDef def;
  def.level = "test";
  EXPECT_EQ(whoDemands(*newGame(source, def), effects::Effect::Echo), "");
  def.firstRoom = 1;
  EXPECT_EQ(whoDemands(*newGame(source, def), effects::Effect::Echo), "rooms/test/cave.lua:1");
}

TEST(Demands, FogIsItsCallsOrTheGames) {
  EXPECT_EQ(whoDemands(*newTestGame(oneRoom("")), effects::Effect::Fog), "by the game: every room has fog");
  const auto misty = newTestGame(oneRoom("", 0.0f, "mgSegment('test/corridor', 0)\nmgFogColor(0.1, 0.2, 0.3)"));
  EXPECT_EQ(whoDemands(*misty, effects::Effect::Fog), "rooms/test/room.lua:2");
  EXPECT_EQ(misty->effects().count(effects::Effect::Fog), 1u);
}

/// Whether it leads to a line of a file that is there, or to a rule of the game's own.
bool saysWho(const std::string& who) {
  if (who.find("by the game: ") == 0) return true;
  const std::size_t colon = who.find(':');
  return colon != std::string::npos && std::atoi(who.c_str() + colon + 1) > 0 &&
         shippedAssets().has(who.substr(0, colon));
}

TEST(Demands, EveryOneOfTheShippedRoomsNamesItsFileAndLineOrTheGame) {
  for (const char* level : {"first", "showroom"}) {
    GameDef def;
    def.level = level;
    for (Result<std::unique_ptr<Game>> game = Game::create(shippedAssets(), def); game;
         ++def.firstRoom, game = Game::create(shippedAssets(), def)) {
      for (int i = 0; i < 300; ++i) (*game)->tick(scriptedInput((*game)->tickCount()));
      for (const effects::Demand& demand : (*game)->effects().demands())
        EXPECT_TRUE(saysWho(demand.who)) << level << " " << def.firstRoom << ": " << nameOf(demand.effect) << " "
                                         << demand.who;
    }
  }
}

}  // namespace
}  // namespace brittle::sim
