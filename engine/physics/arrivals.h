// physics/arrivals.h - strikers that are still on their way when a pass of the solver ends. Each is swept at the
// velocity the solver left it and moved to what it reaches first, so that first reached is first broken, at any
// distance and any phase of the tick.
#pragma once

namespace brittle::physics {

struct State;

/// Moves strikers that will reach something breakable within the tick to where they reach it first, at the velocity the
/// solver left them. Strikes that paid before they touched get their impulse back and are swept like the others. True
/// if anything changed: the solver must run again, with those that arrived touching.
bool advanceStrikers(State& state, float dt);

}  // namespace brittle::physics
