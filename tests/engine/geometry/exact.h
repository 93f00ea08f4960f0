// Exact rationals for the oracles: the engine's own templates instantiated with them.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstring>

#include "engine/geometry/convex_impl.h"
#include "engine/geometry/make_impl.h"
#include "engine/geometry/mass_impl.h"
#include "engine/geometry/split_impl.h"

namespace brittle::geometry {

using Exact = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

inline Vec3T<Exact> exactOf(const Vec3& v) {
  return Vec3T<Exact>(Exact(v.x()), Exact(v.y()), Exact(v.z()));
}
inline PlaneT<Exact> exactOf(const Plane& plane) {
  return {exactOf(plane.normal), Exact(plane.offset)};
}

inline ConvexT<Exact> exactOf(const Convex& convex) {
  ConvexT<Exact> result;
  for (const Vertex& vertex : convex.vertices) result.vertices.push_back({exactOf(vertex.point)});
  for (const Face& face : convex.faces) result.faces.push_back({exactOf(face.plane), face.edge, face.kind, face.cut});
  result.edges = convex.edges;
  return result;
}

/// The same half-edges under the same numbers.
inline bool isSameTopology(const Convex& a, const ConvexT<Exact>& b) {
  return a.edges.size() == b.edges.size() &&
         std::memcmp(a.edges.data(), b.edges.data(), a.edges.size() * sizeof(Edge)) == 0;
}

/// Whether every vertex lies on the same side of the plane as its exact counterpart.
inline bool agreesOnSigns(const Convex& a, const ConvexT<Exact>& b, const Plane& plane) {
  const PlaneT<Exact> exactPlane = exactOf(plane);
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    if ((plane.distance(a.vertices[i].point) < 0.0f) != (exactPlane.distance(b.vertices[i].point) < 0)) return false;
  }
  return true;
}

}  // namespace brittle::geometry
