// physics/contact_block.h - all normal rows of one light body between heavy ones, solved together. One at a time,
// impulses would creep through it by the ratio of the masses per iteration; solved at once, a light shard between a
// ball and a pane passes on what it must, and a light box carries a heavy one. Source: Cottle, Pang, Stone, The Linear
// Complementarity Problem, 1992 (principal pivoting); Catto, Box2D's block solver, 2006.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/physics/contact_rows.h"
#include "engine/physics/ids.h"

namespace brittle::physics {

inline constexpr int kMaxBlockRows = 32;  // more points than that on one light body are solved in turn

/// A contact solved on its own, not in a batch.
struct Single {
  ContactRows<float> rows;
  std::uint32_t bodyA = 0, bodyB = 0, contact = 0;
  std::uint32_t strike = kNoStrike;  // then unlimited
  int points = 0;
};

/// What the normal impulses of a run of contacts in a block may add up to. [N s]
struct BlockLimit {
  std::uint32_t first = 0, end = 0;  // singles, relative to the block
  float capacity = 0.0f;
};

/// One normal row of a block.
struct BlockRow {
  std::uint32_t single = 0;
  int point = 0;
  bool fixed = false;   // at its limit: known, not solved for
  bool active = false;  // its impulse is positive
  double start = 0.0;   // impulse before [N s]
  double impulse = 0.0;
};

/// The rows of one light body and how they act on each other; built once, solved in every sweep.
struct Block {
  BlockRow rows[kMaxBlockRows];
  double matrix[kMaxBlockRows][kMaxBlockRows];  // speed of row i per impulse of row j
  double speed[kMaxBlockRows];                  // above target, now
  double free[kMaxBlockRows];                   // the same with no impulse in the block
  double softness[kMaxBlockRows];               // holds a row to the impulse it starts from [m/s] per N s
  int count = 0;
};

void buildBlock(const Single* singles, std::uint32_t count, Block& block);

/// All contacts of the body `light`: finds normal impulses for all rows of `singles` that leave every row at or above
/// its target speed, none negative, and applies the change to the bodies. Where a limit is exceeded, its rows are
/// scaled down to it and the others are solved again. Deterministic; at most a few factorisations of a kMaxBlockRows
/// matrix.
void solveBlock(std::uint32_t light, Single* singles, const BlockLimit* limits, std::uint32_t limitCount,
                std::vector<SolverBody>& bodies, Block& block);

}  // namespace brittle::physics
