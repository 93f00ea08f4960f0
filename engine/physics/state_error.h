// physics/state_error.h - what a damaged snapshot could break: every handle, slot and list of a state leads to what is
// there, so that stepping it needs no checks. Numbers that are not finite are left to quarantine.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics {

/// What is wrong with a state in a few words, or null.
const char* findError(const State& state);

}  // namespace brittle::physics
