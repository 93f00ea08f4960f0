// brittle/faults.h - what is wrong with the content of a game that is being played: each fault once, on stderr.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "game/sim/game.h"

namespace brittle::program {

class Faults {
 public:
  /// A new game begins; what was said of an earlier one is not said again.
  void restart() { next_ = 0; }
  /// What has come up in this game since the last call.
  void show(const sim::Game& game);

 private:
  std::size_t next_ = 0;  // of the game's problems, which only grow
  std::set<std::string> shown_;
};

}  // namespace brittle::program
