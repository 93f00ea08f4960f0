#include "tools/accuracy/phases.h"

#include <algorithm>
#include <cstring>

#include "tools/bench/zones.h"

namespace brittle::accuracy {
namespace {

constexpr const char* kOther = "other";

/// Which phase a zone belongs to.
const char* phaseOf(const std::string& zone) {
  static const std::map<std::string, const char*> phases = {{"fracture", "cut and connect"},
                                                            {"break", "swap bodies"},
                                                            {"integrate positions", "move and rest"},
                                                            {"correct positions", "move and rest"},
                                                            {"confine", "move and rest"},
                                                            {"restitution", "move and rest"},
                                                            {"debris", "move and rest"},
                                                            {"recycle", "move and rest"},
                                                            {"deactivate", "move and rest"}};
  for (const char* name : kPhaseNames)
    if (zone == name) return name;
  const auto found = phases.find(zone);
  return found == phases.end() ? kOther : found->second;
}

/// Tells the first solve of a tick from those after a break.
class StepZones : public ZoneTimes {
 public:
  void zoneBegins(const char* name) override {
    const bool isSolve = std::strcmp(name, "solve") == 0;
    ZoneTimes::zoneBegins(isSolve && solves_++ > 0 ? "solve again" : name);
  }
  void begin() {
    clear();
    solves_ = 0;
  }

 private:
  int solves_ = 0;
};

struct Flight {
  std::map<std::string, double> ms;
  int ticks = 0;
};

/// The ticks of one flight that break something.
Flight fly(const physics::Accuracy& accuracy) {
  physics::WorldDef def;
  def.accuracy = accuracy;
  def.gravity = Vec3::Zero();
  physics::World world(def);
  const Stage stage = buildPanes(world, {.panes = 6, .speed = 100.0f, .phase = 0.25f});
  Flight flight;
  StepZones zones;
  for (int i = 0; i < static_cast<int>(stage.seconds / kTick); ++i) {
    zones.begin();
    const double before = cpuMilliseconds();
    world.step(kTick);
    const double total = cpuMilliseconds() - before;
    if (world.counters().breaks == 0) continue;
    ++flight.ticks;
    double inZones = 0.0;
    for (const auto& [zone, ms] : zones.milliseconds()) {
      flight.ms[phaseOf(zone)] += ms;
      inZones += ms;
    }
    flight.ms[kOther] += std::max(total - inZones, 0.0);
  }
  return flight;
}

}  // namespace

std::vector<PhaseRow> measurePhases(const Effort& effort, const Advance& advance) {
  std::vector<PhaseRow> rows;
  for (const Setting& setting : knobSettings(true)) {
    if (setting.knob != "fracture" || setting.accuracy.fractureMode != physics::FractureMode::InStep) continue;
    PhaseRow& row = rows.emplace_back();
    row.rounds = setting.value;
    std::map<std::string, std::vector<double>> found;
    for (int repeat = 0; repeat < (effort.quick ? 1 : 9); ++repeat) {
      Flight flight = fly(setting.accuracy);
      for (const char* name : kPhaseNames) found[name].push_back(flight.ms[name]);
      row.ticks = flight.ticks;
    }
    for (const auto& [name, values] : found) row.ms[name] = quantileOf(values, 0.5);
    advance();
  }
  return rows;
}

}  // namespace brittle::accuracy
