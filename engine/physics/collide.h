// physics/collide.h - collision detection: boxes into the tree, new pairs, and every manifold up to date.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics {

/// For all awake bodies, once a tick.
void detectCollisions(State& state, float dt);
/// For the given bodies only: made or moved within the tick.
void detectCollisionsOf(State& state, const std::vector<BodyHandle>& bodies, float dt);
/// Once the solver has given bodies new velocities: pairs that only meet at those. They have no points yet.
void findPairsOnTheWay(State& state, float dt);

/// Puts a new shape into the tree.
void insertProxy(State& state, ShapeHandle shape);

/// The tight box of a shape that moves, the tree's own of one that rests.
const Aabb& currentBox(const State& state, const Shape& shape, std::uint32_t slot);

/// How far a pair may be apart or overlap and still count as touching. [m]
float contactSlop(const Shape& a, const Shape& b);

}  // namespace brittle::physics
