#include "game/sim/score.h"

#include <gtest/gtest.h>

#include "game/sim/constants.h"

namespace brittle::sim {
namespace {

TEST(Score, AThrowCostsOneBall) {
  Score score;
  score.balls = 2;
  EXPECT_TRUE(score.spendThrow());
  EXPECT_TRUE(score.spendThrow());
  EXPECT_FALSE(score.spendThrow());
  EXPECT_EQ(score.balls, 0);
}

TEST(Score, TenCrystalsInARowGiveAnotherBallPerThrowUpToFive) {
  Score score;
  for (int streak = 0; streak < 60; ++streak) {
    EXPECT_EQ(score.ballsPerThrow(), streak / 10 + 1 < 5 ? streak / 10 + 1 : 5);
    score.winCrystal(3, 999);
  }
}

TEST(Score, ACrashCostsTenBallsOrAllAndTheStreak) {
  Score score;
  score.balls = 14;
  score.winCrystal(3, 999);
  EXPECT_EQ(score.crash(), 10);
  EXPECT_EQ(score.streak, 0);
  EXPECT_FALSE(score.canCrash());
  EXPECT_EQ(score.crash(), 7);
  EXPECT_EQ(score.balls, 0);
}

TEST(Score, TheGameIsOverOnlyWhenTheLastBallHadItsChance) {
  Score score;
  score.balls = 0;
  for (int i = 0; i < rules::kLastBallTicks; ++i) {
    score.tick();
    EXPECT_FALSE(score.over);
  }
  score.tick();
  EXPECT_TRUE(score.over);
}

TEST(Score, BallsAreNotCountedWhenFree) {
  Score score;
  score.free = true;
  EXPECT_TRUE(score.spendThrow());
  EXPECT_EQ(score.crash(), 0);
  for (int i = 0; i < 1000; ++i) score.tick();
  EXPECT_FALSE(score.over);
}

TEST(Score, WinningStopsAtTheCap) {
  Score score;
  score.balls = 498;
  score.winCrystal(10, 500);
  EXPECT_EQ(score.balls, 500);
}

}  // namespace
}  // namespace brittle::sim
