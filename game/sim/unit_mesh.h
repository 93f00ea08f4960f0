// game/sim/unit_mesh.h - the named unit solids that scripts build from: prisms, a pyramid, a diamond. Ours, made from
// points.
#pragma once

#include <string>

#include "engine/core/result.h"
#include "engine/geometry/convex.h"

namespace brittle::sim {

/// "pyramid", "diamond", "pin", "3gon" to "6gon", "triangle", "triangle2", "circleseg", "circleseg6": within the cube
/// of half extent 0.5 about the origin. An error names the value.
Result<geometry::Convex> unitMesh(const std::string& name);

}  // namespace brittle::sim
