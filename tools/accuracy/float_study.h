// accuracy/float_study.h - what single precision costs: results that are known exactly in double precision, where
// nothing but the rounding of floats is left of the error.
#pragma once

#include <string>
#include <vector>

#include "tools/accuracy/study.h"

namespace brittle::accuracy {

struct FloatRow {
  std::string what;    // "exit speed behind six panes, of the speed"
  double worst = 0.0;  // relative error, in the worst of the variants [-]
  int variants = 0;
};

/// At the default accuracy: motion and rest, with and without breaking. Calls advance once a row.
std::vector<FloatRow> measureFloat(const Effort& effort, const Advance& advance);
inline constexpr int kFloatRows = 5;

}  // namespace brittle::accuracy
