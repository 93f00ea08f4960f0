// What breaking costs: `bench --benchmark_filter=break`. A pane whose break makes a given number of bodies, the tick it
// breaks in and those after; a carve of 30 shards without a step around it; a pile in which everything breaks. Each
// with the state hash it ended with.
#include <algorithm>

#include "tests/allocations.h"
#include "tools/bench/scene.h"

namespace {

using namespace brittle;
using namespace brittle::physics;

constexpr float kPaneSize = 4.0f;  // [m]

BodyHandle addPane(World& world, const fracture::FractureMaterial& material) {
  BodyDef pane;
  pane.type = BodyType::Static;
  pane.pose.position = Vec3(0.0f, 2.1f, 0.0f);
  pane.breakable.strength = 50.0f;
  pane.breakable.material = material;
  return addBox(world, pane, Vec3(0.5f * kPaneSize, 0.5f * kPaneSize, 0.03f), true);
}

/// A pane of 4 x 4 x 0.06 m, a steel ball of 0.25 m at 25 m/s in front of it, and a floor. Tempered glass, since only
/// that breaks as a whole: the radial pattern has 40 sectors at most, none thinner than 3.5 % of its hole, and ends at
/// some 55 pieces.
void shootAtPane(World& world, int pieces) {
  addFloor(world);
  fracture::FractureMaterial material;
  material.pattern = fracture::Pattern::Tempered;
  material.dieSize = kPaneSize / std::sqrt(static_cast<float>(pieces));
  addPane(world, material);
  BodyDef ball;
  ball.pose.position = Vec3(0.1f, 2.0f, 0.6f);
  ball.velocity = Vec3(0.0f, 0.0f, -25.0f);
  ShapeDef steel;
  steel.surface.density = 7800.0f;
  world.addSphere(world.createBody(ball), steel, 0.25f);
}

/// Steps until the pane breaks, and leaves a snapshot of the tick before.
void stepToBreak(World& world, ByteWriter& before) {
  do {
    before.clear();
    world.save(before);
    world.step(kTick);
  } while (world.counters().breaks == 0);
}

/// Goes back to a snapshot, off the clock.
void rewind(benchmark::State& state, const ByteWriter& snapshot, World& world) {
  state.PauseTiming();
  ByteReader in(snapshot.bytes());
  if (!world.restore(in)) state.SkipWithError("the snapshot was refused");
  state.ResumeTiming();
}

/// The tick in which the pane breaks, cut included; the world is warm.
void breakFrame(benchmark::State& state) {
  World world;
  shootAtPane(world, static_cast<int>(state.range(0)));
  ByteWriter before;
  stepToBreak(world, before);
  std::size_t allocations = 0;
  for (auto iteration : state) {
    rewind(state, before, world);
    const std::size_t earlier = allocationCount();
    world.step(kTick);
    allocations = allocationCount() - earlier;
  }
  state.counters["pieces"] = world.counters().pieces;
  state.counters["contacts"] = world.counters().contacts;
  state.counters["passes"] = world.counters().passes;
  state.counters["allocations"] = static_cast<double>(allocations);
  label(state, world.stateHash());
}
BENCHMARK(breakFrame)
    ->Name("break/pane/frame")
    ->ArgName("pieces")
    ->Arg(50)
    ->Arg(100)
    ->Arg(200)
    ->Arg(400)
    ->Unit(benchmark::kMillisecond);

/// Three seconds after the hit.
void afterBreak(benchmark::State& state) {
  std::vector<double> ticks;
  for (auto iteration : state) {
    World world;
    shootAtPane(world, 200);
    while (world.counters().breaks == 0) world.step(kTick);
    for (int i = 0; i < 180; ++i) {
      const double start = cpuMilliseconds();
      world.step(kTick);
      ticks.push_back(cpuMilliseconds() - start);
    }
    label(state, world.stateHash());
  }
  std::sort(ticks.begin(), ticks.end());
  state.counters["median_ms"] = ticks[ticks.size() / 2];
  state.counters["p99_ms"] = ticks[ticks.size() * 99 / 100];
  state.counters["heaviest_ms"] = ticks.back();
}
BENCHMARK(afterBreak)->Name("break/pane/three_seconds")->Unit(benchmark::kMillisecond)->Iterations(3);

/// 30 shards carved out of a pane: cuts, connectivity, mass properties, bodies and shapes made, their contacts seeded.
void carve(benchmark::State& state) {
  World world;
  fracture::FractureMaterial material;
  material.carveRadius = 0.5f;
  material.density = 1.45f;
  const BodyHandle pane = addPane(world, material);
  world.step(kTick);
  ByteWriter before;
  world.save(before);
  std::size_t allocations = 0;
  for (auto iteration : state) {
    rewind(state, before, world);
    const std::size_t earlier = allocationCount();
    world.breakBody(pane, Vec3(0.1f, 2.0f, 0.03f), -Vec3::UnitZ(), 10.0f, 0.05f);
    allocations = allocationCount() - earlier;
  }
  std::size_t shards = 0;
  world.forEachBody([&](BodyHandle, const Body& body) { shards += body.isDynamic() ? 1 : 0; });
  state.counters["shards"] = static_cast<double>(shards);
  state.counters["allocations"] = static_cast<double>(allocations);
  label(state, world.stateHash());
}
BENCHMARK(carve)->Name("break/carve")->Unit(benchmark::kMillisecond);

/// A pile of 1000 boxes that falls onto the floor and breaks altogether within a few ticks.
void breakPile(benchmark::State& state) {
  WorldDef def;
  def.accuracy.maxBodies = 100000;
  def.accuracy.patternDensity = 0.1f;
  World world(def);
  addFloor(world);
  for (int i = 0; i < 1000; ++i) {
    BodyDef box;
    box.pose.position =
        0.205f * Vec3(static_cast<float>(i % 10), static_cast<float>(i / 100), static_cast<float>(i / 10 % 10));
    box.pose.position.y() += 0.3f;
    box.velocity = Vec3(0.0f, -6.0f, 0.0f);
    box.breakable.strength = 0.05f;
    box.breakable.material.pattern = fracture::Pattern::Block;
    box.breakable.material.minVolume = 1.5e-3f;
    addBox(world, box, Vec3::Constant(0.1f));
  }
  double heaviest = 0.0;
  std::uint32_t breaks = 0;
  for (auto iteration : state) {
    for (int tick = 0; tick < 20; ++tick) {
      const double start = cpuMilliseconds();
      world.step(kTick);
      const double milliseconds = cpuMilliseconds() - start;
      if (milliseconds > heaviest) breaks = world.counters().breaks;
      heaviest = std::max(heaviest, milliseconds);
    }
  }
  state.counters["heaviest_ms"] = heaviest;
  state.counters["breaks_in_it"] = breaks;
  label(state, world.stateHash());
}
BENCHMARK(breakPile)->Name("break/pile_of_1000")->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
