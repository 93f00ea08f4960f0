// accuracy/room.h - a whole room of the game, thrown through by a scripted player: its throws are recorded once, at the
// default, and thrown again at every setting.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/physics/accuracy.h"
#include "engine/replay/input_frame.h"
#include "game/content/asset_source.h"

namespace brittle::accuracy {

struct RoomPlay {
  std::vector<double> tickMs;  // whole ticks of the game, scripts included [ms]
  double breaks = 0.0, cleared = 0.0;
};

class Room {
 public:
  /// `assets`: the folder with player.lua. Fails with one line if the player cannot play.
  static Result<std::unique_ptr<Room>> record(const std::string& assets, int ticks);
  Result<RoomPlay> play(const physics::Accuracy& accuracy) const;

 private:
  explicit Room(const std::string& assets) : assets_({assets}) {}
  content::FolderSource assets_;
  std::vector<replay::InputFrame> inputs_;
};

}  // namespace brittle::accuracy
