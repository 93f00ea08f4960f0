#include "engine/runtime/pace.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brittle::runtime {
namespace {

/// Frames begun within a second when each takes `work` [s] and, with `period` > 0, a display that holds them until its
/// next refresh.
int framesInASecond(double work, double period, double told) {
  Pace pace;
  pace.setPeriod(told);
  int frames = 0;
  for (double now = 100.0; now < 101.0; ++frames) {
    now += work;
    if (period > 0.0) now = (std::floor(now / period) + 1.0) * period;
    now += pace.rest(now);
  }
  return frames;
}

TEST(Pace, HoldsFramesBackToOneARefreshWhereTheDisplayDoesNot) {
  EXPECT_NEAR(framesInASecond(0.001, 0.0, 1.0 / 60.0), 60, 1);
  EXPECT_NEAR(framesInASecond(0.010, 0.0, 1.0 / 60.0), 60, 1) << "the work is part of the wait";
  EXPECT_NEAR(framesInASecond(0.001, 0.0, 1.0 / 144.0), 144, 1);
}

TEST(Pace, LeavesFramesAloneThatTheDisplayHoldsBack) {
  EXPECT_NEAR(framesInASecond(0.002, 1.0 / 60.0, 1.0 / 60.0), 60, 1);
  EXPECT_NEAR(framesInASecond(0.002, 1.001 / 60.0, 1.0 / 59.0), 60, 1) << "59.94 a second, told as 59";
  EXPECT_NEAR(framesInASecond(0.020, 1.0 / 60.0, 1.0 / 60.0), 30, 1) << "every other refresh, not fewer";
}

TEST(Pace, AddsNothingToFramesThatTakeLonger) {
  EXPECT_NEAR(framesInASecond(0.025, 0.0, 1.0 / 60.0), 40, 1);
}

TEST(Pace, OversleepingDoesNotAddUp) {
  Pace pace;
  pace.setPeriod(1.0 / 60.0);
  int frames = 0;
  for (double now = 100.0; now < 101.0; ++frames) {
    const double rest = pace.rest(now += 0.001);
    if (rest > 0.0) now += rest + 0.001;
  }
  EXPECT_NEAR(frames, 60, 2);
}

}  // namespace
}  // namespace brittle::runtime
