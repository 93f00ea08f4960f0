#include "engine/physics/fracture_stage.h"

#include "engine/physics/arrivals.h"
#include "engine/physics/breakage.h"
#include "engine/physics/collide.h"
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

constexpr int kUnboundedRounds = 1000;  // fractureRounds 0: a guard, far beyond what a tick's way can hold

int maxRounds(const Accuracy& accuracy) {
  if (accuracy.fractureMode != FractureMode::InStep) return 0;
  return accuracy.fractureRounds == 0 ? kUnboundedRounds : accuracy.fractureRounds;
}

/// Whether what is saturated breaks in this tick still.
bool mayBreakOn(const State& state, int round, float dt) {
  if (round < maxRounds(state.accuracy)) return true;
  if (state.accuracy.fractureMode != FractureMode::InStep || round >= state.accuracy.fastRounds) return false;
  return isStruckFast(state, dt);
}

}  // namespace

void beginBreaking(State& state, float dt) {
  fadeBudgets(state, dt);
  breakHeld(state);
}

bool breakOrAdvance(State& state, int& round, float dt) {
  if (!findSaturated(state) || !mayBreakOn(state, round, dt)) return advanceStrikers(state, dt);
  fractureSaturated(state);
  detectCollisionsOf(state, state.touchedBodies, dt);
  state.counters.rounds = static_cast<std::uint32_t>(++round);
  return true;
}

void endBreaking(State& state, float dt) {
  holdSaturated(state, dt);
  chargeStrikes(state, dt);
}

}  // namespace brittle::physics
