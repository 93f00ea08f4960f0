// runtime/pace.h - one frame per refresh of the display where nothing else holds frames back (a driver without vertical
// sync). Sees moments only, never a clock.
#pragma once

namespace brittle::runtime {

class Pace {
 public:
  /// `period`: from one refresh to the next [s].
  void setPeriod(double period) { period_ = period; }

  /// How long to wait after a picture was shown at `now` [s]. Nothing where the display did hold it back, or where the
  /// frame took as long anyway.
  double rest(double now) {
    constexpr double held = 0.9;  // of a period: refresh rates are told as whole numbers, and waking up jitters
    if (now - shown_ >= held * period_) {
      shown_ = now;
      return 0.0;
    }
    shown_ += period_;  // not now + rest: oversleeping must not add up
    return shown_ - now;
  }

 private:
  double period_ = 1.0 / 60.0;
  double shown_ = -1.0;
};

}  // namespace brittle::runtime
