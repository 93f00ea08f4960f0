// physics/joint_move.h - how far a joint's anchor is from a shape: who holds it, at creation and after a split. Of the
// joint files.
#pragma once

#include "engine/math/types.h"
#include "engine/physics/shape.h"

namespace brittle::physics {

struct State;

/// From `anchorLocal` (in the frame of the shape's body) to the shape; 0 inside. [m]
float anchorDistance(const State& state, const Shape& shape, const Vec3& anchorLocal);

}  // namespace brittle::physics
