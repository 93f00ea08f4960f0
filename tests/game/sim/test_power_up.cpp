#include "game/sim/power_up.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/sim/constants.h"

namespace brittle::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr PowerUp kAll[] = {PowerUp::BallFrenzy, PowerUp::SlowMotion, PowerUp::NitroBalls, PowerUp::Barrel};

TEST(PowerUp, NamesAreTheFormats) {
  for (const PowerUp kind : kAll) EXPECT_EQ(powerUpNamed(nameOf(kind)), kind);
  EXPECT_EQ(powerUpNamed("ballfrenzy"), PowerUp::BallFrenzy);
  for (const char* inert : {"multiball", "freebie", "antigravity", "rewind", "sheild", "homing", "life", "balls", ""})
    EXPECT_FALSE(powerUpNamed(inert)) << inert;
}

TEST(Inventory, KindsStandInTheOrderTheyWereCollectedAndCount) {
  Inventory inventory;
  for (const PowerUp kind : {PowerUp::Barrel, PowerUp::BallFrenzy, PowerUp::Barrel}) inventory.collect(kind);
  ASSERT_EQ(inventory.slots().size(), 2u);
  EXPECT_EQ(inventory.slots()[0].kind, PowerUp::Barrel);
  EXPECT_EQ(inventory.count(PowerUp::Barrel), 2);
  EXPECT_EQ(inventory.count(PowerUp::BallFrenzy), 1);
  EXPECT_EQ(inventory.count(PowerUp::SlowMotion), 0);
}

TEST(Inventory, HoldsADigitsWorthOfAKind) {
  Inventory inventory;
  for (int i = 0; i < 20; ++i) inventory.collect(PowerUp::Barrel);
  EXPECT_EQ(inventory.count(PowerUp::Barrel), rules::kMostPowerUps);
  EXPECT_TRUE(inventory.isValid());
}

TEST(Inventory, RunsForItsTicksAndLeavesItsPlace) {
  for (const PowerUp kind : {PowerUp::BallFrenzy, PowerUp::SlowMotion, PowerUp::NitroBalls}) {
    Inventory inventory;
    inventory.collect(kind);
    EXPECT_EQ(inventory.use(0), kind);
    for (int i = 0; i < ticksOf(kind) - 1; ++i) ASSERT_THAT(inventory.tick(), IsEmpty());
    EXPECT_TRUE(inventory.runs(kind));
    EXPECT_THAT(inventory.tick(), ElementsAre(kind));
    EXPECT_TRUE(inventory.isEmpty());
  }
}

TEST(Inventory, AnotherOfAKindThatRunsMakesItLonger) {
  Inventory inventory;
  inventory.collect(PowerUp::BallFrenzy);
  inventory.collect(PowerUp::BallFrenzy);
  inventory.use(0);
  for (int i = 0; i < 100; ++i) inventory.tick();
  inventory.use(0);
  EXPECT_EQ(inventory.slots()[0].ticksLeft, 2 * rules::kFrenzyTicks - 100);
  EXPECT_EQ(inventory.slots()[0].ticksAll, inventory.slots()[0].ticksLeft) << "the pie is whole again";
  EXPECT_FALSE(inventory.use(0)) << "there is none left";
}

TEST(Inventory, ABarrelWaitsForItsThrow) {
  Inventory inventory;
  inventory.collect(PowerUp::Barrel);
  inventory.collect(PowerUp::Barrel);
  EXPECT_TRUE(inventory.use(0));
  EXPECT_FALSE(inventory.use(0)) << "one at a time";
  for (int i = 0; i < 10'000; ++i) ASSERT_THAT(inventory.tick(), IsEmpty());
  inventory.finish(PowerUp::Barrel);
  EXPECT_FALSE(inventory.runs(PowerUp::Barrel));
  EXPECT_EQ(inventory.count(PowerUp::Barrel), 1);
}

TEST(Inventory, UsingAnEmptyPlaceIsNothing) {
  Inventory inventory;
  for (std::size_t place = 0; place < 5; ++place) EXPECT_FALSE(inventory.use(place));
}

TEST(Inventory, StoppingEndsWhatRunsAndKeepsTheRest) {
  Inventory inventory;
  for (int i = 0; i < 2; ++i) inventory.collect(PowerUp::NitroBalls);
  inventory.use(0);
  inventory.stop();
  EXPECT_FALSE(inventory.runs(PowerUp::NitroBalls));
  EXPECT_EQ(inventory.count(PowerUp::NitroBalls), 1);
  EXPECT_TRUE(inventory.isValid());
}

}  // namespace
}  // namespace brittle::sim
