// render/bake_lines.h - where the faces of a baked box are cut. Pure.
#pragma once

#include <span>
#include <vector>

#include "engine/math/aabb.h"

namespace brittle::render {

/// A face seen along one of its two axes.
struct FaceSide {
  Aabb face;       // flat along `normal`
  int normal = 0;  // axis
  int along = 0;   // axis cut
  float tile = 1;  // [m]
};

/// Places from 0 to the face's length in rising order, both included: at whole tiles, at the sides of boxes that touch
/// the face and about them, and never more than kLongestQuad apart. `near`: boxes that may touch. [m]
std::vector<float> cutLines(const FaceSide& side, std::span<const Aabb> near);

}  // namespace brittle::render
