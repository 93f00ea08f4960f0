// What the shipped rooms cost: `bench --benchmark_filter=room`. A player throws at what is ahead twice a second; every
// tick is timed, and the heaviest is taken apart: the part of each zone in it, in ms.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "game/content/asset_source.h"
#include "game/sim/constants.h"
#include "game/sim/game.h"
#include "tools/bench/zones.h"

namespace {

using namespace brittle;

void playRoom(benchmark::State& state) {
  const content::FolderSource assets({BRITTLE_SOURCE_DIR "/assets"});
  std::vector<double> ticks;
  double heaviest = 0.0;
  std::map<std::string, double> parts;
  std::uint64_t hash = 0;
  ZoneTimes zones;
  for (auto iteration : state) {
    sim::GameDef def;
    def.mode = sim::Mode::Zen;  // balls do not run out
    def.firstRoom = static_cast<std::uint32_t>(state.range(0));
    Result<std::unique_ptr<sim::Game>> game = sim::Game::create(assets, def);
    if (!game) {
      state.SkipWithError(game.error().message.c_str());
      return;
    }
    for (std::uint32_t tick = 0; tick < sim::rules::kRoomTicks; ++tick) {
      replay::InputFrame input;
      if (tick % 30 == 15)
        input.throws.push_back(replay::quantizeAim(0.1f * static_cast<float>(tick / 30 % 5) - 0.2f, 0.02f));
      zones.clear();
      const double start = physics::cpuMilliseconds();
      (*game)->tick(input);
      ticks.push_back(physics::cpuMilliseconds() - start);
      if (ticks.back() <= heaviest) continue;
      heaviest = ticks.back();
      parts = zones.milliseconds();
    }
    hash = (*game)->stateHash();
  }
  std::sort(ticks.begin(), ticks.end());
  state.counters["median_ms"] = ticks[ticks.size() / 2];
  state.counters["p99_ms"] = ticks[ticks.size() * 99 / 100];
  state.counters["heaviest_ms"] = heaviest;
  for (const auto& [zone, milliseconds] : parts)
    if (milliseconds >= 0.02 * heaviest) state.counters["in it: " + zone] = milliseconds;
  physics::label(state, hash);
}
BENCHMARK(playRoom)->Name("room/first")->DenseRange(0, 2)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
