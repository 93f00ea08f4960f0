// game/sim/progress.h - what a player has reached over several games: the balls stored for each checkpoint, and which
// game follows one that is over or was broken off. Knows no file: a text in, a text out.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "game/sim/game.h"

namespace brittle::sim {

class Progress {
 public:
  /// A line "BALLS ROOM LEVEL" for each checkpoint. Lines that are none are left out and named in `problems`.
  static Progress parse(const std::string& text, const std::string& file, std::vector<std::string>& problems);
  std::string text() const;

  /// The checkpoint before room `room` of `level` was passed with `balls`. True if they are more than were stored, and
  /// now are.
  bool pass(const std::string& level, std::uint32_t room, std::int32_t balls);
  /// To start there with: what is stored, or rules::kStartBalls.
  std::int32_t ballsAt(const std::string& level, std::uint32_t room) const;

 private:
  std::map<std::pair<std::string, std::uint32_t>, std::int32_t> balls_;
};

/// The game that follows: after a level's end the next of `levels` (the last repeats), else from the last checkpoint
/// again, without a title. Its seed differs, so that rooms that draw their order draw it anew.
GameDef nextGame(const Game& game, const Progress& progress, const std::vector<std::string>& levels);

}  // namespace brittle::sim
