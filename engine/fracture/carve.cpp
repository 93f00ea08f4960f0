#include "engine/fracture/carve.h"

namespace brittle::fracture {

namespace {

bool isBeyondAWall(const geometry::ConvexView& convex, const Cell& cell) {
  for (std::uint32_t i = 0; i < cell.count; ++i) {
    if (depthsOf(convex, cell.walls[i]).below <= 0.0f) return true;
  }
  return false;
}

/// Cuts `chunk` wall by wall. Appends what is outside to `outside`; `inside` becomes the rest. False if nothing is
/// inside: then what was cut so far has been given back and `outside` is as it was.
bool cutOut(ChunkStore& store, const Cell& cell, const Chunk& chunk, std::vector<Chunk>& outside, Chunk& inside) {
  const std::size_t firstOutside = outside.size();
  inside = chunk;
  for (std::uint32_t i = 0; i < cell.count; ++i) {
    if (depthsOf(store.view(inside), cell.walls[i]).above <= cell.minDepth) continue;
    Chunk above, below;
    const CutResult result = store.cut(inside, cell.walls[i], above, below);
    if (result == CutResult::StaysBelow) continue;
    if (inside.slot != chunk.slot) store.release(inside);
    if (result == CutResult::StaysAbove) {
      for (std::size_t k = firstOutside; k < outside.size(); ++k) store.release(outside[k]);
      outside.resize(firstOutside);
      return false;
    }
    outside.push_back(above);
    inside = below;
  }
  return true;
}

}  // namespace

void carve(ChunkStore& store, const Cell& cell, bool isBonded, CarveLists& lists) {
  lists.scratch.clear();
  for (const Chunk& chunk : lists.remains) {
    Chunk inside;
    if (isBeyondAWall(store.view(chunk), cell) || !cutOut(store, cell, chunk, lists.scratch, inside)) {
      lists.scratch.push_back(chunk);
      continue;
    }
    if (inside.slot != chunk.slot) store.release(chunk);
    inside.isFragment = true;
    inside.isBonded = isBonded;
    lists.fragments.push_back(inside);
  }
  lists.remains.swap(lists.scratch);
}

}  // namespace brittle::fracture
