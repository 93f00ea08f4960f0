#include "game/sim/sight.h"

#include <cmath>

#include "tests/game/sim/fixture.h"

namespace brittle::sim {
namespace {

std::vector<Sight> sightsOf(const std::string& elements, int ticks = 1) {
  const content::MemorySource source = oneRoom(elements);
  const auto game = newTestGame(source);
  play(*game, ticks);
  const std::uint64_t before = game->stateHash();
  std::vector<Sight> sights;
  game->look(sights);
  EXPECT_EQ(game->stateHash(), before);
  return sights;
}

TEST(Sight, ACrystalIsSeenWhereItIsUntilItIsWonOrPassed) {
  const content::MemorySource source = oneRoom("<obstacle pos=\"1 0.2 -10\" type=\"scoretop\"/>");
  const auto game = newTestGame(source);
  play(*game, 12);  // 1 m
  std::vector<Sight> sights;
  game->look(sights);
  ASSERT_EQ(sights.size(), 1u);
  EXPECT_EQ(sights[0].kind, SightKind::Crystal);
  EXPECT_EQ(sights[0].worth, 3);
  EXPECT_EQ(sights[0].type, "scoretop");
  EXPECT_TRUE(sights[0].clear);
  EXPECT_NEAR((sights[0].position - Vec3(1.0f, -0.65f, 9.0f)).norm(), 0.0f, 0.1f);
  const Vec3 at = sights[0].position;
  game->tick(throwAt(at.x() / at.z(), at.y() / at.z()));
  play(*game, 40);
  EXPECT_EQ(game->totalCrystals(), 1u);
  game->look(sights);
  EXPECT_TRUE(sights.empty());
}

TEST(Sight, WhatIsBehindAnotherThingIsNotClear) {
  const std::string crystal = "<obstacle pos=\"1 0.2 -12\" type=\"scoretop\"/>";
  const auto behindGlass = sightsOf(crystal + "<obstacle pos=\"1 1 -8\" type=\"framedwindow\" param0=\"width=4\"/>");
  ASSERT_EQ(behindGlass.size(), 2u);
  EXPECT_EQ(behindGlass[0].type, "framedwindow");
  EXPECT_TRUE(behindGlass[0].clear);
  EXPECT_FALSE(behindGlass[1].clear);
  const auto behindWall = sightsOf(crystal + "<box pos=\"1 1 -8\" size=\"1 2 .1\"/>");
  ASSERT_EQ(behindWall.size(), 1u);
  EXPECT_FALSE(behindWall[0].clear);
}

TEST(Sight, AThreatIsSeenByHowFarItIsFromTheWay) {
  const auto inTheWay = sightsOf("<obstacle pos=\"0 1 -10\" type=\"framedwindow\" param0=\"frame=0\"/>");
  ASSERT_EQ(inTheWay.size(), 1u);
  EXPECT_EQ(inTheWay[0].kind, SightKind::Threat);
  EXPECT_TRUE(inTheWay[0].gives);
  EXPECT_LT(inTheWay[0].aside, 0.01f);
  EXPECT_GT(inTheWay[0].mass, 50.0f);
  const auto beside = sightsOf("<obstacle pos=\"2 -0.6 -10\" type=\"box\" param0=\"sizeX=0.4\" param1=\"sizeY=0.4\"/>");
  ASSERT_EQ(beside.size(), 1u);
  EXPECT_NEAR(beside[0].aside, std::sqrt(1.6f * 1.6f + 1.2f * 1.2f), 0.02f);
}

TEST(Sight, AHoleThatWasShotIsNoThreat) {
  const content::MemorySource source = oneRoom("<obstacle pos=\"0 1 -14\" type=\"framedwindow\" param0=\"width=3\"/>");
  const auto game = newTestGame(source);
  std::vector<Sight> sights;
  play(*game, 20);
  game->look(sights);
  ASSERT_EQ(sights.size(), 1u);
  EXPECT_LT(sights[0].aside, rules::kCameraRadius);
  game->tick(throwAt(0.0f, 0.0f));
  play(*game, 90);
  game->look(sights);
  for (const Sight& sight : sights) EXPECT_GT(sight.aside, rules::kCameraRadius);
}

TEST(Sight, AMovingPaneIsSeenWithItsVelocity) {
  const content::MemorySource source =
      oneRoom("<obstacle pos=\"0 1 -10\" type=\"sweeper\" param0=\"width=2\" param1=\"speed=2\"/>");
  const auto game = newTestGame(source);
  std::vector<Sight> before, after;
  float fastest = 0.0f;
  for (int i = 0; i < 60; ++i) {
    game->look(before);
    game->tick({});
    game->look(after);
    ASSERT_EQ(before.size(), 1u);
    ASSERT_EQ(after.size(), 1u);
    const float velocity = (after[0].center.x() - before[0].center.x()) * 60.0f;
    EXPECT_NEAR(after[0].velocity.x(), velocity, 0.02f);
    fastest = std::max(fastest, std::abs(velocity));
  }
  EXPECT_GT(fastest, 1.5f);
}

TEST(Sight, AButtonIsSeenAndADoorThatNoBallOpens) {
  const auto door = sightsOf("<obstacle pos=\"0 1 -14\" type=\"doors/basic\" param0=\"buttons=1\"/>");
  ASSERT_EQ(door.size(), 2u);
  const Sight& button = door[0].kind == SightKind::Button ? door[0] : door[1];
  const Sight& leaf = door[0].kind == SightKind::Button ? door[1] : door[0];
  EXPECT_EQ(button.kind, SightKind::Button);
  EXPECT_NEAR(button.position.y(), 1.35f, 0.05f);
  EXPECT_EQ(leaf.kind, SightKind::Threat);
  EXPECT_FALSE(leaf.gives);
}

}  // namespace
}  // namespace brittle::sim
