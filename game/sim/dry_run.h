// game/sim/dry_run.h - what playing a level would report, found without a player and in a part of the time: every room
// is made as the game makes it, and the camera passes through it in strides.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "game/content/asset_source.h"

namespace brittle::sim {

struct DryRun {
  std::vector<std::string> problems;  // each once, as Game::problems() has them
  std::uint32_t rooms = 0;            // of the level, that were made
};

/// How much is done, and whether to go on.
using DryRunGoesOn = std::function<bool(std::uint32_t done, std::uint32_t of)>;

/// levels/NAME.xml in classic mode, and what only training and mayhem have. Every room's script runs, with the seed
/// that its place gives it, and every obstacle's starts and runs for a few ticks; but of rooms that are the same, type
/// and attributes, only those of the first three places are passed through, and of different ones about the first 200.
DryRun dryRun(const content::AssetSource& assets, const std::string& level, const DryRunGoesOn& goesOn);

}  // namespace brittle::sim
