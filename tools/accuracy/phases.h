// accuracy/phases.h - what a step consists of in which panes break: the time of each phase, by rounds.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/accuracy/study.h"

namespace brittle::accuracy {

struct PhaseRow {
  std::string rounds;                 // "3", "unbounded"
  std::map<std::string, double> ms;   // of each of kPhaseNames: median of the repeats
  double bodies = 0.0;                // after the step
};

/// Zones of engine/core/profile.h in the order of the step; what is left is "other".
inline constexpr const char* kPhaseNames[] = {"collide",       "limit impulses",   "solve",      "cut and connect",
                                              "swap bodies",   "collide again",    "solve again", "advance strikers",
                                              "move and rest", "other"};

/// The heaviest tick of a ball at 100 m/s that goes through six panes 5 cm apart.
std::vector<PhaseRow> measurePhases(const Effort& effort, const Advance& advance);
inline constexpr int kPhaseRows = 5;

}  // namespace brittle::accuracy
