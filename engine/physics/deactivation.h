// physics/deactivation.h - each body decides for itself when to rest, wakes by touch, and nothing stays floating when
// its support goes. No islands.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics {

/// Puts bodies to rest that were slow for a quarter of a second and stand on something, or for half of one and hang (by
/// joints, or without weight); wakes what is touched by something moving.
void deactivate(State& state, float dt);

void wakeBody(State& state, BodyHandle body);
/// Wakes every body that touches the shape, and all that rest on those in turn: their support may be going.
void wakeTouching(State& state, ShapeHandle shape);

}  // namespace brittle::physics
