#include "game/sim/score.h"

#include "engine/math/types.h"
#include "game/sim/constants.h"

namespace brittle::sim {

int Score::ballsPerThrow() const {
  return minOf(rules::kMaxVolley, streak / rules::kStreakPerBall + 1);
}

bool Score::spendThrow(bool isFree) {
  if (over) return false;
  if (free || isFree) return true;
  if (balls <= 0) return false;
  --balls;
  return true;
}

void Score::winCrystal(int value, int cap) {
  balls = minOf(balls + value, cap);
  ++streak;
  ++crystals;
}

int Score::crash() {
  const int cost = free ? 0 : minOf(balls, rules::kCrashCost);
  balls -= cost;
  streak = 0;
  ++crashes;
  pain = rules::kPainTicks;
  crashPause = rules::kCrashPause;
  over = over || (!free && balls == 0);
  return cost;
}

void Score::tick(bool throwsAreFree) {
  if (pain > 0) --pain;
  if (crashPause > 0) --crashPause;
  // A ball that was thrown last may still win some back.
  outTicks = !free && !throwsAreFree && balls <= 0 ? outTicks + 1 : 0;
  if (outTicks > rules::kLastBallTicks) over = true;
}

}  // namespace brittle::sim
