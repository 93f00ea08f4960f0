// panels/phases.h - what the phases of a tick cost, as bars.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "tools/bench/zones.h"

namespace brittle::panels {

/// Measures from its construction on; the shown values follow slowly, so that they can be read.
class Phases {
 public:
  /// Around each tick.
  void tickBegins() { times_.clear(); }
  void tickEnds();
  /// Between Gui::begin and end.
  void show();

 private:
  static constexpr std::size_t kRemembered = 240;  // [ticks]

  ZoneTimes times_;
  std::map<std::string, double> shown_;  // by zone [ms]
  float totals_[kRemembered] = {};       // of the last ticks, a ring [ms]
  std::size_t next_ = 0;
};

}  // namespace brittle::panels
