#include "game/sim/pace.h"

#include <gtest/gtest.h>

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

TEST(Pace, SpeedGlidesAcrossADoorAndArrives) {
  Pace pace = inRoom(100.0f);
  while (!pace.atDoor()) pace.tick();
  pace.enterRoom(200.0f);
  float before = pace.speed();
  for (int i = 0; i < 4000; ++i) {
    pace.tick();
    EXPECT_LE(before, pace.speed());
    EXPECT_LT(pace.speed() - before, 0.02f);
    before = pace.speed();
  }
  EXPECT_EQ(pace.speed(), 6.25f);
}

TEST(Pace, LengthsAreMultiplesOfTheStep) {
  EXPECT_EQ(allowedLength(137.3f), 137.30078125f);
  EXPECT_EQ(allowedLength(1.0f), 8.0f);
  EXPECT_EQ(allowedLength(1e30f), 4000.0f);
}

}  // namespace
}  // namespace brittle::sim
