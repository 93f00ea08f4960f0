// What the plate of hard case B40 costs: the spray onto a plate and the same spray without one, one second from the
// first shot.
//   valgrind --tool=callgrind --toggle-collect='brittle::physics::World::step(float)' build/tools/bench
//   --benchmark_filter=physics/spray/speed:60/plate:1
// gives the instructions of 60 ticks.
#include <benchmark/benchmark.h>

#include "tests/hard_cases/spray.h"

namespace {

using namespace brittle;
using namespace brittle::physics;

void spray(benchmark::State& state) {
  SprayDef def;
  def.speed = static_cast<float>(state.range(0));
  if (state.range(1) == 0) def.plateCenter = Vec3(0.0f, 1000.0f, 0.0f);
  std::uint32_t contacts = 0, points = 0, sweeps = 0;
  for (auto iteration : state) {
    state.PauseTiming();
    Spray scene(def);
    state.ResumeTiming();
    for (int tick = 0; tick < 60; ++tick) {
      scene.step();
      const Counters& counters = scene.world.counters();
      contacts += counters.contacts;
      points += counters.points;
      sweeps += counters.sweeps;
    }
  }
  state.counters["contacts_per_tick"] = contacts / 60.0;
  state.counters["points_per_tick"] = points / 60.0;
  state.counters["sweeps_per_tick"] = sweeps / 60.0;
}
BENCHMARK(spray)
    ->Name("physics/spray")
    ->ArgNames({"speed", "plate"})
    ->ArgsProduct({{15, 60, 120}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace
