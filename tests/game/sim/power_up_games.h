// tests/game/sim/power_up_games.h - a power-up straight ahead, a player who collects it and uses it.
#pragma once

#include <string>

#include "tests/game/sim/fixture.h"

namespace brittle::sim {

/// Where a throw straight ahead comes by.
inline std::string pickupAt(const std::string& type, const std::string& place = "0 1 -6") {
  return "<powerup pos=\"" + place + "\" type=\"" + type + "\"/>";
}

inline replay::InputFrame usePlace(int place) {
  replay::InputFrame frame;
  frame.buttons = replay::useBit(place);
  return frame;
}

/// Throws ahead and waits until something is collected; false if nothing is.
inline bool collect(Game& game) {
  const std::size_t before = game.hud().powerUps.size();
  game.tick(throwAt(0.0f, 0.0f));
  for (int i = 0; i < 60 && game.hud().powerUps.size() == before; ++i) game.tick({});
  return game.hud().powerUps.size() > before;
}

inline bool collectAndUse(Game& game) {
  if (!collect(game)) return false;
  game.tick(usePlace(0));
  return game.hud().powerUps[0].runs;
}

}  // namespace brittle::sim
