// physics/quarantine.h - a body with a number in it that is not finite is taken out before anything reads it, so that
// one bad number never spreads.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics {

/// Removes every body with a non-finite position, rotation or velocity, logs which, and lists it in the events.
void quarantine(State& state);

}  // namespace brittle::physics
