// brittle/game.h - a game as something that can be recorded and replayed, and the two ways to describe its start:
// command-line options and a replay's header.
#pragma once

#include <memory>
#include <optional>

#include "engine/core/result.h"
#include "engine/replay/player.h"
#include "game/content/asset_source.h"
#include "game/sim/game.h"
#include "tools/brittle/options.h"

namespace brittle::program {

class GameSimulation : public replay::Simulation {
 public:
  explicit GameSimulation(std::unique_ptr<sim::Game> game) : game_(std::move(game)) {}
  void tick(const replay::InputFrame& input) override { game_->tick(input); }
  std::uint64_t hash() const override { return game_->stateHash(); }
  void save(ByteWriter& out) const override { game_->save(out); }
  bool restore(ByteReader& in) override { return game_->restore(in); }
  sim::Game& game() { return *game_; }
  const sim::Game& game() const { return *game_; }

 private:
  std::unique_ptr<sim::Game> game_;
};

Result<sim::GameDef> defOf(const GameOptions& options);
/// The preset that --accuracy names.
Result<physics::Accuracy> accuracyOf(const std::string& preset);
/// A fresh game from its definition; `assets` must outlive it.
Result<std::unique_ptr<GameSimulation>> openGame(const content::AssetSource& assets, const sim::GameDef& def);

/// What a replay of this game, just created, starts with.
replay::Start startOf(const sim::Game& game);
/// Loads a replay this build can play. Refuses one without ticks.
Result<replay::Replay> loadReplay(const std::string& path);
/// The game a replay starts with; refuses other content than it was recorded with. `name` is the replay's, for
/// messages.
Result<std::unique_ptr<GameSimulation>> openReplay(const content::AssetSource& assets, const replay::Replay& replay,
                                                   const std::string& name);

/// The effects that --without names, separated by commas and spaces; of an empty text none.
Result<effects::EffectMask> effectsOf(const std::string& names);

/// How a recorded game is played again, if not as it was recorded.
struct Otherwise {
  std::optional<physics::Accuracy> accuracy;
  effects::EffectMask without;  // beside what was switched off in it
};

/// Makes of a recorded game the same throws at another accuracy or with fewer effects: where that changes the state,
/// without the snapshots, which are of the recorded one.
Status playOtherwise(const Otherwise& otherwise, const std::string& name, replay::Replay& replay);

/// The folder of levels: `folder`, or the one that came with the program if it is empty. Refuses one that is not there.
Result<std::unique_ptr<content::AssetSource>> openAssets(const std::string& folder);

}  // namespace brittle::program
