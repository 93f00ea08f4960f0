// game/sim/score.h - the player's counts and the rules that change them. Knows no world.
#pragma once

#include <cstdint>

namespace brittle::sim {

struct Score {
  std::int32_t balls = 0;
  std::int32_t streak = 0;      // crystals broken one after another
  std::int32_t pain = 0;        // ticks the red border still shows
  std::int32_t crashPause = 0;  // ticks until the next crash counts
  std::uint32_t crashes = 0;    // since the start
  std::uint32_t breaks = 0;     // things broken since the start
  std::uint32_t crystals = 0;
  std::uint32_t cleared = 0;      // obstacles
  std::uint32_t quarantined = 0;  // bodies removed because a number in them was not finite
  std::int32_t outTicks = 0;      // since the last ball was thrown
  bool free = false;              // balls are not counted (zen)
  bool over = false;

  int ballsPerThrow() const;
  /// False if there is none left. A throw costs one whatever the number of balls in it, and nothing if it `isFree`.
  bool spendThrow(bool isFree = false);
  void winCrystal(int value, int cap);
  void missCrystal() { streak = 0; }
  /// Whether the camera may crash now.
  bool canCrash() const { return crashPause == 0; }
  /// Returns the balls it cost. Without any left the game is over.
  int crash();
  /// Once per tick, at its end. Who has no ball left is not out while throws are free.
  void tick(bool throwsAreFree = false);

  template <class Archive>
  void serialize(Archive& a) {
    a(balls);
    a(streak);
    a(pain);
    a(crashPause);
    a(crashes);
    a(breaks);
    a(crystals);
    a(cleared);
    a(quarantined);
    a(outTicks);
    a(free);
    a(over);
  }
};

}  // namespace brittle::sim
