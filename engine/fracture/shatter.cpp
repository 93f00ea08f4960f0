#include "engine/fracture/shatter.h"

#include "engine/geometry/mass.h"

namespace brittle::fracture {

namespace {

/// The axis along which the convex is longest.
int longestAxis(const geometry::ConvexView& convex, const DiceShape& shape) {
  int longest = 0;
  float length = -1.0f;
  for (int axis = 0; axis < 3; ++axis) {
    float low = 3.0e38f, high = -3.0e38f;
    for (const geometry::Vertex& vertex : convex.vertices) {
      const float at = shape.axes[axis].dot(vertex.point);
      low = minOf(low, at);
      high = maxOf(high, at);
    }
    // A thousandth more to win: the sides of a cube must not be told apart by their last bit.
    if (high - low > length * 1.001f) {
      length = high - low;
      longest = axis;
    }
  }
  return longest;
}

Vec3 leaningNormal(const DiceShape& shape, int axis, Random& random) {
  const float leanFirst = random.nextFloat(-shape.tilt, shape.tilt);
  const float leanSecond = random.nextFloat(-shape.tilt, shape.tilt);
  const int first = (axis + 1) % 3, second = (axis + 2) % 3;
  Vec3 normal = shape.axes[axis];
  const bool staysSquare = shape.keepsLastAxis && axis != 2;
  if (!staysSquare || first != 2) normal += shape.axes[first] * leanFirst;
  if (!staysSquare || second != 2) normal += shape.axes[second] * leanSecond;
  return normal.normalized();
}

/// `count` shared out in proportion to the volumes, at least one each.
std::uint32_t shareOf(std::uint32_t count, float volume, float otherVolume) {
  const float sum = volume + otherVolume;
  const float wanted = sum > 0.0f ? static_cast<float>(count) * (volume / sum) : 1.0f;
  return static_cast<std::uint32_t>(clampTo(wanted + 0.5f, 1.0f, static_cast<float>(count - 1)));
}

}  // namespace

void shatterAlong(ChunkStore& store, const CrackTree& tree, const Chunk& chunk, ShatterScratch& scratch,
                  std::vector<Chunk>& pieces) {
  scratch.branches.clear();
  scratch.branches.push_back({chunk, tree.cracks.empty() ? kNoCrack : 0});
  while (!scratch.branches.empty()) {
    const ShatterScratch::Branch branch = scratch.branches.back();
    scratch.branches.pop_back();
    if (branch.crack < 0) {
      pieces.push_back(branch.chunk);
      if (branch.crack == kCore) pieces.back().isBonded = false;
      continue;
    }
    const Crack& crack = tree.cracks[static_cast<std::size_t>(branch.crack)];
    const Depths depths = depthsOf(store.view(branch.chunk), crack.plane);
    CutResult result = depths.above > depths.below ? CutResult::StaysAbove : CutResult::StaysBelow;
    Chunk above, below;
    if (minOf(depths.above, depths.below) > tree.minDepth) result = store.cut(branch.chunk, crack.plane, above, below);
    if (result == CutResult::Split) {
      store.release(branch.chunk);
      scratch.branches.push_back({above, crack.above});
      scratch.branches.push_back({below, crack.below});
    } else {
      scratch.branches.push_back({branch.chunk, result == CutResult::StaysAbove ? crack.above : crack.below});
    }
  }
}

void shatterInto(ChunkStore& store, const DiceShape& shape, const Chunk& chunk, std::uint32_t count, Random& random,
                 ShatterScratch& scratch, std::vector<Chunk>& pieces) {
  scratch.shares.clear();
  scratch.shares.push_back({chunk, count});
  while (!scratch.shares.empty()) {
    const ShatterScratch::Share share = scratch.shares.back();
    scratch.shares.pop_back();
    if (share.count < 2) {
      pieces.push_back(share.chunk);
      continue;
    }
    const int axis = longestAxis(store.view(share.chunk), shape);
    const Vec3 normal = leaningNormal(shape, axis, random);
    const geometry::MassProperties mass = geometry::massOf<float>(store.view(share.chunk));
    Chunk above, below;
    if (store.cut(share.chunk, planeThrough(mass.center, normal), above, below) != CutResult::Split) {
      pieces.push_back(share.chunk);
      continue;
    }
    store.release(share.chunk);
    const float volumeAbove = geometry::massOf<float>(store.view(above)).volume;
    const std::uint32_t countAbove = shareOf(share.count, volumeAbove, mass.volume - volumeAbove);
    scratch.shares.push_back({above, countAbove});
    scratch.shares.push_back({below, share.count - countAbove});
  }
}

}  // namespace brittle::fracture
