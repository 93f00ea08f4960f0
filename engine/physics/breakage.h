// physics/breakage.h - glass that breaks inside the step: swaps a broken body for its pieces (fracture knows the
// geometry, this knows the bodies), now, or first thing in the next tick for what was held.
#pragma once

#include <cstdint>

#include "engine/fracture/fracture.h"
#include "engine/physics/ids.h"

namespace brittle::physics {

struct State;

/// Breaks a body by impacts given in its frame. Its pieces are bodies when this returns, with the velocities they had
/// as parts of it; contacts among them are seeded from the cut. Crumbs become debris. Returns how many bodies were
/// made.
std::uint32_t breakBody(State& state, BodyHandle body, const fracture::Impact* impacts, std::uint32_t count,
                        BodyHandle striker);

/// Breaks the bodies that this round's strikes saturated, each once, by all of its strikers together.
void fractureSaturated(State& state);

/// The older ways, for comparison: breaks what the step saturated after positions have moved.
void fractureAfterStep(State& state);

/// Breaks what was held in the last tick; its strikers have paid.
void breakHeld(State& state);

}  // namespace brittle::physics
