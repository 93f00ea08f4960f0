// physics/recycle.h - what ends a tick: which contacts touch, who hit whom, and full pools recycled by rule.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics {

/// Notes which contacts touch (deactivation and resting loads ask) and reports new hits.
void finishContacts(State& state);
/// Beyond Accuracy::maxBodies dynamic pieces, the oldest become debris, resting ones first.
void recycleBodies(State& state);

}  // namespace brittle::physics
