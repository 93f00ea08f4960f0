// geometry/mass.h - volume, centre and inertia of convex polyhedra and of sums of them.
#pragma once

#include "engine/geometry/convex.h"

namespace brittle::geometry {

/// For unit density: multiply volume and inertia by the density [kg/m3] to get mass and inertia.
template <class S>
struct MassPropertiesT {
  S volume = S(0);                               // [m3]
  Vec3T<S> center = Vec3T<S>(S(0), S(0), S(0));  // centre of mass [m], in the frame of the vertices
  Mat3T<S> inertia = Mat3T<S>::Constant(S(0));   // about `center` [m5 for unit density]
};
using MassProperties = MassPropertiesT<float>;

/// Exact integrals over the polyhedron (exact for exact scalars). Sums are taken relative to the first vertex.
template <class S>
MassPropertiesT<S> massOf(const ConvexViewT<S>& convex);

/// The properties of the union of two disjoint bodies (parallel-axis theorem).
template <class S>
MassPropertiesT<S> combined(const MassPropertiesT<S>& a, const MassPropertiesT<S>& b);

MassProperties massOfSphere(float radius, const Vec3& center);

}  // namespace brittle::geometry
