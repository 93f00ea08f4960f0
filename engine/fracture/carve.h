// fracture/carve.h - Boolean difference by splitting: every convex that reaches into the carved volume is cut by its
// walls in turn; what is outside a wall stays, what is inside all of them becomes fragments. Source: Gustafsson,
// Procedural Destruction (talk).
#pragma once

#include <vector>

#include "engine/fracture/chunk.h"
#include "engine/fracture/pattern.h"

namespace brittle::fracture {

/// What a carve reads and writes. All three keep their capacity.
struct CarveLists {
  std::vector<Chunk> remains;    // in: what may be carved; out: what is left of it, in cutting order
  std::vector<Chunk> fragments;  // out: appended
  std::vector<Chunk> scratch;
};

/// Carves `cell` out of lists.remains. Convexes that only a few walls would cut without removing anything are left
/// whole. New fragments carry `isBonded` as given.
void carve(ChunkStore& store, const Cell& cell, bool isBonded, CarveLists& lists);

}  // namespace brittle::fracture
