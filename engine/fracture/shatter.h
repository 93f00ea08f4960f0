// fracture/shatter.h - cuts fragments further: along a tree of cracks, or at random into a number of pieces of like
// size.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/random.h"
#include "engine/fracture/chunk.h"
#include "engine/fracture/pattern.h"

namespace brittle::fracture {

struct ShatterScratch {
  struct Branch {
    Chunk chunk;
    std::int32_t crack;
  };
  struct Share {
    Chunk chunk;
    std::uint32_t count;
  };
  std::vector<Branch> branches;
  std::vector<Share> shares;
};

/// Cuts `chunk` by the tree and appends the pieces; those of the core lose their bond. Cracks that would leave a sliver
/// are left out.
void shatterAlong(ChunkStore& store, const CrackTree& tree, const Chunk& chunk, ShatterScratch& scratch,
                  std::vector<Chunk>& pieces);

/// How `shatterInto` lays its cuts.
struct DiceShape {
  Vec3 axes[3] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};  // unit, orthogonal
  float tilt = 0.0f;  // how far a cut may lean from square to the longest side [-], 0: not at all, 1: 45 degrees
  bool keepsLastAxis = false;  // cuts along the first two axes stay square to the third: dice of a sheet
};

/// Cuts `chunk` into `count` pieces of like volume, each time across its longest side, and appends them.
void shatterInto(ChunkStore& store, const DiceShape& shape, const Chunk& chunk, std::uint32_t count, Random& random,
                 ShatterScratch& scratch, std::vector<Chunk>& pieces);

}  // namespace brittle::fracture
