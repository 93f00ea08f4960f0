// brittle/saved.h - what is kept between two games: the player's progress, in a text file where the system keeps such
// things.
#pragma once

#include "engine/core/result.h"
#include "game/sim/progress.h"

namespace brittle::program {

/// $XDG_DATA_HOME/brittle/progress.txt, or below ~/.local/share; empty if neither is known.
std::string progressPath();

struct Saved {
  sim::Progress progress;
  std::string path;  // where it goes; empty: nowhere
};

/// None if the file is missing. Lines that cannot be read are said and left out, and the file as it was is kept beside
/// it as progress.txt.damaged, .damaged.2 and so on, for a person to look at; a file that cannot be kept stays, and
/// nothing is saved over it.
Saved loadProgress(const std::string& path);
/// Beside the old file, which stays until the new one is whole.
Status saveProgress(const Saved& saved);

}  // namespace brittle::program
