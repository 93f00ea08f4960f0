// accuracy [--quick] [--instructions] [--out DIR]: what each step of accuracy buys, and what it costs: tables, a report
// and plots.
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <system_error>

#include "engine/core/file.h"
#include "tools/accuracy/csv.h"
#include "tools/accuracy/instructions.h"
#include "tools/accuracy/outcome.h"
#include "tools/bench/cpu_time.h"
#include "tools/brittle/arguments.h"
#include "tools/brittle/progress.h"
#include "tools/callgrind/callgrind.h"

namespace {

using namespace brittle;
using namespace brittle::accuracy;

struct Options {
  bool quick = false, instructions = false, noPlots = false, onlyPlots = false;
  std::string out = "build/accuracy";
  std::string scene, setting = "balanced";
  int variant = 0;
};

int refuse(const Error& error) {
  return program::refuse("accuracy", error);
}

std::vector<Setting> allSettings(bool quick) {
  std::vector<Setting> settings = knobSettings(quick);
  for (const std::vector<Setting>& more : {gridSettings(quick), presetSettings()})
    settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

Result<Outcome> measure(const Options& options) {
  const Effort effort{options.quick};
  const double start = cpuMilliseconds();
  const std::vector<Setting> settings = allSettings(options.quick);
  const auto room = Room::record(BRITTLE_SOURCE_DIR "/assets", effort.roomTicks());
  if (!room) return room.error();
  Outcome outcome;
  outcome.quick = options.quick;
  outcome.modes = modeRows(effort);
  outcome.claim = claimRows(effort);
  outcome.map = mapRows(effort);
  outcome.thresholds = thresholdRows(effort);
  const int scenes = static_cast<int>(allScenes().size());
  const int steps = stepsOf(settings, effort) + 3 * scenes + phasesOf(outcome.modes) + phasesOf(outcome.claim) +
                    phasesOf(outcome.map) + static_cast<int>(outcome.thresholds.size()) + kPhaseRows + kSplitterRows +
                    kFloatRows + static_cast<int>(options.instructions ? settings.size() : 0);
  program::Progress progress("measuring", static_cast<std::uint32_t>(steps));
  std::uint32_t done = 0;
  const Advance advance = [&] { progress.reached(++done); };

  outcome.splitters = compareSplitters(effort, advance);
  outcome.phases = measurePhases(effort, advance);
  for (std::vector<PanesRow>* rows : {&outcome.modes, &outcome.claim, &outcome.map}) playRows(*rows, advance);
  outcome.floats = measureFloat(effort, advance);
  playThreshold(outcome.thresholds, advance);
  const Reference reference = playAll(referenceAccuracy(options.quick ? 4 : 1), effort, advance);
  for (const int fineness : options.quick ? std::vector<int>{} : std::vector<int>{4, 2})
    outcome.convergence.push_back(
        {fineness, errorsOf(playAll(referenceAccuracy(fineness), effort, advance), reference)});
  Result<std::vector<Scored>> scored = study(settings, reference, **room, effort, advance);
  if (!scored) return scored.error();
  outcome.scored = std::move(*scored);
  outcome.countsInstructions = options.instructions;
  if (options.instructions)
    if (const Status counted = countInstructions(outcome.scored, advance); !counted) return counted.error();
  outcome.minutes = (cpuMilliseconds() - start) / 60'000.0;
  return outcome;
}

Status prepare(const Options& options) {
  if (!options.noPlots)
    if (const Status there = checkPlotting(); !there) return there;
  if (options.instructions)
    if (const Status there = callgrind::checkCounting(); !there) return there;
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) return Error{"--out " + options.out + ": cannot be made: " + problem.message()};
  return checkWritable(options.out + "/report.md");
}

int run(const Options& options) {
  if (const Status prepared = prepare(options); !prepared) return refuse(prepared.error());
  if (!options.onlyPlots) {
    Result<Outcome> outcome = measure(options);
    if (!outcome) return refuse(outcome.error());
    outcome->budgets = budgetsOf(outcome->scored);
    for (const Status& written : {writeTables(*outcome, options.out), writeReport(*outcome, options.out)})
      if (!written) return refuse(written.error());
  }
  if (!options.noPlots)
    if (const Status drawn = drawPlots(options.out); !drawn) return refuse(drawn.error());
  std::printf("%s/report.md\n", options.out.c_str());
  return 0;
}

Result<physics::Accuracy> accuracyNamed(const std::string& name) {
  std::string names;
  for (const Setting& setting : allSettings(false)) {
    if (nameOf(setting) == name) return setting.accuracy;
    if (setting.knob == "preset") names += " " + setting.value;
  }
  return Error{"--accuracy " + name + ": expected one of" + names + ", or a knob and its value, as 'iterations 16'"};
}

Result<const Scene*> sceneNamed(const std::string& name) {
  if (const Scene* scene = findScene(name)) return scene;
  std::string names;
  for (const Scene& one : allScenes()) names += " " + std::string(one.name);
  return Error{"--scene " + name + ": expected one of" + names};
}

/// One scene once: for a profiler, and for countInstructions.
int playOne(const Options& options) {
  const Result<const Scene*> scene = sceneNamed(options.scene);
  if (!scene) return refuse(scene.error());
  const Result<physics::Accuracy> accuracy = accuracyNamed(options.setting);
  if (!accuracy) return refuse(accuracy.error());
  const Observation seen = observe(**scene, *accuracy, options.variant);
  double spent = 0.0;
  for (const double ms : seen.tickMs) spent += ms;
  std::printf("%s, %s: %zu ticks, %.2f ms, state %016llx\n", options.scene.c_str(), options.setting.c_str(),
              seen.tickMs.size(), spent, static_cast<unsigned long long>(seen.hash));
  for (std::size_t i = 0; i < allFigures().size(); ++i)
    if (const Figure& figure = allFigures()[i]; figure.scene == options.scene && figure.of != nullptr)
      std::printf("  %s %s %s\n", std::string(figure.name).c_str(), shortly(figure.of(seen)).c_str(),
                  std::string(figure.unit).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures what each step of accuracy buys and what it costs.", "accuracy");
  Options options;
  app.add_flag("--quick", options.quick, "a few settings, enough to see the directions: well under a minute");
  app.add_option("--out", options.out, "folder for tables (CSV), report.md and plots (SVG, PNG)")
      ->capture_default_str()
      ->type_name("DIR");
  app.add_flag("--instructions", options.instructions,
               "count instructions as well, under callgrind: a few minutes more, needs valgrind");
  auto* noPlots = app.add_flag("--no-plots", options.noPlots, "tables and report alone: needs no gnuplot");
  app.add_flag("--only-plots", options.onlyPlots, "draw the plots again from the tables in DIR")->excludes(noPlots);
  app.add_option("--scene", options.scene, "play one scene once and measure nothing else, for a profiler")
      ->type_name("NAME");
  app.add_option("--accuracy", options.setting,
                 "for --scene: a preset, or a knob and its value as the tables have them")
      ->capture_default_str()
      ->type_name("SETTING");
  app.add_option("--variant", options.variant, "start phase or seed for --scene")
      ->capture_default_str()
      ->check(CLI::Range(0, 255));
  app.footer(
      "Examples:\n  accuracy --quick --out build/accuracy\n  accuracy --instructions --out tools/accuracy/measured\n"
      "  accuracy --scene shatter --accuracy 'iterations 16'\n"
      "  valgrind --tool=callgrind --toggle-collect='brittle::physics::World::step(float)' accuracy --scene shatter");
  if (const auto ended = program::readArguments(app, argc, argv)) return *ended;
  return options.scene.empty() ? run(options) : playOne(options);
}
