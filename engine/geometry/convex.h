// geometry/convex.h - a convex polyhedron as a half-edge mesh with 16-bit indices. All coordinates are local to the
// body that holds it. Knows nothing of bodies, materials or drawing; everything in geometry, fracture and physics is
// built on it. Templated on its scalar: float in the engine; double and exact rationals in tests.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/plane.h"
#include "engine/math/types.h"

namespace brittle::geometry {

/// Half-edges are counted in 16 bits. [-]
inline constexpr std::uint32_t kMaxHalfEdges = 65535;

/// A vertex as the renderer uploads it: 24 bytes for float.
template <class S>
struct VertexT {
  Vec3T<S> point;                    // [m], body-local
  std::uint32_t normal = 0;          // shading normal, see packNormal; 0: none, use the face's
  std::uint32_t color = 0xffffffff;  // RGBA8, R in the lowest byte
  std::uint32_t slot = 0;            // shape slot, written by the mesh pool
};

/// What a face is: the surface the thing was made with, or broken glass.
enum class FaceKind : std::uint16_t { Surface, Cut };

template <class S>
struct FaceT {
  PlaneT<S> plane;         // outward
  std::uint16_t edge = 0;  // any half-edge of the loop
  FaceKind kind = FaceKind::Surface;
  std::uint32_t cut = 0;  // which cut made this face (unique within one breaking); 0: none
};

/// A half-edge. Loops run counter-clockwise seen from outside.
struct Edge {
  std::uint16_t face;
  std::uint16_t vertex;    // where it starts
  std::uint16_t next;      // in its face's loop
  std::uint16_t opposite;  // the same edge from the other face
};

template <class S>
struct ConvexViewT {
  std::span<const VertexT<S>> vertices;
  std::span<const FaceT<S>> faces;
  std::span<const Edge> edges;

  const Vec3T<S>& startOf(std::uint32_t edge) const { return vertices[edges[edge].vertex].point; }
  const Vec3T<S>& endOf(std::uint32_t edge) const { return vertices[edges[edges[edge].next].vertex].point; }
};

/// Owns its mesh; also what the operations write into (its vectors keep their capacity, so reuse costs no allocation).
template <class S>
struct ConvexT {
  std::vector<VertexT<S>> vertices;
  std::vector<FaceT<S>> faces;
  std::vector<Edge> edges;

  ConvexViewT<S> view() const { return {vertices, faces, edges}; }
  operator ConvexViewT<S>() const { return view(); }
  void clear() {
    vertices.clear();
    faces.clear();
    edges.clear();
  }
  void assign(const ConvexViewT<S>& other) {
    vertices.assign(other.vertices.begin(), other.vertices.end());
    faces.assign(other.faces.begin(), other.faces.end());
    edges.assign(other.edges.begin(), other.edges.end());
  }
};

using Vertex = VertexT<float>;
using Face = FaceT<float>;
using ConvexView = ConvexViewT<float>;
using Convex = ConvexT<float>;

/// A unit vector as three signed bytes with a marker byte, so that 0 stays free for "no normal".
std::uint32_t packNormal(const Vec3& normal);
Vec3 unpackNormal(std::uint32_t packed);

/// The first rule the mesh breaks, as a sentence, or null if it is a valid closed polyhedron: Euler's identity, twin
/// symmetry, closed loops of at least 3, simple and 3-connected (no vertex of degree 2, two faces share at most one
/// edge), indices in range. Topology only: no coordinate is looked at, so it is exact for every scalar.
template <class S>
const char* findTopologyError(const ConvexViewT<S>& convex);

/// The largest distance [m] of any vertex above any face's plane: 0 for a convex mesh with exact planes.
float convexityError(const ConvexView& convex);

/// The longest side of the bounding box. [m]
template <class S>
S extentOf(const ConvexViewT<S>& convex);

}  // namespace brittle::geometry
