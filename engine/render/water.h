// render/water.h - a surface of water as the vertices its shader reads. Pure packing; no GL.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/frame.h"

namespace brittle::render {

struct WaterVertex {
  Vec3 point;            // [m]
  float slopeX, slopeZ;  // of the surface there [-]
  float foam;            // [0, 1]
};

/// Refills both; triangles are counter-clockwise seen from above. The lists of `water` have the sizes that its cells
/// say.
void packWater(const Water& water, std::vector<WaterVertex>& vertices, std::vector<std::uint32_t>& indices);

}  // namespace brittle::render
