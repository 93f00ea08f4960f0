#include "engine/runtime/fixed_step.h"

#include <gtest/gtest.h>

namespace brittle::runtime {
namespace {

int ticksAt(double framesPerSecond, double seconds) {
  FixedStep step;
  int ticks = 0;
  const int frames = static_cast<int>(framesPerSecond * seconds + 0.5);
  for (int i = 0; i < frames; ++i) ticks += step.advance(1.0 / framesPerSecond);
  return ticks;
}

TEST(FixedStep, SixtyTicksASecondAtAnyFrameRate) {
  for (const double rate : {20.0, 30.0, 59.94, 60.0, 90.0, 120.0, 144.0, 1000.0})
    EXPECT_NEAR(ticksAt(rate, 10.0), 600, 1) << rate;
}

TEST(FixedStep, AFrameOfOneTickGivesExactlyOneTickAnHourLong) {
  FixedStep step;
  for (int i = 0; i < 60 * 60 * 60; ++i) ASSERT_EQ(step.advance(kTickSeconds), 1) << i;
}

TEST(FixedStep, AlphaIsTheRestInTicks) {
  FixedStep step;
  EXPECT_EQ(step.alpha(), 0.0f);
  EXPECT_EQ(step.advance(0.25 * kTickSeconds), 0);
  EXPECT_FLOAT_EQ(step.alpha(), 0.25f);
  EXPECT_EQ(step.advance(1.5 * kTickSeconds), 1);
  EXPECT_FLOAT_EQ(step.alpha(), 0.75f);
  for (int i = 0; i < 10000; ++i) {
    step.advance(0.37 * kTickSeconds * (i % 9));
    ASSERT_GE(step.alpha(), 0.0f);
    ASSERT_LE(step.alpha(), 1.0f);
  }
}

TEST(FixedStep, ALongPauseIsDroppedNotMadeUpFor) {
  FixedStep step;
  EXPECT_EQ(step.advance(10.0), kMostTicksPerFrame);
  EXPECT_EQ(step.advance(0.0), 0);
  EXPECT_EQ(step.advance(kTickSeconds), 1);
}

TEST(FixedStep, AClockThatGoesBackGivesNothing) {
  FixedStep step;
  EXPECT_EQ(step.advance(-5.0), 0);
  EXPECT_EQ(step.advance(kTickSeconds), 1);
}

}  // namespace
}  // namespace brittle::runtime
