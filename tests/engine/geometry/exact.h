// Exact rationals for the oracles: the engine's own templates instantiated with them.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

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

}  // namespace brittle::geometry
