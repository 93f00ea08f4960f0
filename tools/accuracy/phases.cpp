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

struct Tick {
  double total = 0.0;
  std::map<std::string, double> phases;
  double bodies = 0.0;
};

/// Every tick of one flight.
std::vector<Tick> fly(const physics::Accuracy& accuracy) {
  physics::WorldDef def;
  def.accuracy = accuracy;
  def.gravity = Vec3::Zero();
  physics::World world(def);
  const Stage stage = buildPanes(world, {.panes = 6, .speed = 100.0f, .phase = 0.25f});
  std::vector<Tick> ticks;
  StepZones zones;
  for (int i = 0; i < static_cast<int>(stage.seconds / kTick); ++i) {
    zones.begin();
    const double before = cpuMilliseconds();
    world.step(kTick);
    Tick& tick = ticks.emplace_back();
    tick.total = cpuMilliseconds() - before;
    double inZones = 0.0;
    for (const auto& [zone, ms] : zones.milliseconds()) {
      tick.phases[phaseOf(zone)] += ms;
      inZones += ms;
    }
    tick.phases[kOther] += std::max(tick.total - inZones, 0.0);
    tick.bodies = world.counters().bodies;
  }
  return ticks;
}

}  // namespace

std::vector<PhaseRow> measurePhases(const Effort& effort, const Advance& advance) {
  std::vector<PhaseRow> rows;
  for (const int rounds : {1, 2, 3, 5, 0}) {
    PhaseRow& row = rows.emplace_back();
    row.rounds = rounds == 0 ? "unbounded" : std::to_string(rounds);
    physics::Accuracy accuracy;
    accuracy.fractureRounds = rounds;
    std::size_t heaviest = 0;
    std::map<std::string, std::vector<double>> found;
    for (int repeat = 0; repeat < (effort.quick ? 1 : 9); ++repeat) {
      const std::vector<Tick> ticks = fly(accuracy);
      const auto isLess = [](const Tick& a, const Tick& b) { return a.total < b.total; };
      if (repeat == 0)
        heaviest = static_cast<std::size_t>(std::max_element(ticks.begin(), ticks.end(), isLess) - ticks.begin());
      for (const char* name : kPhaseNames) {
        const auto part = ticks[heaviest].phases.find(name);
        found[name].push_back(part == ticks[heaviest].phases.end() ? 0.0 : part->second);
      }
      row.bodies = ticks[heaviest].bodies;
    }
    for (const auto& [name, values] : found) row.ms[name] = quantileOf(values, 0.5);
    advance();
  }
  return rows;
}

}  // namespace brittle::accuracy
