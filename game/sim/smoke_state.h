// What a smoke script has made so far: its game, the throws it has announced, what did not hold. Shared by the files
// that define the script's functions; see smoke.h.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/script/library.h"
#include "game/sim/smoke.h"

namespace brittle::sim {

inline constexpr std::uint64_t kLongestRun = 200'000;  // [ticks]: nearly an hour of play

class Smoke {
 public:
  Smoke(const content::AssetSource& assets, const SmokeSettings& smokeSettings)
      : settings(smokeSettings), assets_(assets) {
    result.def.accuracy = settings.accuracy;
    result.def.without = settings.without;
    if (settings.seed) result.def.seed = *settings.seed;
  }

  bool started() const { return game_ != nullptr; }
  /// The game, made at the first call that needs it; null, with the call failed, if that does not work.
  Game* game(script::Call& call) {
    if (game_) return game_.get();
    Result<std::unique_ptr<Game>> made = Game::create(assets_, result.def);
    if (!made) {
      call.fail(made.error().message);
      return nullptr;
    }
    game_ = std::move(*made);
    return game_.get();
  }
  /// False if the tick has as many throws as an input frame holds.
  bool throwAt(std::uint64_t tick, const replay::Throw& aim) {
    if (throws_.size() <= tick) throws_.resize(tick + 1);
    if (throws_[tick].size() >= static_cast<std::size_t>(replay::kMaxThrows)) return false;
    throws_[tick].push_back(aim);
    return true;
  }
  void useAt(std::uint64_t tick, int place) { buttons_[tick] |= replay::useBit(place); }
  bool isCalledOff() const { return settings.isCalledOff && settings.isCalledOff(); }
  void run(Game& game, std::uint64_t until) {
    while (game.tickCount() < until && !isCalledOff()) {
      replay::InputFrame frame;
      if (game.tickCount() < throws_.size()) frame.throws = throws_[game.tickCount()];
      if (const auto pressed = buttons_.find(game.tickCount()); pressed != buttons_.end())
        frame.buttons = pressed->second;
      result.inputs.push_back(frame);
      game.tick(frame);
      for (const Event& event : game.events()) ++events_[static_cast<std::size_t>(event.type)];
    }
  }
  std::uint32_t eventsOf(EventType type) const { return events_[static_cast<std::size_t>(type)]; }
  bool saveAndRestore(Game& game) {
    ByteWriter out;
    game.save(out);
    const std::uint64_t before = game.stateHash();
    Result<std::unique_ptr<Game>> fresh = Game::create(assets_, result.def);
    ByteReader in(out.bytes());
    if (!fresh || !(*fresh)->restore(in) || (*fresh)->stateHash() != before) return false;
    addUp(result.omissions, game.omissions());
    game_ = std::move(*fresh);
    return true;
  }
  void check(script::Call& call, const char* what, bool holds, const std::string& found, const std::string& expected) {
    ++result.checks;
    if (holds) return;
    result.failures.push_back(
        {game_->tickCount(), call.where() + ": " + what + ": " + found + ", expected " + expected});
  }
  void finish() {
    if (!game_) return;
    result.ticks = game_->tickCount();
    result.stateHash = game_->stateHash();
    result.hud = game_->hud();
    addUp(result.omissions, game_->omissions());
    for (const Problem& problem : game_->problems()) result.problems.push_back(problem.text);
  }

  SmokeResult result;
  const SmokeSettings settings;
  std::vector<Sight> sights;  // of the last look()

 private:
  const content::AssetSource& assets_;
  std::unique_ptr<Game> game_;
  std::vector<std::vector<replay::Throw>> throws_;
  std::map<std::uint64_t, std::uint8_t> buttons_;  // by tick
  std::array<std::uint32_t, 64> events_{};         // by type, so far
};

std::string smokeText(double value);

inline void addSmokeCall(script::Library& library, const char* name, void (*native)(script::Call&, Smoke&)) {
  library.add(name, [native](script::Call& call) { native(call, call.user<Smoke>()); });
}

/// What a scripted player knows and does: time, counts, what is in sight.
void addPlayerCalls(script::Library& library);

}  // namespace brittle::sim
