// physics/integrate.h - velocities from forces before the solver, positions from velocities after it. Fast bodies are
// swept, so that nothing small passes through what does not move out of its way.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics {

/// Gravity, animation targets, world inertia.
void integrateVelocities(State& state, float dt);
void integratePositions(State& state, float dt);
/// Pushes overlapping pairs apart by moving positions only: no velocity changes, so penetration breaks nothing.
void correctPositions(State& state);

}  // namespace brittle::physics
