// accuracy/outcome.h - all that a run of the study has found, and the files it becomes: tables, a report, plots.
#pragma once

#include <string>
#include <vector>

#include "engine/core/result.h"
#include "tools/accuracy/float_study.h"
#include "tools/accuracy/panes_study.h"
#include "tools/accuracy/phases.h"
#include "tools/accuracy/splitters.h"
#include "tools/accuracy/threshold_study.h"

namespace brittle::accuracy {

/// The reference with sub-steps 4 and 2 times as long, against itself.
struct Convergence {
  int fineness = 1;
  std::vector<Deviation> errors;
};

/// What a tick may take, and the best that can be had for it.
struct BudgetRow {
  double budget = 0.0;           // [ms]
  const Scored* best = nullptr;  // null: nothing is that cheap
};

struct Outcome {
  bool quick = false, countsInstructions = false;
  std::vector<Scored> scored;  // knobs, grid, presets
  std::vector<Convergence> convergence;
  std::vector<PanesRow> modes, claim, map;
  std::vector<ThresholdRow> thresholds;
  std::vector<PhaseRow> phases;
  std::vector<SplitterRow> splitters;
  std::vector<FloatRow> floats;
  std::vector<BudgetRow> budgets;
  double minutes = 0.0;  // of processor time
};

/// For 0.5, 1, 2, 4 and 8 ms a tick: 99 of 100 ticks of the room keep it.
std::vector<BudgetRow> budgetsOf(const std::vector<Scored>& scored);

/// figures.csv, settings.csv, panes.csv, map.csv, threshold.csv, phases.csv, splitters.csv, float.csv and budget.csv in
/// `folder`.
Status writeTables(const Outcome& outcome, const std::string& folder);
/// report.md, which shows the plots.
Status writeReport(const Outcome& outcome, const std::string& folder);
/// Draws every plot of tools/accuracy/plots from the tables in `folder`, as SVG and as PNG.
Status drawPlots(const std::string& folder);
/// Whether gnuplot is there: one line that names its package if not.
Status checkPlotting();

}  // namespace brittle::accuracy
