// What a tick costs: `bench --benchmark_filter=physics`. Each line carries the state hash the scene ended with, and
// allocations per tick where that is the claim.
#include <benchmark/benchmark.h>

#include "tests/allocations.h"
#include "tools/bench/scene.h"

namespace {

using namespace brittle;
using namespace brittle::physics;

/// A wall of boxes that stays awake: a tick allocates nothing once warm.
void warmTick(benchmark::State& state) {
  WorldDef def;
  def.accuracy.deactivation = false;
  World world(def);
  addFloor(world);
  for (int row = 0; row < 5; ++row) {
    for (int i = 0; i < 20; ++i) {
      BodyDef box;
      box.pose.position = Vec3(0.41f * static_cast<float>(i) + (row % 2 != 0 ? 0.2f : 0.0f),
                               0.1f + 0.2f * static_cast<float>(row), 0.0f);
      addBox(world, box, Vec3(0.2f, 0.1f, 0.1f));
    }
  }
  for (int i = 0; i < 120; ++i) world.step(kTick);
  const std::size_t before = allocationCount();
  std::size_t ticks = 0;
  for (auto iteration : state) {
    world.step(kTick);
    ++ticks;
  }
  state.counters["allocations_per_tick"] = static_cast<double>(allocationCount() - before) / static_cast<double>(ticks);
  state.counters["bodies"] = world.counters().bodies;
}
BENCHMARK(warmTick)->Name("physics/warm_tick_100_boxes")->Unit(benchmark::kMillisecond);

}  // namespace
