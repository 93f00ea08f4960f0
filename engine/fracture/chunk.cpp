#include "engine/fracture/chunk.h"

#include <utility>

namespace brittle::fracture {

namespace {

// Room every result convex starts with, so that buffers that change hands between breakings seldom have to grow.
// Measured: shards of panes and blocks have 6 to 24 vertices.
constexpr std::size_t kRoomVertices = 48, kRoomFaces = 32, kRoomEdges = 144;

/// Ids of earlier breakings mean nothing in this one, even where they are the same number: only the cap, the last face,
/// is of this one.
void forgetOlderCuts(geometry::Convex& convex) {
  for (std::size_t i = 0; i + 1 < convex.faces.size(); ++i) convex.faces[i].cut = 0;
}

}  // namespace

Depths depthsOf(const geometry::ConvexView& convex, const Plane& plane) {
  Depths depths;
  for (const geometry::Vertex& vertex : convex.vertices) {
    const float distance = plane.distance(vertex.point);
    depths.above = maxOf(depths.above, distance);
    depths.below = maxOf(depths.below, -distance);
  }
  return depths;
}

void ChunkStore::begin(std::span<const Part> parts, std::vector<geometry::Convex>& made) {
  parts_ = parts;
  made_ = &made;
  free_.clear();
  used_ = 0;
  nextCut_ = 1;
  refusedCuts_ = 0;
}

geometry::ConvexView ChunkStore::view(const Chunk& chunk) const {
  return chunk.slot == kWholePart ? parts_[chunk.part].convex : (*made_)[chunk.slot].view();
}

CutResult ChunkStore::cut(const Chunk& parent, const Plane& plane, Chunk& above, Chunk& below) {
  const std::uint32_t slotAbove = acquire();
  const std::uint32_t slotBelow = acquire();
  geometry::Convex& convexAbove = (*made_)[slotAbove];
  geometry::Convex& convexBelow = (*made_)[slotBelow];
  const geometry::CutMark mark{nextCut_, geometry::FaceKind::Cut};
  const geometry::SplitOutcome outcome =
      geometry::split<float>(view(parent), plane, mark, scratch_, convexAbove, convexBelow);
  if (outcome == geometry::SplitOutcome::Split) {
    if (parent.slot == kWholePart) {
      forgetOlderCuts(convexAbove);
      forgetOlderCuts(convexBelow);
    }
    ++nextCut_;
    above = parent;
    below = parent;
    above.slot = slotAbove;
    below.slot = slotBelow;
    return CutResult::Split;
  }
  free_.push_back(slotBelow);
  free_.push_back(slotAbove);
  if (outcome == geometry::SplitOutcome::AllAbove) return CutResult::StaysAbove;
  if (outcome == geometry::SplitOutcome::AllBelow) return CutResult::StaysBelow;
  ++refusedCuts_;
  const Depths depths = depthsOf(view(parent), plane);
  return depths.above > depths.below ? CutResult::StaysAbove : CutResult::StaysBelow;
}

void ChunkStore::release(const Chunk& chunk) {
  if (chunk.slot != kWholePart) free_.push_back(chunk.slot);
}

std::uint32_t ChunkStore::compact(std::span<Chunk> chunks) {
  taken_.assign(used_, 0);
  std::uint32_t count = 0;
  for (const Chunk& chunk : chunks) {
    if (chunk.slot == kWholePart) continue;
    taken_[chunk.slot] = 1;
    ++count;
  }
  std::uint32_t hole = 0;
  for (Chunk& chunk : chunks) {
    if (chunk.slot == kWholePart || chunk.slot < count) continue;
    while (taken_[hole] != 0) ++hole;
    std::swap((*made_)[hole], (*made_)[chunk.slot]);
    taken_[hole] = 1;
    chunk.slot = hole;
  }
  return count;
}

std::uint32_t ChunkStore::acquire() {
  if (!free_.empty()) {
    const std::uint32_t slot = free_.back();
    free_.pop_back();
    return slot;
  }
  if (used_ == made_->size()) {
    geometry::Convex& convex = made_->emplace_back();
    convex.vertices.reserve(kRoomVertices);
    convex.faces.reserve(kRoomFaces);
    convex.edges.reserve(kRoomEdges);
  }
  return used_++;
}

}  // namespace brittle::fracture
