// runtime/fixed_step.h - turns elapsed time into whole ticks of 1/60 s and a rest to interpolate by. Sees durations
// only, never a clock.
#pragma once

namespace brittle::runtime {

inline constexpr double kTickSeconds = 1.0 / 60.0;
/// Ticks made up for at most in one frame. Beyond it time is dropped: a slow machine plays slower instead of falling
/// ever further behind.
inline constexpr int kMostTicksPerFrame = 4;

class FixedStep {
 public:
  /// Ticks that are due `elapsed` [s] after the last call, in [0, kMostTicksPerFrame]. Negative time counts as none.
  int advance(double elapsed) {
    if (elapsed > 0.0) rest_ += elapsed;
    // A frame of exactly one tick must give one, whatever the sum of the rounding errors: a thousandth of a tick comes
    // early.
    constexpr double slack = 1e-3 * kTickSeconds;
    int ticks = 0;
    while (rest_ >= kTickSeconds - slack && ticks < kMostTicksPerFrame) {
      rest_ -= kTickSeconds;
      ++ticks;
    }
    if (rest_ > kTickSeconds) rest_ = 0.0;
    return ticks;
  }

  /// How far the picture lies between the last two ticks: 0 the one before, 1 the last. [-]
  float alpha() const { return rest_ <= 0.0 ? 0.0f : static_cast<float>(rest_ / kTickSeconds); }

 private:
  double rest_ = 0.0;
};

}  // namespace brittle::runtime
