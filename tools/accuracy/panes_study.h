// accuracy/panes_study.h - a ball through N panes, by speed, rounds and sub-steps: how far its exit speed is off, how
// late it comes, how much its shards are pushed, in the worst of many phases of the gap within a tick.
#pragma once

#include <string>
#include <vector>

#include "tools/accuracy/study.h"

namespace brittle::accuracy {

struct PanesRow {
  std::string how;  // "3" rounds, "3 to 8" where something is fast, "unbounded", "after capped", ...
  int substeps = 1;
  int panes = 6;
  float speed = 20.0f;  // [m/s]
  int phases = 0;       // tried
  physics::Accuracy accuracy;
  // In the worst phase.
  double exitSpeedError = 0.0;  // [%]
  double behind = 0.0;          // where it should be, at the end [cm]
  double late = 0.0;            // the same by its exit speed [ms]
  double push = 0.0;            // momentum along its way that the shards took, least [N s]
  double notBroken = 0.0;       // panes
  double turned = 0.0;          // [deg]
  // Of all.
  double meanExitSpeedError = 0.0;  // [%]
  double perSecond = 0.0;           // [ms/s]
  double p99Tick = 0.0;             // [ms]
};

/// Speeds from 5 to 200 m/s, as far as the ball gets through.
inline constexpr float kSpeeds[] = {5.0f, 10.0f, 20.0f, 50.0f, 100.0f, 200.0f};

/// Every fracture mode at every speed; 6 panes, in full 1 and 16 as well.
std::vector<PanesRow> modeRows(const Effort& effort);
/// The default alone: all speeds, up to 16 panes, 64 phases.
std::vector<PanesRow> claimRows(const Effort& effort);
/// Rounds by sub-steps for a ball at 100 m/s.
std::vector<PanesRow> mapRows(const Effort& effort);

/// Fills in the rows; phases in turns, so that all rows are measured alike. Calls advance once a phase.
void playRows(std::vector<PanesRow>& rows, const Advance& advance);
int phasesOf(const std::vector<PanesRow>& rows);

}  // namespace brittle::accuracy
