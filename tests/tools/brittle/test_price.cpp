#include "tools/brittle/price.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace brittle::program {
namespace {

/// 100 ticks of about this time, every other one `unsteady` more, and 10 pictures of ten times that.
Spent spent(double milliseconds, double unsteady = 0.0, double bytes = 0.0) {
  Spent made;
  for (int i = 0; i < 100; ++i) made.ticks.push_back(milliseconds + (i / 10 % 2 == 0 ? unsteady : 0.0));
  made.pictures.assign(10, 10.0 * milliseconds);
  made.heapBytes = bytes;
  return made;
}

TEST(Price, IsWhatIsSavedWithoutTheEffect) {
  const Prices prices = pricesOf(spent(0.5, 0.0, 3000.0), spent(0.2, 0.0, 1000.0), spent(0.5, 0.0, 3000.0));
  EXPECT_NEAR(prices.msPerTick.value, 0.3, 1e-12);
  EXPECT_NEAR(prices.msPerTick.noise, 0.0, 1e-12);
  EXPECT_NEAR(prices.msPerFrame.value, 3.0, 1e-12);
  EXPECT_EQ(prices.bytes.value, 2000.0);
  EXPECT_EQ(prices.bytes.noise, 0.0);
}

TEST(Price, IsNoBetterKnownThanTheRoomIsItself) {
  const Prices prices = pricesOf(spent(0.5, 0.0, 3000.0), spent(0.4, 0.0, 2000.0), spent(0.3, 0.0, 2500.0));
  EXPECT_NEAR(prices.msPerTick.value, 0.0, 1e-12);
  EXPECT_NEAR(prices.msPerTick.noise, 0.2, 1e-12);
  EXPECT_NEAR(prices.msPerFrame.noise, 2.0, 1e-12);
  EXPECT_EQ(prices.bytes.noise, 500.0);
}

TEST(Price, IsNoBetterKnownThanItsTicksAreSteady) {
  const Spent steady = spent(0.5);
  const Price price = pricesOf(steady, spent(0.5, 0.2), steady).msPerTick;
  EXPECT_NEAR(price.value, -0.1, 1e-12);
  EXPECT_NEAR(price.noise, 2.0 * 0.1 / 3.0, 1e-12);  // ten parts, each 0.1 off their mean: sqrt(10 0.01 / 90)
}

TEST(Price, ThatCannotBeToldFromZeroIsShownAsThat) {
  EXPECT_EQ(inWords({0.1234, 0.01}, 1.0, 3), "0.123");
  EXPECT_EQ(inWords({-0.1234, 0.01}, 1.0, 3), "-0.123");  // a room may be dearer without an effect
  EXPECT_EQ(inWords({-0.0041, 0.0301}, 1.0, 3), "< 0.031");
  EXPECT_EQ(inWords({0.02, 0.0301}, 1.0, 2), "< 0.04");
  EXPECT_EQ(inWords({0.0, 0.0}, 1.0, 2), "< 0.01");
  EXPECT_EQ(inWords({2048.0, 100.0}, 1024.0, 1), "2.0");
}

TEST(Price, OfNothingPlayedIsNothing) {
  const Price price = pricesOf({}, {}, {}).msPerTick;
  EXPECT_EQ(price.value, 0.0);
  EXPECT_EQ(price.noise, 0.0);
}

}  // namespace
}  // namespace brittle::program
