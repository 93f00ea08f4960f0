// What a tick costs: `bench --benchmark_filter=physics`. Each line carries the state hash the scene ended with, and allocations per
// tick where that is the claim.
#include <benchmark/benchmark.h>

#include <cstdio>

#include "engine/geometry/make.h"
#include "engine/physics/world.h"
#include "tools/bench/allocations.h"

namespace {

using namespace brittle;
using namespace brittle::physics;

constexpr float kTick = 1.0f / 60.0f;

BodyHandle addBox(World& world, const BodyDef& def, const Vec3& halfExtents, bool anchored = false) {
  const BodyHandle body = world.createBody(def);
  ShapeDef shape;
  shape.surface.density = 2500.0f;
  shape.anchored = anchored;
  world.addConvex(body, shape, geometry::makeBox<float>(halfExtents).view());
  return body;
}

/// A pane of 4 x 4 x 0.06 m, a steel ball of 0.25 m at 25 m/s in front of it, and a floor.
void buildPane(World& world, float density) {
  BodyDef floor;
  floor.type = BodyType::Static;
  floor.pose.position = Vec3(0.0f, -0.5f, 0.0f);
  addBox(world, floor, Vec3(20.0f, 0.5f, 20.0f));
  BodyDef pane;
  pane.type = BodyType::Static;
  pane.pose.position = Vec3(0.0f, 2.1f, 0.0f);
  pane.breakable.strength = 50.0f;
  pane.breakable.material.carveRadius = 1.6f;
  pane.breakable.material.density = density;
  addBox(world, pane, Vec3(2.0f, 2.0f, 0.03f), true);
  BodyDef ball;
  ball.pose.position = Vec3(0.1f, 2.0f, 0.6f);
  ball.velocity = Vec3(0.0f, 0.0f, -25.0f);
  ShapeDef steel;
  steel.surface.density = 7800.0f;
  world.addSphere(world.createBody(ball), steel, 0.25f);
}

void label(benchmark::State& state, const World& world) {
  char text[32];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(world.stateHash()));
  state.SetLabel(text);
}

/// The tick in which the pane breaks, cut included; the world is warm.
void breakFrame(benchmark::State& state) {
  const float density = static_cast<float>(state.range(0)) / 10.0f;
  World world;
  buildPane(world, density);
  while (world.counters().breaks == 0) world.step(kTick);  // warms the scratch memory
  World fresh;
  buildPane(fresh, density);
  ByteWriter before;
  for (;;) {  // the snapshot of the tick before it breaks
    before.clear();
    fresh.save(before);
    fresh.step(kTick);
    if (fresh.counters().breaks > 0) break;
  }
  std::uint32_t pieces = 0;
  for (auto iteration : state) {
    state.PauseTiming();
    ByteReader in(before.bytes());
    if (!world.restore(in)) state.SkipWithError("the snapshot was refused");
    state.ResumeTiming();
    world.step(kTick);
    pieces = world.counters().pieces;
  }
  state.counters["pieces"] = pieces;
  label(state, world);
}
BENCHMARK(breakFrame)->Name("physics/pane_break_frame")->ArgName("density_x10")->Arg(10)->Arg(40)->Arg(300)->Unit(benchmark::kMillisecond);

/// Three seconds after the hit: mean tick.
void afterBreak(benchmark::State& state) {
  for (auto iteration : state) {
    state.PauseTiming();
    World world;
    buildPane(world, 4.0f);
    while (world.counters().breaks == 0) world.step(kTick);
    state.ResumeTiming();
    for (int i = 0; i < 180; ++i) world.step(kTick);
    state.PauseTiming();
    label(state, world);
    state.ResumeTiming();
  }
  state.counters["ms_per_tick"] =
      benchmark::Counter(180.0 * static_cast<double>(state.iterations()) / 1000.0, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(afterBreak)->Name("physics/pane_three_seconds")->Unit(benchmark::kMillisecond)->Iterations(3);

/// A wall of boxes that stays awake: a tick allocates nothing once warm.
void warmTick(benchmark::State& state) {
  WorldDef def;
  def.accuracy.deactivation = false;
  World world(def);
  BodyDef floor;
  floor.type = BodyType::Static;
  floor.pose.position = Vec3(0.0f, -0.5f, 0.0f);
  addBox(world, floor, Vec3(20.0f, 0.5f, 20.0f));
  for (int row = 0; row < 5; ++row) {
    for (int i = 0; i < 20; ++i) {
      BodyDef box;
      box.pose.position = Vec3(0.41f * static_cast<float>(i) + (row % 2 != 0 ? 0.2f : 0.0f), 0.1f + 0.2f * static_cast<float>(row), 0.0f);
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
