// runtime/frame_times.h - where a frame's time goes, as means that can be read while they change. Sees moments only,
// never a clock.
#pragma once

#include <algorithm>

namespace brittle::runtime {

/// [s]
struct FrameTimes {
  double frame = 0.0;     // from one frame to the next
  double simulate = 0.0;  // its ticks
  double draw = 0.0;      // making the picture, and telling the GPU
  double swap = 0.0;      // until it is shown: what is left of the GPU's work, and the wait for the display
  double longest = 0.0;   // the longest frame
};

inline constexpr double kAveragedTime = 0.5;  // a number that changes more often can hardly be read [s]

/// Told when each part of a frame ends.
class FrameTimer {
 public:
  void begins(double now) {
    if (began_ >= 0.0) count(now - began_);
    began_ = last_ = now;
  }
  void simulated(double now) { sums_.simulate += since(now); }
  void drawn(double now) { sums_.draw += since(now); }
  void swapped(double now) { sums_.swap += since(now); }

  /// Of the frames of the last kAveragedTime that is complete, one frame at least; zeroes before it is.
  const FrameTimes& times() const { return times_; }

 private:
  double since(double now) {
    const double spent = now - last_;
    last_ = now;
    return spent;
  }
  void count(double frame) {
    sums_.frame += frame;
    sums_.longest = std::max(sums_.longest, frame);
    ++frames_;
    if (sums_.frame < kAveragedTime) return;
    for (double* sum : {&sums_.frame, &sums_.simulate, &sums_.draw, &sums_.swap}) *sum /= frames_;
    times_ = sums_;
    sums_ = {};
    frames_ = 0;
  }

  FrameTimes times_, sums_;
  double began_ = -1.0, last_ = 0.0;
  int frames_ = 0;
};

}  // namespace brittle::runtime
