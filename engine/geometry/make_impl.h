// geometry/make_impl.h - the body of make.h's template, and the one way to build a half-edge mesh from loops of
// vertices. Include it only to instantiate makeBox for another scalar; float and double are instantiated in make.cpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/make.h"

namespace brittle::geometry::make_detail {

/// Faces as loops of vertices, counter-clockwise seen from outside: loop i is corners[starts[i]] to corners[starts[i +
/// 1] - 1].
struct Loops {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> starts = {0};
  void close() { starts.push_back(static_cast<std::uint32_t>(corners.size())); }
  std::uint32_t count() const { return static_cast<std::uint32_t>(starts.size()) - 1; }
};

/// Makes the half-edges and faces (planes left alone) of `convex`, whose vertices stand already. False, with `convex`
/// half made, if the loops do not close up to a mesh: an edge without its opposite, or more than 16 bits of half-edges.
template <class S>
bool linkLoops(const Loops& loops, ConvexT<S>& convex) {
  const std::size_t count = loops.corners.size();
  if (count > kMaxHalfEdges) return false;
  convex.edges.resize(count);
  convex.faces.resize(loops.count());
  std::vector<std::pair<std::uint64_t, std::uint32_t>> byEnds(count);  // edges from a to b, keyed without direction
  for (std::uint32_t face = 0; face < loops.count(); ++face) {
    const std::uint32_t first = loops.starts[face];
    const std::uint32_t end = loops.starts[face + 1];
    convex.faces[face].edge = static_cast<std::uint16_t>(first);
    for (std::uint32_t i = first; i < end; ++i) {
      const std::uint32_t next = i + 1 == end ? first : i + 1;
      const std::uint64_t a = loops.corners[i];
      const std::uint64_t b = loops.corners[next];
      convex.edges[i] = {static_cast<std::uint16_t>(face), static_cast<std::uint16_t>(a),
                         static_cast<std::uint16_t>(next), 0};
      byEnds[i] = {a < b ? a << 32 | b : b << 32 | a, i};
    }
  }
  std::sort(byEnds.begin(), byEnds.end());
  if (count % 2 != 0) return false;
  for (std::size_t i = 0; i < count; i += 2) {
    const std::uint32_t a = byEnds[i].second;
    const std::uint32_t b = byEnds[i + 1].second;
    if (byEnds[i].first != byEnds[i + 1].first || convex.edges[a].vertex == convex.edges[b].vertex) return false;
    convex.edges[a].opposite = static_cast<std::uint16_t>(b);
    convex.edges[b].opposite = static_cast<std::uint16_t>(a);
  }
  return true;
}

/// Planes through the corners of every face, summed in double. Source: Newell's method, in Sutherland, Sproull,
/// Schumacker, A Characterization of Ten Hidden-Surface Algorithms, 1974.
void fitPlanes(Convex& convex);

}  // namespace brittle::geometry::make_detail

namespace brittle::geometry {

template <class S>
ConvexT<S> makeBox(const Vec3T<S>& halfExtents, const Vec3T<S>& center) {
  // Corner i lies on the high side of axis k if bit k of i is set. Faces: -X, +X, -Y, +Y, -Z, +Z.
  static constexpr std::uint32_t kCorners[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                   {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  ConvexT<S> box;
  box.vertices.resize(8);
  for (std::uint32_t i = 0; i < 8; ++i) {
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const bool isHigh = (i >> axis & 1) != 0;
      box.vertices[i].point[axis] = isHigh ? S(center[axis] + halfExtents[axis]) : S(center[axis] - halfExtents[axis]);
    }
  }
  make_detail::Loops loops;
  for (const auto& face : kCorners) {
    loops.corners.insert(loops.corners.end(), face, face + 4);
    loops.close();
  }
  make_detail::linkLoops(loops, box);
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t axis = i / 2;
    const S sign = i % 2 == 0 ? S(-1) : S(1);
    Vec3T<S> normal(S(0), S(0), S(0));
    normal[axis] = sign;
    const S& coordinate = box.vertices[i % 2 == 0 ? 0 : 7].point[axis];
    box.faces[i].plane = {normal, sign * coordinate};
  }
  return box;
}

}  // namespace brittle::geometry
