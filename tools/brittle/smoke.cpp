#include "game/sim/smoke.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/replay/recorder.h"
#include "engine/replay/replay_file.h"
#include "tools/brittle/game.h"

namespace brittle::program {
namespace {

Result<std::string> readText(const std::string& path) {
  std::error_code problem;
  if (!std::filesystem::is_regular_file(path, problem))
    return errorAt(path, 0, "no such file, expected a smoke script (.lua)");
  std::ifstream in(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in) return errorAt(path, 0, "cannot be read");
  return text;
}

/// Plays the script's inputs once more, recording.
Status record(const content::AssetSource& assets, const sim::SmokeResult& result, const std::string& path) {
  const auto simulation = openGame(assets, result.def);
  if (!simulation) return simulation.error();
  replay::Recorder recorder(startOf((*simulation)->game()));
  for (const replay::InputFrame& input : result.inputs) {
    (*simulation)->tick(input);
    recorder.record(input, **simulation);
  }
  return replay::save(recorder.replay(), path);
}

int playOne(const content::AssetSource& assets, const std::string& path, const std::string& recordTo) {
  const Result<std::string> source = readText(path);
  if (!source) return refuse(source.error());
  const sim::SmokeResult result = sim::runSmoke(assets, path, *source);
  for (const std::string& problem : result.problems) std::printf("  content: %s\n", problem.c_str());
  for (const sim::SmokeFailure& failure : result.failures)
    std::printf("  FAILED at tick %llu: %s\n", static_cast<unsigned long long>(failure.tick), failure.text.c_str());
  std::printf("%s: %u checks, %zu failed, %llu ticks, state %016llx\n", path.c_str(), result.checks,
              result.failures.size(), static_cast<unsigned long long>(result.ticks),
              static_cast<unsigned long long>(result.stateHash));
  if (!recordTo.empty() && !result.inputs.empty()) {
    const Status written = record(assets, result, recordTo);
    if (!written) return refuse(written.error());
  }
  return result.passed() ? kDone : kFailed;
}

}  // namespace

int smoke(const SmokeOptions& options) {
  if (!options.record.empty() && options.scripts.size() != 1)
    return refuse({"--record: one script at a time, expected SCRIPT --record FILE"});
  const auto assets = openAssets(options.assets);
  if (!assets) return refuse(assets.error());
  int worst = kDone;
  for (const std::string& script : options.scripts) worst = std::max(worst, playOne(**assets, script, options.record));
  return worst;
}

}  // namespace brittle::program
