#include "game/sim/pace.h"

#include <gtest/gtest.h>

#include <cmath>

#include "game/sim/constants.h"

namespace brittle::sim {
namespace {

Pace inRoom(float length) {
  Pace pace;
  pace.startBefore(length);
  while (!pace.atDoor()) pace.tick();
  pace.enterRoom(length);
  return pace;
}

TEST(Pace, ARoomTakesThirtyTwoSecondsWhateverItsLength) {
  for (const float length : {32.0f, 137.3f, 160.0f, 450.0f}) {
    Pace pace = inRoom(length);
    int ticks = 0;
    while (!pace.atDoor()) {
      pace.tick();
      ++ticks;
    }
    EXPECT_EQ(ticks, rules::kRoomTicks) << length;
  }
}

TEST(Pace, SpeedIsTheDeclaredLengthOverThirtyTwoSeconds) {
  EXPECT_FLOAT_EQ(inRoom(160.0f).speed(), 5.0f);
  EXPECT_FLOAT_EQ(inRoom(200.0f).speed(), 6.25f);
}

TEST(Pace, IdenticalRoomsAreWalkedIdentically) {
  Pace first = inRoom(137.3f);
  Pace later = inRoom(137.3f);
  for (int room = 0; room < 5; ++room) {
    while (!later.atDoor()) later.tick();
    later.enterRoom(137.3f);
  }
  for (int i = 0; i < rules::kRoomTicks; ++i) {
    first.tick();
    later.tick();
    ASSERT_EQ(first.distance(), later.distance());
  }
}

TEST(Pace, SpeedGlidesAcrossADoor) {
  for (const float length : {50.0f, 101.0f, 200.0f, 450.0f}) {
    Pace pace = inRoom(100.0f);
    while (!pace.atDoor()) pace.tick();
    EXPECT_EQ(pace.distance(), 100.0f);
    pace.enterRoom(length);
    EXPECT_EQ(pace.distance(), 0.0f);
    float before = pace.speed();
    float place = 0.0f;
    while (!pace.atDoor()) {
      pace.tick();
      EXPECT_LT(std::abs(pace.speed() - before), 0.02f * std::abs(length - 100.0f) / 32.0f + 1e-3f);
      EXPECT_NEAR(pace.distance() - place, pace.speed() / 60.0f, 1e-4f);
      before = pace.speed();
      place = pace.distance();
    }
    EXPECT_EQ(pace.ticks(), rules::kRoomTicks) << length;  // 32 s also while it glides
    EXPECT_EQ(pace.distance(), length);
    EXPECT_NEAR(pace.speed(), length / 32.0f, 0.05f);
  }
}

TEST(Pace, TheNextRoomIsDueThirtyMetresBeforeTheDoorOrAfterTwentyEightSeconds) {
  for (const float length : {100.0f, 200.0f, 450.0f}) {
    Pace pace = inRoom(length);
    while (!pace.nextRoomDue()) pace.tick();
    const bool isNear = pace.distance() > length - rules::kNextRoomAhead;
    EXPECT_TRUE(isNear || pace.ticks() == 28 * 60 + 1) << length;
    EXPECT_EQ(isNear, length < 240.0f) << length;
  }
}

TEST(Pace, LengthsAreMultiplesOfTheStep) {
  EXPECT_EQ(allowedLength(137.3f), 137.30078125f);
  EXPECT_EQ(allowedLength(1.0f), 8.0f);
  EXPECT_EQ(allowedLength(1e30f), 4000.0f);
}

}  // namespace
}  // namespace brittle::sim
