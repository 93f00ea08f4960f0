// brittle/saved.h - what is kept between two games: the player's progress, in a text file where the system keeps such
// things.
#pragma once

#include "engine/core/result.h"
#include "game/sim/progress.h"

namespace brittle::program {

/// $XDG_DATA_HOME/brittle/progress.txt, or below ~/.local/share; empty if neither is known.
std::string progressPath();
/// None if the file is missing; lines that cannot be read are said once and left out.
sim::Progress loadProgress(const std::string& path);
/// Beside the old file, which stays until the new one is whole.
Status saveProgress(const sim::Progress& progress, const std::string& path);

}  // namespace brittle::program
