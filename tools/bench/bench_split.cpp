// What a cut costs: `bench --benchmark_filter=geometry`. Parents are the pieces met while a cube is cut to 512. The
// label is a hash of all that was computed: the same on every machine, or the figures compare different work.
#include <benchmark/benchmark.h>

#include <string>

#include "engine/core/hash.h"
#include "engine/core/random.h"
#include "engine/geometry/make.h"
#include "engine/geometry/mass.h"
#include "engine/geometry/mesh_pool.h"
#include "engine/geometry/split.h"

namespace {

using namespace brittle;
using namespace brittle::geometry;

struct Cut {
  Convex parent;
  Plane plane;
};

Vec3 drawVector(Random& random) {
  const float x = random.nextFloat(-1.0f, 1.0f);
  const float y = random.nextFloat(-1.0f, 1.0f);
  const float z = random.nextFloat(-1.0f, 1.0f);
  return Vec3(x, y, z);
}

/// Every cut made on the way from one cube to 512 pieces, several times over. `throughEdges`: along an edge that
/// exists, where signs need repair.
std::vector<Cut> makeCuts(bool throughEdges, std::size_t count) {
  Random random(42);
  std::vector<Cut> cuts;
  std::vector<Convex> pieces;
  SplitScratch scratch;
  Convex above, below;
  while (cuts.size() < count) {
    if (pieces.empty() || pieces.size() == 512) pieces.assign(1, makeBox<float>(Vec3::Constant(0.5f)));
    Convex& piece = pieces[random.nextBelow(static_cast<std::uint32_t>(pieces.size()))];
    const ConvexView view = piece.view();
    const std::uint32_t edge = random.nextBelow(static_cast<std::uint32_t>(piece.edges.size()));
    const Vec3 start = view.startOf(edge);
    Vec3 normal = normalizedOr(drawVector(random), Vec3::UnitX());
    Vec3 through = 0.5f * (start + piece.vertices[0].point);
    if (throughEdges) {
      const Vec3 along = view.endOf(edge) - start;
      normal = normalizedOr(along.cross(normal), normal);
      through = start;
    }
    const Plane plane = planeThrough(through, normal);
    if (split<float>(view, plane, {}, scratch, above, below) != SplitOutcome::Split) continue;
    cuts.push_back({piece, plane});
    piece = above;
    pieces.push_back(below);
  }
  return cuts;
}

void addTo(StateHash& hash, const Convex& convex) {
  for (const Vertex& vertex : convex.vertices) {
    for (int i = 0; i < 3; ++i) hash.add(vertex.point[i]);
  }
  hash.addBytes(convex.edges.data(), convex.edges.size() * sizeof(Edge));
}

std::string labelOf(const StateHash& hash) {
  char text[24];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash.value()));
  return text;
}

void splitPieces(benchmark::State& state, bool throughEdges) {
  const std::vector<Cut> cuts = makeCuts(throughEdges, 4096);
  SplitScratch scratch;
  Convex above, below;
  StateHash hash;
  std::size_t halfEdges = 0;
  for (const Cut& cut : cuts) {
    split<float>(cut.parent.view(), cut.plane, {}, scratch, above, below);
    addTo(hash, above);
    addTo(hash, below);
    halfEdges += cut.parent.edges.size();
  }
  std::size_t at = 0;
  for (auto iteration : state) {
    const Cut& cut = cuts[at++ % cuts.size()];
    benchmark::DoNotOptimize(split<float>(cut.parent.view(), cut.plane, {}, scratch, above, below));
  }
  state.SetItemsProcessed(state.iterations());
  state.SetLabel(labelOf(hash));
  state.counters["half_edges"] = static_cast<double>(halfEdges) / static_cast<double>(cuts.size());
}
void splitAtRandom(benchmark::State& state) {
  splitPieces(state, false);
}
void splitThroughEdges(benchmark::State& state) {
  splitPieces(state, true);
}
BENCHMARK(splitAtRandom)->Name("geometry/split/random");
BENCHMARK(splitThroughEdges)->Name("geometry/split/through_edges");

void splitCylinder(benchmark::State& state) {
  const Convex cylinder = makeCylinder(1.0f, 1.0f, static_cast<int>(state.range(0)));
  const Plane plane = {Vec3(0.6f, 0.8f, 0.0f), 0.1f};
  SplitScratch scratch;
  Convex above, below;
  for (auto iteration : state) {
    benchmark::DoNotOptimize(split<float>(cylinder.view(), plane, {}, scratch, above, below));
  }
  StateHash hash;
  addTo(hash, above);
  state.SetLabel(labelOf(hash));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(splitCylinder)
    ->Name("geometry/split/cylinder")
    ->Arg(8)
    ->Arg(64)
    ->Arg(512)
    ->Arg(8000)
    ->Complexity(benchmark::oN);

void massOfPieces(benchmark::State& state) {
  const std::vector<Cut> cuts = makeCuts(false, 1024);
  StateHash hash;
  for (const Cut& cut : cuts) {
    const MassProperties mass = massOf(cut.parent.view());
    hash.add(mass.volume);
    hash.add(mass.inertia(0, 1));
  }
  std::size_t at = 0;
  for (auto iteration : state) benchmark::DoNotOptimize(massOf(cuts[at++ % cuts.size()].parent.view()));
  state.SetLabel(labelOf(hash));
}
BENCHMARK(massOfPieces)->Name("geometry/mass");

void churnMeshPool(benchmark::State& state) {
  const std::vector<Cut> cuts = makeCuts(false, 1024);
  MeshPool pool;
  std::vector<MeshSlot> slots;
  for (int i = 0; i < 500; ++i) slots.push_back(pool.add(cuts[static_cast<std::size_t>(i)].parent.view(), 0, 0));
  std::size_t at = 0;
  for (auto iteration : state) {
    MeshSlot& slot = slots[at % slots.size()];
    pool.remove(slot);
    slot = pool.add(cuts[at++ % cuts.size()].parent.view(), 0, 0);
    if (at % 256 == 0) pool.clearDirty();
  }
}
BENCHMARK(churnMeshPool)->Name("geometry/mesh_pool/remove_add");

}  // namespace
