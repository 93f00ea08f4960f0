// What the rooms cost: `bench --benchmark_filter=room`. In a shipped room a player throws at what is ahead twice a
// second; in the endless one, as long as is said, a player throws at everything. Every tick is timed, and the heaviest
// is taken apart: the part of each zone in it, in ms.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "game/content/asset_source.h"
#include "game/sim/constants.h"
#include "game/sim/game.h"
#include "tests/game/sim/endless.h"
#include "tools/bench/scene.h"
#include "tools/bench/zones.h"

namespace {

using namespace brittle;

/// The times of all ticks so far.
class TickTimes {
 public:
  void tick(sim::Game& game, const replay::InputFrame& input) {
    zones_.clear();
    const double start = cpuMilliseconds();
    game.tick(input);
    ticks_.push_back(cpuMilliseconds() - start);
    if (ticks_.back() <= heaviest_) return;
    heaviest_ = ticks_.back();
    parts_ = zones_.milliseconds();
  }
  void report(benchmark::State& state) {
    std::sort(ticks_.begin(), ticks_.end());
    state.counters["median_ms"] = ticks_[ticks_.size() / 2];
    state.counters["p99_ms"] = ticks_[ticks_.size() * 99 / 100];
    state.counters["heaviest_ms"] = heaviest_;
    for (const auto& [zone, milliseconds] : parts_)
      if (milliseconds >= 0.02 * heaviest_) state.counters["in it: " + zone] = milliseconds;
  }

 private:
  std::vector<double> ticks_;
  double heaviest_ = 0.0;
  std::map<std::string, double> parts_;
  ZoneTimes zones_;
};

/// A game for so many ticks; `player` says what is thrown in each.
template <class Player>
void play(benchmark::State& state, const content::AssetSource& assets, const sim::GameDef& def, std::int64_t ticks,
          Player&& player) {
  TickTimes times;
  std::uint64_t hash = 0;
  for (auto iteration : state) {
    Result<std::unique_ptr<sim::Game>> game = sim::Game::create(assets, def);
    if (!game) {
      state.SkipWithError(game.error().message.c_str());
      return;
    }
    for (std::int64_t tick = 0; tick < ticks; ++tick) times.tick(**game, player(**game));
    hash = (*game)->stateHash();
  }
  times.report(state);
  physics::label(state, hash);
}

replay::InputFrame throwAhead(const sim::Game& game) {
  replay::InputFrame input;
  const std::uint64_t tick = game.tickCount();
  if (tick % 30 == 15)
    input.throws.push_back(replay::quantizeAim(0.1f * static_cast<float>(tick / 30 % 5) - 0.2f, 0.02f));
  return input;
}

void playRoom(benchmark::State& state) {
  const content::FolderSource assets({BRITTLE_SOURCE_DIR "/assets"});
  sim::GameDef def;
  def.mode = sim::Mode::Zen;  // balls do not run out
  def.firstRoom = static_cast<std::uint32_t>(state.range(0));
  play(state, assets, def, sim::rules::kRoomTicks, throwAhead);
}

void playEndlessly(benchmark::State& state) {
  const sim::LayeredSource assets = sim::endlessSource();
  sim::GameDef def;
  def.level = "endless";
  def.mode = sim::Mode::Zen;
  sim::Thrower thrower(def.seed);
  play(state, assets, def, state.range(0) * 60 * sim::rules::kTickRate,
       [&](const sim::Game& game) { return thrower.next(game); });
}

BENCHMARK(playRoom)->Name("room/first")->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(playEndlessly)
    ->Name("room/endless")
    ->ArgName("minutes")
    ->Arg(1)
    ->Arg(60)
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

}  // namespace
