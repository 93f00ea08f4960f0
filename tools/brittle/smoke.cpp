#include "game/sim/smoke.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include "engine/core/file.h"
#include "engine/replay/recorder.h"
#include "engine/replay/replay_file.h"
#include "tools/brittle/game.h"
#include "tools/brittle/interrupt.h"
#include "tools/brittle/omissions.h"

namespace brittle::program {
namespace {

constexpr std::size_t kLongestScript = 1u << 20;  // [bytes]

/// Plays the script's inputs once more, recording.
Status record(const content::AssetSource& assets, const sim::SmokeResult& result, const std::string& path) {
  const auto simulation = openGame(assets, result.def);
  if (!simulation) return simulation.error();
  replay::Recorder recorder(startOf((*simulation)->game()));
  for (const replay::InputFrame& input : result.inputs) {
    if (isInterrupted()) return interruption();
    (*simulation)->tick(input);
    recorder.record(input, **simulation);
  }
  return replay::save(recorder.replay(), path);
}

void print(const std::string& path, const sim::SmokeResult& result) {
  for (const std::string& problem : result.problems) std::printf("  content: %s\n", problem.c_str());
  for (const sim::SmokeFailure& failure : result.failures)
    std::printf("  FAILED at tick %llu: %s\n", static_cast<unsigned long long>(failure.tick), failure.text.c_str());
  std::printf("%s: %u checks, %zu failed, %llu ticks, state %016llx\n", path.c_str(), result.checks,
              result.failures.size(), static_cast<unsigned long long>(result.ticks),
              static_cast<unsigned long long>(result.stateHash));
  if (!result.omissions.empty()) std::printf("  left out: %s\n", inWords(result.omissions).c_str());
}

/// How many balls were left in each of several games: median, fewest, most.
void printBalls(const std::string& path, std::vector<int> balls, int checkpoints) {
  std::sort(balls.begin(), balls.end());
  std::printf("%s: %zu seeds, balls left: median %d, min %d, max %d; %d at the checkpoint\n", path.c_str(),
              balls.size(), balls[balls.size() / 2], balls.front(), balls.back(), checkpoints);
}

/// What became of all scripts.
struct Outcome {
  int worst = kDone;
  std::set<std::string> asked;  // settings that some script wanted to know
  sim::SmokeResult last;
};

void playSeeds(const content::AssetSource& assets, const std::string& path, const std::string& source,
               sim::SmokeSettings settings, std::uint32_t seeds, Outcome& outcome) {
  std::vector<int> balls;
  int checkpoints = 0;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    settings.seed = seed;
    const sim::SmokeResult result = sim::runSmoke(assets, path, source, settings);
    if (isInterrupted()) return;
    outcome.asked.insert(result.asked.begin(), result.asked.end());
    print(path, result);
    std::printf("  seed %u: %s in room %d at %d m with %d balls\n", seed, nameOf(result.hud.phase), result.hud.room,
                static_cast<int>(result.hud.distance), result.hud.balls);
    balls.push_back(result.hud.balls);
    if (result.hud.phase == sim::Phase::Checkpoint) ++checkpoints;
    if (!result.passed()) outcome.worst = std::max(outcome.worst, kFailed);
  }
  printBalls(path, balls, checkpoints);
}

void playOne(const content::AssetSource& assets, const std::string& path, const SmokeOptions& options,
             const sim::SmokeSettings& settings, Outcome& outcome) {
  const Result<std::string> source = readFile(path, kLongestScript, "a smoke script (.lua)");
  if (!source) {
    outcome.worst = refuse(source.error());
    return;
  }
  if (options.seeds > 0) return playSeeds(assets, path, *source, settings, options.seeds, outcome);
  outcome.last = sim::runSmoke(assets, path, *source, settings);
  if (isInterrupted()) return;
  outcome.asked.insert(outcome.last.asked.begin(), outcome.last.asked.end());
  print(path, outcome.last);
  if (!outcome.last.passed()) outcome.worst = std::max(outcome.worst, kFailed);
}

Result<sim::SmokeSettings> settingsOf(const SmokeOptions& options) {
  sim::SmokeSettings settings;
  settings.isCalledOff = isInterrupted;
  const Result<physics::Accuracy> accuracy = accuracyOf(options.accuracy);
  if (!accuracy) return accuracy.error();
  settings.accuracy = *accuracy;
  const Result<effects::EffectMask> without = effectsOf(options.without);
  if (!without) return without.error();
  settings.without = *without;
  for (const std::string& setting : options.settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) return Error{"--set " + setting + ": expected NAME=TEXT"};
    settings.values[setting.substr(0, equals)] = setting.substr(equals + 1);
  }
  return settings;
}

/// A setting that no script wanted to know is misspelled.
Status checkAsked(const sim::SmokeSettings& settings, const std::set<std::string>& asked) {
  std::string names;
  for (const std::string& name : asked) names += (names.empty() ? "" : ", ") + name;
  for (const auto& [name, text] : settings.values)
    if (!asked.contains(name))
      return Error{"--set " + name + "=" + text + ": no script asks for it, expected " +
                   (names.empty() ? "none" : names)};
  return Done{};
}

}  // namespace

int smoke(const SmokeOptions& options) {
  if (!options.record.empty() && (options.scripts.size() != 1 || options.seeds > 0))
    return refuse({"--record: one game at a time, expected SCRIPT --record FILE"});
  const Status writable = options.record.empty() ? Status(Done{}) : checkWritable(options.record);
  if (!writable) return refuse(writable.error());
  const auto assets = openAssets(options.assets);
  if (!assets) return refuse(assets.error());
  const Result<sim::SmokeSettings> settings = settingsOf(options);
  if (!settings) return refuse(settings.error());
  catchInterrupts();
  Outcome outcome;
  for (std::size_t i = 0; i < options.scripts.size() && !isInterrupted(); ++i)
    playOne(**assets, options.scripts[i], options, *settings, outcome);
  if (isInterrupted()) return refuse(interruption());
  const Status known = outcome.worst == kWrongInput ? Status(Done{}) : checkAsked(*settings, outcome.asked);
  if (!known) return refuse(known.error());
  if (options.record.empty() || outcome.last.inputs.empty()) return outcome.worst;
  const Status written = record(**assets, outcome.last, options.record);
  return written ? outcome.worst : refuse(written.error());
}

}  // namespace brittle::program
