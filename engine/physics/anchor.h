// physics/anchor.h - where a breakable body holds to the static world.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics {

/// Marks which shapes of a body touch static geometry over an area, and where. A static body that touches nothing holds
/// everywhere. Returns how many shapes are anchored.
std::uint32_t findAnchors(State& state, BodyHandle body);

}  // namespace brittle::physics
