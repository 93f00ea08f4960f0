// geometry/convex_impl.h - the bodies of convex.h's templates. Include it only to instantiate them for another scalar
// (tests do, with exact rationals); float and double are instantiated in convex.cpp.
#pragma once

#include "engine/geometry/convex.h"

namespace brittle::geometry {
namespace convex_detail {

/// The half-edge that leaves the same vertex next, clockwise seen from outside.
inline std::uint32_t turned(std::span<const Edge> edges, std::uint32_t edge) {
  return edges[edges[edge].opposite].next;
}

/// Work space of findTopologyError, one per thread, so that checking millions of pieces allocates nothing.
struct TopologyScratch {
  std::vector<std::uint16_t> stamps;
  std::vector<std::uint16_t> pending;
};
TopologyScratch& topologyScratch();

/// Everything findTopologyError checks; it needs no coordinates, only how faces name their first edge.
const char* findEdgeError(std::span<const Edge> edges, std::uint32_t vertexCount,
                          std::span<const std::uint16_t> firstEdges);

}  // namespace convex_detail

template <class S>
const char* findTopologyError(const ConvexViewT<S>& convex) {
  static thread_local std::vector<std::uint16_t> firstEdges;
  firstEdges.clear();
  for (const FaceT<S>& face : convex.faces) firstEdges.push_back(face.edge);
  return convex_detail::findEdgeError(convex.edges, static_cast<std::uint32_t>(convex.vertices.size()), firstEdges);
}

template <class S>
S extentOf(const ConvexViewT<S>& convex) {
  if (convex.vertices.empty()) return S(0);
  Vec3T<S> low = convex.vertices[0].point;
  Vec3T<S> high = low;
  for (const VertexT<S>& vertex : convex.vertices) {
    for (int i = 0; i < 3; ++i) {
      if (vertex.point[i] < low[i]) low[i] = vertex.point[i];
      if (high[i] < vertex.point[i]) high[i] = vertex.point[i];
    }
  }
  S longest = S(0);
  for (int i = 0; i < 3; ++i) {
    const S side = high[i] - low[i];
    if (longest < side) longest = side;
  }
  return longest;
}

}  // namespace brittle::geometry
