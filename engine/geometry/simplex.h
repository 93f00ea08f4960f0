// geometry/simplex.h - the point of a simplex nearest the origin: the inner step of GJK, in double. Owns no geometry.
// Source: Ericson, Real-Time Collision Detection, 2005, 5.1 and 9.5; degenerate simplices are ours.
#pragma once

#include <cstdint>

#include "engine/math/types.h"

namespace brittle::geometry {

/// A vertex of the Minkowski difference A - B, with the two vertices it came from (all in A's frame).
struct SimplexVertex {
  Vec3d w, a, b;
  std::uint32_t indexA = 0, indexB = 0;
};

struct Simplex {
  SimplexVertex vertices[4];
  double weights[4] = {1.0, 0.0, 0.0, 0.0};  // of the nearest point; sum 1
  int count = 0;

  Vec3d nearest() const {
    Vec3d sum = weights[0] * vertices[0].w;
    for (int i = 1; i < count; ++i) sum += weights[i] * vertices[i].w;
    return sum;
  }
};

/// Drops the vertices that the point nearest the origin does not need and sets the weights of the others. 4 are left
/// only if the origin is inside. Any simplex is legal, flat and repeated ones too.
void reduceToNearest(Simplex& simplex);

}  // namespace brittle::geometry
