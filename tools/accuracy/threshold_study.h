// accuracy/threshold_study.h - how sharp the edge is between what a pane bears and what breaks it: balls that come with
// a little less or a little more momentum than its strength, and how many of them get the wrong answer.
#pragma once

#include <string>
#include <vector>

#include "tools/accuracy/study.h"

namespace brittle::accuracy {

struct ThresholdRow {
  std::string how;      // "3" rounds, "after capped", "4 iterations", "8 sub-steps", ...
  double beside = 0.0;  // balls come with J / (1 + beside) and with J (1 + beside) [-]
  int throws = 0;       // of either kind
  physics::Accuracy accuracy;
  double falseBreaks = 0.0;   // broke, though hit by less than J [per 1e4]
  double missedBreaks = 0.0;  // held, though hit by more [per 1e4]
};

/// Every fracture mode, and the default with fewer iterations and with sub-steps, from far off the edge to 1e-6 beside
/// it.
std::vector<ThresholdRow> thresholdRows(const Effort& effort);
/// Throws balls of many masses, at many places and moments, that bounce or do not. Calls advance once a row.
void playThreshold(std::vector<ThresholdRow>& rows, const Advance& advance);

}  // namespace brittle::accuracy
