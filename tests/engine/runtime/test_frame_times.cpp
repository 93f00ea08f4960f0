#include "engine/runtime/frame_times.h"

#include <gtest/gtest.h>

namespace brittle::runtime {
namespace {

/// `count` frames of `length` [s], a tenth of it ticks, half of it drawing.
void play(FrameTimer& timer, double& now, int count, double length) {
  for (int i = 0; i < count; ++i) {
    timer.begins(now);
    timer.simulated(now + 0.1 * length);
    timer.drawn(now + 0.6 * length);
    timer.swapped(now + length);
    now += length;
  }
}

TEST(FrameTimes, AreMeansOfHalfASecondHoweverLongAFrameTakes) {
  for (const double length : {0.004, 1.0 / 60.0, 0.2, 0.7}) {
    FrameTimer timer;
    double now = 3.0;
    play(timer, now, static_cast<int>(0.5 / length), length);
    EXPECT_EQ(timer.times().frame, 0.0) << "not yet";
    play(timer, now, 3, length);
    EXPECT_NEAR(timer.times().frame, length, 1e-9);
    EXPECT_NEAR(timer.times().simulate, 0.1 * length, 1e-9);
    EXPECT_NEAR(timer.times().draw, 0.5 * length, 1e-9);
    EXPECT_NEAR(timer.times().swap, 0.4 * length, 1e-9);
  }
}

TEST(FrameTimes, TheLongestFrameIsNoMean) {
  FrameTimer timer;
  double now = 0.0;
  play(timer, now, 10, 0.01);
  play(timer, now, 1, 0.1);
  play(timer, now, 40, 0.01);
  EXPECT_NEAR(timer.times().longest, 0.1, 1e-9);
  EXPECT_LT(timer.times().frame, 0.02);
}

}  // namespace
}  // namespace brittle::runtime
