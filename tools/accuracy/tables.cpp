#include <limits>
#include <string>

#include "tools/accuracy/csv.h"
#include "tools/accuracy/outcome.h"

namespace brittle::accuracy {
namespace {

Csv settingsOf(const Outcome& outcome) {
  Csv csv({"knob", "value", "order", "default", "front", "score", "ms_per_s", "ms_per_s_least", "ms_per_s_most",
           "median_tick_ms", "p99_tick_ms", "instructions_per_s", "room_median_ms", "room_p99_ms", "room_breaks",
           "score_low", "score_high", "beaten"});
  for (const Scored& one : outcome.scored)
    csv.row() << one.setting.knob << one.setting.value << double(one.setting.order) << double(one.setting.isDefault)
              << double(one.isFront) << one.score.value << one.cost.perSecond << one.cost.low << one.cost.high
              << one.cost.medianTick << one.cost.p99Tick << one.cost.instructions << one.cost.roomMedian
              << one.cost.roomP99 << one.cost.roomBreaks << one.score.low << one.score.high << double(one.isBeaten);
  return csv;
}

Csv figuresOf(const Outcome& outcome) {
  Csv csv({"knob", "value", "order", "scene", "figure", "unit", "error", "low", "high", "tolerance", "scene_ms_per_s"});
  for (const Scored& one : outcome.scored)
    for (std::size_t i = 0; i < one.errors.size(); ++i) {
      const Figure& figure = allFigures()[i];
      csv.row() << one.setting.knob << one.setting.value << double(one.setting.order) << std::string(figure.scene)
                << std::string(figure.name) << std::string(figure.unit) << one.errors[i].value << one.errors[i].low
                << one.errors[i].high << figure.tolerance << one.cost.scenes[sceneOf(figure)];
    }
  return csv;
}

Csv panesOf(const std::vector<PanesRow>& rows) {
  Csv csv({"how", "substeps", "panes", "speed", "phases", "exit_speed_error_percent", "mean_exit_speed_error_percent",
           "behind_cm", "late_ms", "push_Ns", "not_broken", "turned_deg", "ms_per_s", "p99_tick_ms"});
  for (const PanesRow& row : rows)
    csv.row() << row.how << double(row.substeps) << double(row.panes) << double(row.speed) << double(row.phases)
              << row.exitSpeedError << row.meanExitSpeedError << row.behind << row.late << row.push << row.notBroken
              << row.turned << row.perSecond << row.p99Tick;
  return csv;
}

Csv thresholdOf(const std::vector<ThresholdRow>& rows) {
  Csv csv({"how", "beside", "throws", "false_breaks_per_1e4", "missed_breaks_per_1e4"});
  for (const ThresholdRow& row : rows)
    csv.row() << row.how << row.beside << double(row.throws) << row.falseBreaks << row.missedBreaks;
  return csv;
}

Csv phasesOf(const std::vector<PhaseRow>& rows) {
  std::vector<std::string> columns = {"rounds", "ticks"};
  for (const char* name : kPhaseNames) columns.emplace_back(name);
  Csv csv(columns);
  for (const PhaseRow& row : rows) {
    csv.row() << row.rounds << double(row.ticks);
    for (const char* name : kPhaseNames) csv << row.ms.at(name);
  }
  return csv;
}

Csv splittersOf(const std::vector<SplitterRow>& rows) {
  Csv csv({"splitter", "cuts", "attempts", "splits", "failures", "failures_per_million", "splits_per_s",
           "worst_volume_error_m3"});
  for (const SplitterRow& row : rows)
    csv.row() << row.splitter << row.cuts << row.attempts << row.splits << row.failures << row.failuresPerMillion
              << row.splitsPerSecond << row.volumeError;
  return csv;
}

Csv floatOf(const std::vector<FloatRow>& rows) {
  Csv csv({"what", "worst_relative_error", "epsilons", "variants"});
  for (const FloatRow& row : rows)
    csv.row() << row.what << row.worst << row.worst / double(std::numeric_limits<float>::epsilon())
              << double(row.variants);
  return csv;
}

Csv budgetOf(const std::vector<BudgetRow>& rows) {
  Csv csv({"budget_ms", "setting", "score", "room_p99_ms", "ms_per_s"});
  for (const BudgetRow& row : rows) {
    if (row.best == nullptr) continue;
    csv.row() << row.budget << row.best->setting.knob + " " + row.best->setting.value << row.best->score.value
              << row.best->cost.roomP99 << row.best->cost.perSecond;
  }
  return csv;
}

}  // namespace

std::vector<BudgetRow> budgetsOf(const std::vector<Scored>& scored) {
  std::vector<BudgetRow> rows;
  for (const double budget : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    BudgetRow row{budget, nullptr};
    for (const Scored& one : scored)
      if (one.cost.roomP99 <= budget && (row.best == nullptr || one.score.value < row.best->score.value))
        row.best = &one;
    rows.push_back(row);
  }
  return rows;
}

Status writeTables(const Outcome& outcome, const std::string& folder) {
  std::vector<PanesRow> panes = outcome.modes;
  panes.insert(panes.end(), outcome.claim.begin(), outcome.claim.end());
  const std::pair<const char*, Csv> tables[] = {
      {"settings", settingsOf(outcome)},
      {"figures", figuresOf(outcome)},
      {"panes", panesOf(panes)},
      {"map", panesOf(outcome.map)},
      {"threshold", thresholdOf(outcome.thresholds)},
      {"phases", phasesOf(outcome.phases)},
      {"splitters", splittersOf(outcome.splitters)},
      {"float", floatOf(outcome.floats)},
      {"budget", budgetOf(outcome.budgets)},
  };
  for (const auto& [name, csv] : tables) {
    const Status written = csv.write(folder + "/" + name + ".csv");
    if (!written) return written;
  }
  return Done{};
}

}  // namespace brittle::accuracy
