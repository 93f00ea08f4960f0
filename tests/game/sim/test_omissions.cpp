// What the rules put off, refuse or take away is counted, each in a scene that makes it happen.
#include "game/sim/omission.h"

#include <gtest/gtest.h>

#include "tests/game/sim/fixture.h"

namespace brittle::sim {
namespace {

TEST(Omissions, WhatIsPassedAndWhatFalls) {
  const auto game =
      newTestGame(withObstacles(1,
                                "function init() mgMaterial('steel') mgCreateBox(mgCreateBody(9, 0, 0), .1, .1, .1)\n"
                                "mgStatic(1) mgCreateBox(mgCreateBody(-4, 1, 0), .1, .1, .1) end"));
  play(*game, 400);
  EXPECT_EQ(countOf(*game, nameOf(Omission::Fallen)), 1u);
  EXPECT_EQ(countOf(*game, nameOf(Omission::BehindCamera)), 1u);
}

TEST(Omissions, ObstaclesThatWaitForTheirStart) {
  const auto game =
      newTestGame(withObstacles(450, "function init() mgStatic(1) mgCreateBox(mgCreateBody(), 1, 1, 1) end"));
  EXPECT_GT(countOf(*game, nameOf(Omission::DeferredObstacle)), 100u);
}

TEST(Omissions, ScriptsThatGetNoTime) {
  const auto game = newTestGame(withObstacles(100, "function tick() for i = 1, 60000 do end end"));
  play(*game, 3);
  EXPECT_GT(countOf(*game, nameOf(Omission::IdleScript)), 0u);
}

TEST(Omissions, ObstaclesTakenOutOfACrowd) {
  const auto game = newTestGame(withObstacles(
      8, "function init() mgMaterial('steel') for i = 1, 100 do mgCreateBox(mgCreateBody(), .3, .3, .3) end end"));
  EXPECT_GT(countOf(*game, nameOf(Omission::RemovedObstacle)), 0u);
}

TEST(Omissions, ThingsWithoutAPlace) {
  const auto bodies =
      newTestGame(withObstacles(1, "function init() mgStatic(1) for i = 1, 300 do mgCreateBody() end end"));
  EXPECT_EQ(countOf(*bodies, nameOf(Omission::RefusedContent)), 1u) << "the script stops there";
  const auto obstacles = newTestGame(withObstacles(503, "function init() end"));
  EXPECT_EQ(countOf(*obstacles, nameOf(Omission::RefusedContent)), 3u) << "of 503";
}

// Each thing counts, however many of them stand in one segment.
TEST(Omissions, ThingsWithoutAPlaceCountOneByOne) {
  const auto refused = [](const std::string& elements, const std::string& room) {
    content::MemorySource source = oneRoom(elements, 0.0f, room + " mgLength(320)");
    source.add("obstacles/empty.lua", "");
    const auto game = newTestGame(source);
    return countOf(*game, nameOf(Omission::RefusedContent));
  };
  const std::string twice = "mgSegment('test/corridor', 0) mgSegment('test/corridor', -32)";
  EXPECT_EQ(refused(repeated(351, "<obstacle pos=\"0 1 -9\" type=\"empty\"/>"), twice),
            702u - rules::kMaxObstaclesPerRoom);
  EXPECT_EQ(refused(repeated(40, "<water pos=\"0 0 -9\" size=\"1 1\"/>"), twice), 80u - rules::kMaxWatersPerRoom);
  EXPECT_EQ(refused(repeated(150, "<powerup pos=\"0 1 -9\" type=\"barrel\"/>"), twice),
            300u - rules::kMaxPickupsPerRoom);
  const std::string parts = repeated(1000, "<box pos=\"0 -9 -1\" size=\"1 1 1\"/>") +
                            "<box pos=\"0 0 0\" size=\"1 1 1\" hidden=\"1\"/><obstacle pos=\"0 0 -1\" type=\"stone\"/>"
                            "<decal pos=\"0 0 0\"/><obstacle pos=\"0 1 -1\" type=\"empty\"/>";
  EXPECT_EQ(refused(parts, "for i = 1, 2 do mgSegment('test/corridor', 0) end"), 1000u + 4 + 2)
      << "the second with its walls, stone and decal; its obstacle has a place";
}

TEST(Omissions, ThrowsBeyondThoseOfAFrame) {
  const auto game = newTestGame(oneRoom(""));
  replay::InputFrame frame;
  for (int i = 0; i < replay::kMaxThrows + 3; ++i) frame.throws.push_back(replay::quantizeAim(0.0f, 0.0f));
  game->tick(frame);
  EXPECT_EQ(countOf(*game, nameOf(Omission::RefusedThrow)), 3u);
}

TEST(Omissions, ProblemsThatAreNotTold) {
  std::string powerUps;
  for (int i = 0; i < 300; ++i) powerUps += "<powerup pos=\"0 0 0\" type=\"p" + std::to_string(i) + "\"/>";
  const auto game = newTestGame(oneRoom(powerUps, 320.0f));
  EXPECT_EQ(countOf(*game, nameOf(Omission::UntoldProblem)), 300u - rules::kMaxProblems);
}

// Those of the worlds that are left stay in the sum.
TEST(Omissions, OfRoomsThatArePassedAreNotForgotten) {
  GameDef def;
  def.mode = Mode::Zen;
  def.accuracy.maxDebris = 1;
  def.accuracy.minVolumeScale = 100.0f;
  const auto game = newGame(shippedAssets(), def);
  std::uint64_t last = 0;
  const auto crumbs = [&] { return countOf(*game, nameOf(physics::Omission::RecycledCrumb)); };
  while (game->roomNumber() == 0 && game->tickCount() < 3000) {
    last = crumbs();
    game->tick(scriptedInput(game->tickCount()));
  }
  ASSERT_EQ(game->roomNumber(), 1u);
  EXPECT_GT(last, 0u);
  EXPECT_GE(crumbs(), last);
}

// Its rooms are made anew, and put off what they had put off before.
TEST(Omissions, OfMakingARestoredGameAreNotCountedAgain) {
  const content::MemorySource source =
      withObstacles(450, "function init() mgStatic(1) mgCreateBox(mgCreateBody(), 1, 1, 1) end");
  const auto saved = newTestGame(source), restored = newTestGame(source);
  ByteWriter out;
  saved->save(out);
  ByteReader in(out.bytes());
  ASSERT_TRUE(restored->restore(in));
  EXPECT_EQ(countOf(*restored, nameOf(Omission::DeferredObstacle)), 0u);
}

TEST(Omissions, HaveANameEach) {
  EXPECT_STREQ(nameOf(Omission::BehindCamera), "bodies passed");
  EXPECT_STREQ(nameOf(Omission::UntoldProblem), "reports not told");
}

}  // namespace
}  // namespace brittle::sim
