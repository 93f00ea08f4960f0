// physics/collide.h - collision detection: boxes into the tree, new pairs, and every manifold up to date.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics {

/// For all awake bodies, once a tick.
void detectCollisions(State& state, float dt);
/// For the given bodies only: made or moved within the tick.
void detectCollisionsOf(State& state, const std::vector<BodyHandle>& bodies, float dt);

/// Puts a new shape into the tree.
void insertProxy(State& state, ShapeHandle shape);

/// How far a pair may be apart or overlap and still count as touching. [m]
float contactSlop(const Shape& a, const Shape& b);

}  // namespace brittle::physics
