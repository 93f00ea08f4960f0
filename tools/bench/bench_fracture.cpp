// What a breaking costs: `bench --benchmark_filter=fracture`. Time per breaking, with the pieces, neighbours and cuts
// it makes.
#include <benchmark/benchmark.h>

#include "engine/fracture/fracture.h"
#include "engine/geometry/make.h"

namespace {

using namespace brittle;
using namespace brittle::fracture;

constexpr float kSlop = 1e-4f;  // what physics breaks with [m]

void breakBox(benchmark::State& state, const Vec3& halfExtents, const FractureMaterial& material, float speed) {
  const geometry::Convex box = geometry::makeBox<float>(halfExtents);
  Part part;
  part.convex = box.view();
  part.anchored = true;
  Impact impact;
  impact.point = Vec3(0.1f * halfExtents.x(), 0.2f * halfExtents.y(), halfExtents.z());
  impact.speed = speed;
  impact.strikerRadius = 0.05f;
  Fracturer fracturer;
  std::uint64_t seed = 0;
  std::size_t pieces = 0, neighbours = 0;
  for (auto iteration : state) {
    const Fracture& made = fracturer.fracture({&part, 1}, {&impact, 1}, material, kSlop, seed++ % 64);
    pieces += made.pieces.size();
    neighbours += made.neighbours.size();
    benchmark::DoNotOptimize(made.pieces.data());
  }
  const double runs = static_cast<double>(state.iterations());
  state.counters["pieces"] = static_cast<double>(pieces) / runs;
  state.counters["neighbours"] = static_cast<double>(neighbours) / runs;
}

FractureMaterial materialOf(Pattern pattern) {
  FractureMaterial material;
  material.pattern = pattern;
  return material;
}

void fracturePane(benchmark::State& state) {
  breakBox(state, {0.5f, 0.5f, 0.01f}, materialOf(Pattern::Pane), static_cast<float>(state.range(0)));
}
BENCHMARK(fracturePane)
    ->Name("fracture/pane")
    ->ArgName("speed")
    ->Arg(5)
    ->Arg(10)
    ->Arg(40)
    ->Unit(benchmark::kMicrosecond);

void fractureBlock(benchmark::State& state) {
  breakBox(state, {0.25f, 0.25f, 0.25f}, materialOf(Pattern::Block), static_cast<float>(state.range(0)));
}
BENCHMARK(fractureBlock)->Name("fracture/block")->ArgName("speed")->Arg(10)->Arg(40)->Unit(benchmark::kMicrosecond);

void fractureTempered(benchmark::State& state) {
  breakBox(state, {0.5f, 0.5f, 0.01f}, materialOf(Pattern::Tempered), 10.0f);
}
BENCHMARK(fractureTempered)->Name("fracture/tempered_400_dice")->Unit(benchmark::kMicrosecond);

void fractureLaminated(benchmark::State& state) {
  breakBox(state, {0.5f, 0.5f, 0.01f}, materialOf(Pattern::Laminated), 10.0f);
}
BENCHMARK(fractureLaminated)->Name("fracture/laminated")->Unit(benchmark::kMicrosecond);

/// Grouping a wall of `n` bricks that all touch, as at load.
void connectWall(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0));
  std::vector<geometry::Convex> bricks;
  for (int i = 0; i < count; ++i) {
    const Vec3 center(0.2f * static_cast<float>(i % 10), 0.1f * static_cast<float>(i / 10), 0.0f);
    bricks.push_back(geometry::makeBox<float>({0.1f, 0.05f, 0.05f}, center));
  }
  std::vector<Part> parts(bricks.size());
  for (std::size_t i = 0; i < bricks.size(); ++i) parts[i].convex = bricks[i].view();
  std::vector<std::uint32_t> groups;
  for (auto iteration : state) {
    connectParts(parts, kSlop, groups);
    benchmark::DoNotOptimize(groups.data());
  }
}
BENCHMARK(connectWall)
    ->Name("fracture/connect_wall")
    ->ArgName("bricks")
    ->Arg(10)
    ->Arg(100)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
