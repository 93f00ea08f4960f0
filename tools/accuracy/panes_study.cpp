#include "tools/accuracy/panes_study.h"

#include <algorithm>

namespace brittle::accuracy {
namespace {

constexpr int kTestedPhases = 64;

bool getsThrough(int panes, float speed) {
  return exitSpeedOf({.panes = panes, .speed = speed}) > 0.0;
}

void addRow(std::vector<PanesRow>& rows, const Setting& setting, int panes, float speed, int phases) {
  if (!getsThrough(panes, speed)) return;
  PanesRow row;
  row.how = setting.value;
  row.accuracy = setting.accuracy;
  row.substeps = setting.accuracy.substeps;
  row.panes = panes;
  row.speed = speed;
  row.phases = phases;
  rows.push_back(row);
}

struct Tally {
  double sum = 0.0, spent = 0.0, seconds = 0.0;
  std::vector<double> ticks;
};

void playPhase(PanesRow& row, int phase, Tally& tally) {
  const PanesDef def{
      .panes = row.panes, .speed = row.speed, .phase = static_cast<float>(phase) / static_cast<float>(row.phases)};
  const Observation seen = observePanes(def, row.accuracy);
  const double exact = exitSpeedOf(def);
  const double error = 100.0 * seen.missedAtEnd[0] / exact;
  row.exitSpeedError = std::max(row.exitSpeedError, error);
  row.behind = std::max(row.behind, 100.0 * seen.missedAtEnd[1]);
  row.late = std::max(row.late, 1000.0 * seen.missedAtEnd[1] / exact);
  row.push = phase == 0 ? seen.push : std::min(row.push, seen.push);
  row.notBroken = std::max(row.notBroken, row.panes - seen.broken);
  row.turned = std::max(row.turned, seen.turned);
  tally.sum += error;
  for (const double ms : seen.tickMs) tally.spent += ms;
  tally.seconds += static_cast<double>(kTick) * static_cast<double>(seen.tickMs.size());
  tally.ticks.insert(tally.ticks.end(), seen.tickMs.begin(), seen.tickMs.end());
}

}  // namespace

std::vector<PanesRow> modeRows(const Effort& effort) {
  std::vector<PanesRow> rows;
  const std::vector<int> counts = effort.quick ? std::vector<int>{1, 6} : std::vector<int>{1, 6, 16};
  for (const Setting& setting : fractureModes())
    for (const int panes : counts)
      for (const float speed : kSpeeds) {
        if (effort.quick && speed != 20.0f && speed != 100.0f) continue;
        addRow(rows, setting, panes, speed, effort.quick || panes > 6 ? 4 : 8);
      }
  return rows;
}

std::vector<PanesRow> claimRows(const Effort& effort) {
  std::vector<PanesRow> rows;
  const Setting setting{"fracture", "default", 0, true, {}};
  const std::vector<int> counts = effort.quick ? std::vector<int>{3} : std::vector<int>{1, 3, 6, 16};
  for (const int panes : counts)
    for (const float speed : kSpeeds) addRow(rows, setting, panes, speed, effort.quick ? 8 : kTestedPhases);
  return rows;
}

std::vector<PanesRow> mapRows(const Effort& effort) {
  std::vector<PanesRow> rows;
  for (Setting setting : fractureModes()) {
    if (setting.accuracy.fractureMode != physics::FractureMode::InStep) continue;
    for (const int substeps : {1, 2, 4, 8}) {
      if (effort.quick && substeps > 2) continue;
      setting.accuracy.substeps = substeps;
      addRow(rows, setting, 6, 100.0f, effort.quick ? 4 : 8);
    }
  }
  return rows;
}

void playRows(std::vector<PanesRow>& rows, const Advance& advance) {
  std::vector<Tally> tallies(rows.size());
  for (int phase = 0; phase < phasesOf(rows); ++phase) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (phase < rows[i].phases) playPhase(rows[i], phase, tallies[i]);
    advance();
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].meanExitSpeedError = tallies[i].sum / rows[i].phases;
    rows[i].perSecond = tallies[i].spent / tallies[i].seconds;
    rows[i].p99Tick = quantileOf(tallies[i].ticks, 0.99);
  }
}

int phasesOf(const std::vector<PanesRow>& rows) {
  int most = 0;
  for (const PanesRow& row : rows) most = std::max(most, row.phases);
  return most;
}

}  // namespace brittle::accuracy
