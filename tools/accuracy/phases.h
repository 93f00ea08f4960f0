// accuracy/phases.h - what steps consist of in which panes break: the time of each phase, by rounds.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/accuracy/study.h"

namespace brittle::accuracy {

struct PhaseRow {
  std::string rounds;                // "3", "unbounded"
  std::map<std::string, double> ms;  // of each of kPhaseNames, in all ticks that break: median of the repeats
  int ticks = 0;                     // that break something
};

/// Zones of engine/core/profile.h in the order of the step; what is left is "other".
inline constexpr const char* kPhaseNames[] = {"collide",       "limit impulses", "solve",       "cut and connect",
                                              "swap bodies",   "collide again",  "solve again", "advance strikers",
                                              "move and rest", "other"};

/// The ticks in which a ball at 100 m/s breaks six panes 5 cm apart: the fewer rounds, the more of them.
std::vector<PhaseRow> measurePhases(const Effort& effort, const Advance& advance);
inline constexpr int kPhaseRows = 6;

}  // namespace brittle::accuracy
