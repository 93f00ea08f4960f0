#include "tools/brittle/game.h"

#include <array>
#include <cstdio>
#include <utility>

#include "engine/core/archive.h"
#include "engine/replay/replay_file.h"
#include "game/content/number.h"
#include "game/sim/constants.h"

namespace brittle::program {
namespace {

constexpr std::array<std::pair<const char*, sim::Mode>, 4> kModes = {{{"training", sim::Mode::Training},
                                                                      {"classic", sim::Mode::Classic},
                                                                      {"mayhem", sim::Mode::Mayhem},
                                                                      {"zen", sim::Mode::Zen}}};

/// What a replay stores beside level, seed and mode.
template <class Archive>
void serializeSettings(Archive& archive, sim::GameDef& def) {
  archive(def.firstRoom);
  archive(def.startOffset);
  archive(def.accuracy);
  archive(def.balls);
  archive(def.streak);
  archive(def.distance);
  archive(def.title);
  std::uint32_t without = def.without.bits();
  archive(without);
  def.without = effects::EffectMask::ofBits(without);
}

bool isWithin(float value, float low, float high) {
  return value >= low && value <= high;
}

/// Whether a game can be played with these settings.
bool isPlayable(const sim::GameDef& def) {
  constexpr std::int64_t farthest = std::int64_t{1} << 40;  // [2^-8 m]
  return physics::isWithinRange(def.accuracy) && def.startOffset >= -farthest && def.startOffset <= farthest &&
         def.balls >= 0 && def.balls <= sim::rules::kBallCap && def.streak >= 0 && def.streak <= 1'000'000 &&
         isWithin(def.distance, 0.0f, 1e9f);
}

std::vector<unsigned char> settingsOf(sim::GameDef def) {
  ByteWriter out;
  SaveArchive archive(out);
  serializeSettings(archive, def);
  return out.bytes();
}

std::string hex(std::uint64_t value) {
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

Result<sim::GameDef> defOf(const replay::Start& start, const std::string& name) {
  sim::GameDef def;
  def.level = start.level;
  def.seed = start.seed;
  def.mode = static_cast<sim::Mode>(start.mode);
  ByteReader in(start.settings);
  RestoreArchive archive(in);
  serializeSettings(archive, def);
  const bool isRead = in.ok() && in.remaining() == 0 && start.mode <= static_cast<std::uint32_t>(sim::Mode::Coop);
  if (!isRead || !isPlayable(def)) return errorAt(name, 0, "its game settings cannot be read");
  return def;
}

}  // namespace

Result<sim::GameDef> defOf(const GameOptions& options) {
  sim::GameDef def;
  def.level = options.level;
  def.seed = options.seed;
  def.firstRoom = options.room;
  const Result<physics::Accuracy> accuracy = accuracyOf(options.accuracy);
  if (!accuracy) return accuracy.error();
  def.accuracy = *accuracy;
  const Result<effects::EffectMask> without = effectsOf(options.without);
  if (!without) return without.error();
  def.without = *without;
  for (const auto& [name, mode] : kModes)
    if (options.mode == name) {
      def.mode = mode;
      return def;
    }
  return Error{"--mode " + options.mode + ": expected training, classic, mayhem or zen"};
}

Result<physics::Accuracy> accuracyOf(const std::string& preset) {
  if (const auto accuracy = physics::preset(preset)) return *accuracy;
  std::string names;
  for (const std::string_view name : physics::presetNames())
    names += (names.empty() ? "" : name == physics::presetNames().back() ? " or " : ", ") + std::string(name);
  return Error{"--accuracy " + preset + ": expected " + names};
}

Result<effects::EffectMask> effectsOf(const std::string& names) {
  effects::EffectMask mask;
  for (std::size_t begin = 0; !names.empty() && begin <= names.size();) {
    const std::size_t end = minOf(names.find(',', begin), names.size());
    const std::string name(content::trimmed(std::string_view(names).substr(begin, end - begin)));
    const auto effect = effects::effectNamed(name);
    if (!effect) return Error{"--without " + names + ": no effect '" + name + "' (brittle play --help lists them)"};
    mask = mask.with(*effect);
    begin = end + 1;
  }
  return mask;
}

Result<std::unique_ptr<GameSimulation>> openGame(const content::AssetSource& assets, const sim::GameDef& def) {
  Result<std::unique_ptr<sim::Game>> game = sim::Game::create(assets, def);
  if (!game) return game.error();
  return std::make_unique<GameSimulation>(std::move(*game));
}

replay::Start startOf(const sim::Game& game) {
  const sim::GameDef& def = game.def();
  replay::Start start;
  start.simulationVersion = sim::rules::kSimulationVersion;
  start.contentHash = game.contentHash();
  start.seed = def.seed;
  start.mode = static_cast<std::uint32_t>(def.mode);
  start.level = def.level;
  sim::GameDef kept = def;  // what is only seen or heard is up to who plays it again
  kept.without = kept.without.both(effects::maskOf(effects::Kind::Physical));
  start.settings = settingsOf(kept);
  return start;
}

Result<replay::Replay> loadReplay(const std::string& path) {
  Result<replay::Replay> replay = replay::load(path, sim::rules::kSimulationVersion);
  if (replay && replay->ticks() == 0)
    return errorAt(path, 0, "an empty replay: it has no ticks, expected at least one");
  return replay;
}

Result<std::unique_ptr<GameSimulation>> openReplay(const content::AssetSource& assets, const replay::Replay& replay,
                                                   const std::string& name) {
  const Result<sim::GameDef> def = defOf(replay.start, name);
  if (!def) return def.error();
  Result<std::unique_ptr<GameSimulation>> simulation = openGame(assets, *def);
  if (!simulation) return errorAt(name, 0, simulation.error().message);
  const std::uint64_t here = (*simulation)->game().contentHash();
  if (here != replay.start.contentHash)
    return errorAt(name, 0,
                   "recorded with other content: " + hex(replay.start.contentHash) + ", the files here are " +
                       hex(here) + "; play it with the files it was recorded with (--assets DIR)");
  return simulation;
}

Status playOtherwise(const Otherwise& otherwise, const std::string& name, replay::Replay& replay) {
  Result<sim::GameDef> def = defOf(replay.start, name);
  if (!def) return def.error();
  if (otherwise.accuracy) def->accuracy = *otherwise.accuracy;
  def->without = def->without.with(otherwise.without);
  replay.start.settings = settingsOf(*def);
  const effects::EffectMask physical = otherwise.without.both(effects::maskOf(effects::Kind::Physical));
  if (otherwise.accuracy || !physical.isEmpty()) replay.snapshots.clear();
  return Done{};
}

}  // namespace brittle::program
