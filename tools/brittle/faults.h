// brittle/faults.h - what is wrong with the content of a game that is being played: each fault once, on stderr.
#pragma once

#include <set>
#include <string>

#include "game/sim/game.h"

namespace brittle::program {

class Faults {
 public:
  /// What has come up since; the same fault in a later game is not said again.
  void show(const sim::Game& game);

 private:
  std::set<std::string> shown_;
};

}  // namespace brittle::program
