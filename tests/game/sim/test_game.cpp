#include "game/sim/game.h"

#include <gtest/gtest.h>

#include <cstring>

#include "engine/core/random.h"
#include "tests/game/sim/fixture.h"

namespace brittle::sim {
namespace {

const std::string kWindow = "<obstacle pos=\"0 1 -14\" type=\"framedwindow\" param0=\"width=3\" param1=\"height=2\"/>";

TEST(Game, StartsAtTheDoorOfTheFirstRoomWithAllBalls) {
  const auto game = newGame(shippedAssets());
  ASSERT_TRUE(game);
  EXPECT_EQ(game->tickCount(), 0u);
  EXPECT_EQ(game->roomDistance(), 0.0f);
  EXPECT_EQ(game->hud().balls, rules::kStartBalls);
  EXPECT_EQ(game->camera().position, Vec3(0.0f, rules::kCameraHeight, 0.0f));
  EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
}

TEST(Game, RefusesAMissingLevel) {
  GameDef def;
  def.level = "nowhere";
  const auto made = Game::create(shippedAssets(), def);
  ASSERT_FALSE(static_cast<bool>(made));
  EXPECT_NE(made.error().message.find("nowhere"), std::string::npos);
}

TEST(Game, TheSameInputsGiveTheSameGame) {
  const auto a = newGame(shippedAssets());
  const auto b = newGame(shippedAssets());
  for (std::uint64_t tick = 0; tick < 700; ++tick) {
    a->tick(scriptedInput(tick));
    b->tick(scriptedInput(tick));
    ASSERT_EQ(a->stateHash(), b->stateHash()) << tick;
  }
  EXPECT_GT(a->totalBreaks(), 3u);
}

TEST(Game, LookingChangesNothing) {
  const auto a = newGame(shippedAssets());
  const auto b = newGame(shippedAssets());
  FramePacket packet;
  for (std::uint64_t tick = 0; tick < 300; ++tick) {
    a->tick(scriptedInput(tick));
    b->tick(scriptedInput(tick));
    b->copyFrame(packet);
    if (tick % 30 == 0) {
      ByteWriter out;
      b->save(out);
    }
  }
  EXPECT_EQ(a->stateHash(), b->stateHash());
}

TEST(Game, ContinuesTheSameFromASnapshotOfAnyTick) {
  const auto game = newGame(shippedAssets());
  Random random(7);
  for (int part = 0; part < 6; ++part) {
    const std::uint64_t skip = 40 + random.nextBelow(120);
    for (std::uint64_t i = 0; i < skip; ++i) game->tick(scriptedInput(game->tickCount()));
    ByteWriter out;
    game->save(out);
    const auto other = newGame(shippedAssets());
    ByteReader in(out.bytes());
    ASSERT_TRUE(other->restore(in)) << game->tickCount();
    EXPECT_EQ(in.remaining(), 0u);
    ASSERT_EQ(other->stateHash(), game->stateHash()) << game->tickCount();
    for (int i = 0; i < 40; ++i) {
      const replay::InputFrame input = scriptedInput(game->tickCount());
      game->tick(input);
      other->tick(input);
      ASSERT_EQ(other->stateHash(), game->stateHash()) << game->tickCount();
    }
  }
}

TEST(Game, RefusesACutSnapshot) {
  const auto game = newGame(shippedAssets());
  play(*game, 30);
  ByteWriter out;
  game->save(out);
  const auto other = newGame(shippedAssets());
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{3}, std::size_t{40}, out.bytes().size() / 2, out.bytes().size() - 1}) {
    ByteReader in(std::span(out.bytes()).first(size));
    EXPECT_FALSE(other->restore(in)) << size;
  }
}

// What neither checksum nor hash refuses, since whoever changed it made both anew: refused, or a game that goes on.
TEST(Game, AForgedSnapshotIsRefusedOrPlays) {
  const auto game = newGame(shippedAssets());
  for (int i = 0; i < 60; ++i) game->tick(scriptedInput(game->tickCount()));
  ByteWriter out;
  game->save(out);
  constexpr std::uint32_t numbers[] = {0, 1, 300, 0x7fffffff, 0x80000000, 0xffffffff};
  Random random(13);
  int refused = 0;
  for (int i = 0; i < 40; ++i) {
    std::vector<unsigned char> bytes = out.bytes();
    const std::uint32_t end = random.nextBelow(2) == 0 ? 2000 : static_cast<std::uint32_t>(bytes.size()) - 4;
    std::memcpy(&bytes[random.nextBelow(end)], &numbers[random.nextBelow(6)], 4);
    const auto other = newGame(shippedAssets());
    ByteReader in(bytes);
    if (!other->restore(in)) {
      ++refused;
      continue;
    }
    for (int tick = 0; tick < 3; ++tick, other->stateHash()) other->tick({});
  }
  EXPECT_GT(refused, 5);
}

TEST(Game, APaneThatWasNotShotIsACrash) {
  const content::MemorySource source = oneRoom(kWindow);
  const auto game = newTestGame(source);
  const auto events = play(*game, 240);
  EXPECT_EQ(game->totalCrashes(), 1u);
  EXPECT_EQ(game->hud().balls, rules::kStartBalls - rules::kCrashCost);
  EXPECT_GE(events.count(EventType::Break), 1u);
}

TEST(Game, AHoleThatWasShotIsAWayThrough) {
  const content::MemorySource source = oneRoom(kWindow);
  const auto game = newTestGame(source);
  play(*game, 20);
  game->tick(throwAt(0.0f, 0.0f));
  const auto events = play(*game, 240);
  EXPECT_EQ(events.at(EventType::Break), 1);
  EXPECT_EQ(game->totalCrashes(), 0u);
  EXPECT_EQ(game->hud().balls, rules::kStartBalls - 1);
}

TEST(Game, ABallBreaksThePaneWhereItWasAimed) {
  const content::MemorySource source =
      oneRoom("<obstacle pos=\"0 1 -10.5\" type=\"framedwindow\" param0=\"width=6\" param1=\"height=4\"/>");
  for (const float x : {-0.2f, 0.0f, 0.15f}) {
    const auto game = newTestGame(source);
    game->tick(throwAt(x, 0.05f));
    bool broke = false;
    for (int i = 0; i < 60 && !broke; ++i) {
      game->tick({});
      for (const Event& event : game->events()) {
        if (event.type != EventType::Break) continue;
        broke = true;
        EXPECT_NEAR(event.point.x(), x * 10.5f, 0.2f);
        EXPECT_NEAR(event.point.y(), 1.0f + 0.05f * 10.5f, 0.2f);
        EXPECT_GT(event.speed, rules::kThrowSpeed);
        EXPECT_EQ(event.look, Look::Glass);
      }
    }
    EXPECT_TRUE(broke) << x;
  }
}

TEST(Game, ACrystalWinsBallsAndStreak) {
  const content::MemorySource source = oneRoom("<obstacle pos=\"0 0.7 -10\" type=\"scoretop\"/>");
  const auto game = newTestGame(source);
  game->tick(throwAt(0.0f, 0.0f));
  const auto events = play(*game, 60);
  EXPECT_EQ(events.count(EventType::Crystal), 1u);
  EXPECT_EQ(game->hud().balls, rules::kStartBalls - 1 + 3);
  EXPECT_EQ(game->hud().streak, 1);
}

TEST(Game, ACrystalPassedUnbrokenEndsTheStreak) {
  const content::MemorySource source =
      oneRoom("<obstacle pos=\"0 0.7 -10\" type=\"scoretop\"/><obstacle pos=\"2 0 -14\" type=\"scoretop\"/>");
  const auto game = newTestGame(source);
  game->tick(throwAt(0.0f, 0.0f));
  play(*game, 60);
  EXPECT_EQ(game->hud().streak, 1);
  const auto events = play(*game, 200);
  EXPECT_EQ(events.at(EventType::CrystalMissed), 1);
  EXPECT_EQ(game->hud().streak, 0);
}

TEST(Game, ADoorOpensForTheCamera) {
  const content::MemorySource source =
      oneRoom("<obstacle pos=\"0 1 -14\" type=\"doors/basic\" param0=\"distance=5\"/>");
  const auto game = newTestGame(source);
  const auto events = play(*game, 240);
  EXPECT_EQ(events.count(EventType::DoorOpens), 1u);
  EXPECT_EQ(game->totalCrashes(), 0u);
}

TEST(Game, AClosedDoorIsACrashAndAButtonOpensIt) {
  const content::MemorySource source =
      oneRoom("<obstacle pos=\"0 1 -14\" type=\"doors/basic\" param0=\"distance=5\" param1=\"buttons=1\"/>");
  const auto closed = newTestGame(source);
  play(*closed, 240);
  EXPECT_EQ(closed->totalCrashes(), 1u);
  const auto opened = newTestGame(source);
  play(*opened, 30);
  opened->tick(throwAt(0.0f, 1.35f / 11.5f));
  play(*opened, 240);
  EXPECT_EQ(opened->totalCrashes(), 0u);
}

TEST(Game, TheGameIsOverWhenAllBallsAreThrown) {
  const content::MemorySource source = oneRoom("");
  const auto game = newTestGame(source);
  for (int i = 0; i < 40; ++i) game->tick(throwAt(0.3f, 0.3f));
  EXPECT_EQ(game->hud().balls, 0);
  const auto events = play(*game, 150);
  EXPECT_EQ(events.count(EventType::GameOver), 1u);
  EXPECT_TRUE(game->isOver());
}

TEST(Game, AnotherSeedLaysOutTheGalleryAnew) {
  FramePacket packet;
  std::set<std::string> orders;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    GameDef def;
    def.seed = seed;
    def.firstRoom = 1;
    const auto game = newGame(shippedAssets(), def);
    game->copyFrame(packet);
    std::string order;
    for (const PlacedSegment& segment : packet.rooms[0].segments) order += segment.look->name + " ";
    orders.insert(order);
  }
  EXPECT_GT(orders.size(), 2u);
}

TEST(Game, BallsFlyOnIntoTheNextRoom) {
  content::MemorySource source = oneRoom("", 160.0f, "mgSegment(\"test/corridor\", 0) mgLength(32)");
  source.add("levels/test.xml", "<level><room type=\"test/room\"/><room type=\"test/room\"/></level>");
  const auto game = newTestGame(source);
  play(*game, 1400);
  game->tick(throwAt(0.0f, 0.05f));
  FramePacket packet;
  float farthest = 0.0f;
  for (int i = 0; i < 60; ++i) {
    game->tick({});
    game->copyFrame(packet);
    ASSERT_EQ(packet.balls.size(), 1u) << i;
    const float ahead = packet.camera.position.z() - packet.balls[0].pose.position.z();
    EXPECT_GT(ahead, farthest - 0.1f);  // no jump when it passes the door
    EXPECT_LT(ahead, farthest + 1.5f);
    farthest = ahead;
  }
  EXPECT_GT(farthest, 32.0f - game->roomDistance());
}

}  // namespace
}  // namespace brittle::sim
