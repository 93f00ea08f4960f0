// Power-ups in a game: collected, held, used, what they do, and that none of it is seen where there are none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "engine/core/random.h"
#include "tests/game/sim/power_up_games.h"

namespace brittle::sim {
namespace {

// Beside the way of the ball that collects.
const std::string kPanes =
    "<obstacle pos=\"2.4 1 -16\" type=\"framedwindow\" param0=\"width=3\" param1=\"height=2\"/>"
    "<obstacle pos=\"2.4 1 -17\" type=\"framedwindow\" param0=\"width=3\" param1=\"height=2\"/>";

replay::InputFrame throwAtPanes(const Game& game) {
  return throwAt(2.4f / (16.0f - game.roomDistance()), 0.0f);
}

TEST(PowerUps, ABallThatHitsOneCollectsItAndFliesOn) {
  const content::MemorySource source = oneRoom(pickupAt("nitroballs"));
  const auto game = newTestGame(source), empty = newTestGame(oneRoom(""));
  ASSERT_TRUE(collect(*game));
  ASSERT_EQ(game->hud().powerUps.size(), 1u);
  EXPECT_EQ(game->hud().powerUps[0].kind, PowerUp::NitroBalls);
  EXPECT_EQ(game->hud().powerUps[0].count, 1);
  EXPECT_EQ(play(*game, 100)[EventType::PowerUpCollected], 0) << "once";
}

TEST(PowerUps, ABallThatPassesByCollectsNothing) {
  const auto game = newTestGame(oneRoom(pickupAt("nitroballs", "1.2 1 -6")));
  EXPECT_FALSE(collect(*game));
}

TEST(PowerUps, OneStandsInNobodysWay) {
  const auto game = newTestGame(oneRoom(pickupAt("barrel", "0 1 -8")));
  play(*game, 200);
  EXPECT_EQ(game->totalCrashes(), 0u);
  FramePacket packet;
  game->copyFrame(packet);
  EXPECT_TRUE(packet.rooms[0].pickups.empty()) << "it was left behind";
}

TEST(PowerUps, ScriptsPlaceThemToo) {
  const auto game =
      newTestGame(oneRoom("", 160.0f, "mgSegment('test/corridor', 0) mgLength(160) mgPowerUp('barrel', 0, 1, -6)"));
  EXPECT_TRUE(collect(*game));
  EXPECT_EQ(game->hud().powerUps[0].kind, PowerUp::Barrel);
}

TEST(PowerUps, EachDemandsItsEffectByFileAndLine) {
  const auto whoAsks = [](const Game& game, effects::Effect effect) {
    std::vector<std::string> who;
    for (const effects::Demand& demand : game.effects().demands())
      if (demand.effect == effect) who.push_back(demand.who);
    return who;
  };
  const auto game = newTestGame(oneRoom("\n" + pickupAt("barrel") + "\n" + pickupAt("slowmotion")));
  EXPECT_THAT(whoAsks(*game, effects::Effect::Explosions), ::testing::ElementsAre("segments/test/corridor.xml:2"));
  EXPECT_THAT(whoAsks(*game, effects::Effect::SlowMotion), ::testing::ElementsAre("segments/test/corridor.xml:3"));
  const auto frenzy = newTestGame(oneRoom(pickupAt("ballfrenzy")));
  EXPECT_TRUE(whoAsks(*frenzy, effects::Effect::Explosions).empty());
  EXPECT_TRUE(whoAsks(*frenzy, effects::Effect::SlowMotion).empty());
}

TEST(PowerUps, WhoDoesWithoutTheEffectIsNotOfferedIt) {
  const content::MemorySource source = oneRoom(pickupAt("barrel"));
  GameDef def;
  def.level = "test";
  def.without = effects::EffectMask().with(effects::Effect::Explosions);
  EXPECT_FALSE(collect(*newGame(source, def)));
}

// A throw in each tick from the one in which it is used on: those in its time are free, and no other.
TEST(PowerUps, ThrowsAreFreeForExactlyItsTicks) {
  const content::MemorySource source = oneRoom(pickupAt("ballfrenzy"), 40.0f);
  GameDef def;
  def.level = "test";
  def.balls = 100;
  const auto game = newGame(source, def);
  ASSERT_TRUE(collect(*game));
  EXPECT_EQ(game->hud().balls, 99);
  int thrown = 0;
  for (int tick = 0; tick < rules::kFrenzyTicks + 40; ++tick) {
    replay::InputFrame input;
    if (tick == 0) input = usePlace(0);
    const bool throws = tick % 10 == 9;  // 40 ticks after its end: four that cost
    if (throws) input.throws.push_back(replay::quantizeAim(0.6f, 0.3f));
    thrown += throws ? 1 : 0;
    game->tick(input);
  }
  EXPECT_EQ(thrown, rules::kFrenzyTicks / 10 + 4);
  EXPECT_EQ(game->hud().balls, 99 - 4);
}

TEST(PowerUps, WhoHasNoBallLeftPlaysOnWhileThrowsAreFree) {
  const content::MemorySource source = oneRoom(pickupAt("ballfrenzy"));
  GameDef def;
  def.level = "test";
  def.balls = 1;
  const auto game = newGame(source, def);
  ASSERT_TRUE(collectAndUse(*game));
  play(*game, rules::kFrenzyTicks - 10);
  EXPECT_EQ(game->hud().balls, 0);
  EXPECT_FALSE(game->isOver());
  EXPECT_EQ(play(*game, rules::kLastBallTicks + 20)[EventType::GameOver], 1);
}

TEST(PowerUps, NitroBallsExplodeAtTheirFirstTouch) {
  for (const bool isNitro : {false, true}) {
    const content::MemorySource source = oneRoom(pickupAt("nitroballs") + kPanes);
    const auto game = newTestGame(source);
    ASSERT_TRUE(isNitro ? collectAndUse(*game) : collect(*game));
    play(*game, 60);
    ASSERT_EQ(game->totalBreaks(), 0u);
    game->tick(throwAtPanes(*game));
    const auto events = play(*game, 60);
    EXPECT_EQ(events.count(EventType::Explosion) > 0 ? events.at(EventType::Explosion) : 0, isNitro ? 1 : 0);
    EXPECT_GE(game->totalBreaks(), 2u);
    FramePacket packet;
    game->copyFrame(packet);
    EXPECT_EQ(packet.balls.size(), isNitro ? 1u : 2u) << "the one that collected; the other is gone if it exploded";
  }
}

TEST(PowerUps, ABarrelGoesWithOneBallOfTheNextThrowAndReachesFarther) {
  const content::MemorySource source = oneRoom(pickupAt("barrel") + kPanes);
  const auto game = newTestGame(source);
  ASSERT_TRUE(collectAndUse(*game));
  play(*game, 60);
  EXPECT_TRUE(game->hud().powerUps[0].runs) << "it waits";
  game->tick(throwAtPanes(*game));
  EXPECT_TRUE(game->hud().powerUps.empty());
  int explosions = 0, broken = 0;
  for (int i = 0; i < 60; ++i) {
    game->tick({});
    for (const Event& event : game->events()) {
      if (event.type != EventType::Explosion) continue;
      ++explosions;
      broken = event.value;
      EXPECT_FLOAT_EQ(event.size, rules::kBarrelBlast.pushReach);
      EXPECT_GT(event.impulse, 0.0f);
    }
  }
  EXPECT_EQ(explosions, 1);
  EXPECT_GE(broken, 2) << "what is left of the pane it met, and the one behind it";
}

TEST(PowerUps, WhatWasCollectedGoesAlongIntoTheNextRoom) {
  content::MemorySource source = oneRoom(pickupAt("nitroballs"), 32.0f);
  source.add("levels/test.xml", "<level><room type=\"test/room\"/><room type=\"test/glass\"/></level>");
  source.add("rooms/test/glass.lua",
             "function init() mgSegment('test/corridor', 0) mgLength(32) "
             "mgObstacle('framedwindow', 0, 1, -20, 'width=3', 'height=2') end");
  const auto game = newTestGame(source);
  ASSERT_TRUE(collect(*game));
  while (game->roomNumber() == 0) game->tick({});
  ASSERT_EQ(game->hud().powerUps.size(), 1u);
  game->tick(usePlace(0));
  EXPECT_TRUE(game->effects().has(effects::Effect::Explosions));
  int explosions = 0;
  for (int i = 0; i < 200; ++i) {
    game->tick(i % 20 == 0 ? throwAt(0.0f, -0.05f) : replay::InputFrame{});
    for (const Event& event : game->events()) explosions += event.type == EventType::Explosion ? 1 : 0;
  }
  EXPECT_GT(explosions, 2);
}

TEST(PowerUps, TheNextGameBeginsWithoutAny) {
  const auto game = newTestGame(oneRoom(pickupAt("barrel")));
  ASSERT_TRUE(collect(*game));
  EXPECT_TRUE(newTestGame(oneRoom(pickupAt("barrel")))->hud().powerUps.empty());
}

/// A player who collects, uses and throws all the time.
replay::InputFrame busyInput(std::uint64_t tick) {
  replay::InputFrame frame = tick % 40 == 0 ? throwAt(0.0f, 0.0f) : scriptedInput(tick);
  if (tick % 60 == 50) frame.buttons = replay::useBit(static_cast<int>(tick / 60 % 4));
  return frame;
}

TEST(PowerUps, AGameWithEachIsTheSameFromEverySnapshot) {
  for (const char* type : {"ballfrenzy", "slowmotion", "nitroballs", "barrel"}) {
    const content::MemorySource source = oneRoom(pickupAt(type) + pickupAt(type, "0 1 -12") + kPanes);
    const auto game = newTestGame(source), again = newTestGame(source);
    for (std::uint64_t tick = 0; tick < 400; ++tick) {
      game->tick(busyInput(tick));
      again->tick(busyInput(tick));
      ASSERT_EQ(game->stateHash(), again->stateHash()) << type << " " << tick;
      if (tick % 37 != 5) continue;
      ByteWriter out;
      game->save(out);
      const auto restored = newTestGame(source);
      ByteReader in(out.bytes());
      ASSERT_TRUE(restored->restore(in)) << type << " " << tick;
      EXPECT_EQ(in.remaining(), 0u);
      ASSERT_EQ(restored->stateHash(), game->stateHash()) << type << " " << tick;
      const auto other = newTestGame(source);
      ByteReader twice(out.bytes());
      ASSERT_TRUE(other->restore(twice));
      for (std::uint64_t later = tick + 1; later < tick + 30; ++later) {
        restored->tick(busyInput(later));
        other->tick(busyInput(later));
        ASSERT_EQ(restored->stateHash(), other->stateHash());
      }
      for (std::size_t cut : {std::size_t{30}, out.bytes().size() / 3, out.bytes().size() - 1}) {
        ByteReader part(std::span(out.bytes()).first(cut));
        EXPECT_FALSE(newTestGame(source)->restore(part)) << type << " " << cut;
      }
    }
  }
}

// What neither checksum nor hash refuses: refused, or a game that goes on.
TEST(PowerUps, AForgedSnapshotIsRefusedOrPlays) {
  const content::MemorySource source = oneRoom(pickupAt("nitroballs") + pickupAt("barrel", "0.5 1 -12") + kPanes);
  const auto game = newTestGame(source);
  ASSERT_TRUE(collectAndUse(*game));
  game->tick(throwAt(0.3f, 0.0f));
  ByteWriter out;
  game->save(out);
  constexpr std::uint32_t numbers[] = {0, 1, 3, 300, 0x7fffffff, 0x80000000, 0xffffffff};
  Random random(17);
  int refused = 0;
  for (int i = 0; i < 150; ++i) {
    std::vector<unsigned char> bytes = out.bytes();
    const std::uint32_t end = random.nextBelow(2) == 0 ? 900 : static_cast<std::uint32_t>(bytes.size()) - 4;
    std::memcpy(&bytes[random.nextBelow(end)], &numbers[random.nextBelow(7)], 4);
    const auto other = newTestGame(source);
    ByteReader in(bytes);
    if (!other->restore(in)) {
      ++refused;
      continue;
    }
    for (int tick = 0; tick < 40; ++tick, other->stateHash()) other->tick(busyInput(static_cast<std::uint64_t>(tick)));
  }
  EXPECT_GT(refused, 20);
}

TEST(PowerUps, ButtonsOfARecordingWithoutAnyChangeNothing) {
  const content::MemorySource source = oneRoom(kPanes);
  const auto a = newTestGame(source), b = newTestGame(source);
  for (std::uint64_t tick = 0; tick < 200; ++tick) {
    replay::InputFrame input = scriptedInput(tick);
    a->tick(input);
    input.buttons = replay::useBit(static_cast<int>(tick % 4));
    b->tick(input);
    ASSERT_EQ(a->stateHash(), b->stateHash());
  }
}

TEST(PowerUps, PlayersSeeThem) {
  const auto game = newTestGame(oneRoom(pickupAt("barrel", "0.5 1.5 -8")));
  game->tick({});
  std::vector<Sight> sights;
  game->look(sights);
  ASSERT_EQ(sights.size(), 1u);
  EXPECT_EQ(sights[0].kind, SightKind::PowerUp);
  EXPECT_EQ(sights[0].type, "barrel");
  EXPECT_TRUE(sights[0].clear);
  EXPECT_NEAR(sights[0].position.x(), 0.5f, 1e-6f);
}

}  // namespace
}  // namespace brittle::sim
