// geometry/mass_impl.h - the bodies of mass.h's templates. Include it only to instantiate them for another scalar;
// float and double are instantiated in mass.cpp.
#pragma once

#include <type_traits>

#include "engine/geometry/mass.h"

namespace brittle::geometry::mass_detail {

/// Integrals are summed in double for float: a piece of aspect 2^-16 would lose all digits of its volume in float.
template <class S>
using Sum = std::conditional_t<std::is_same_v<S, float>, double, S>;

/// Volume, first and second moments about an origin, as sums over tetrahedra with a corner in that origin. Polynomials
/// of the vertex coordinates, so exact for exact scalars. Source: Blow and Binstock, How to Find the Inertia Tensor (or
/// Other Mass Properties) of a 3D Solid Body, 2004.
template <class A>
struct Moments {
  A sixVolume = A(0);
  A first[3] = {A(0), A(0), A(0)};                                                // 24 times the integral of x
  A second[3][3] = {{A(0), A(0), A(0)}, {A(0), A(0), A(0)}, {A(0), A(0), A(0)}};  // 120 times that of x x^T

  void addTetrahedron(const A (&a)[3], const A (&b)[3], const A (&c)[3]) {
    const A determinant =
        a[0] * A(b[1] * c[2] - b[2] * c[1]) + a[1] * A(b[2] * c[0] - b[0] * c[2]) + a[2] * A(b[0] * c[1] - b[1] * c[0]);
    sixVolume += determinant;
    for (int i = 0; i < 3; ++i) {
      const A sumI = a[i] + b[i] + c[i];
      first[i] += determinant * sumI;
      for (int j = i; j < 3; ++j) {
        const A sumJ = a[j] + b[j] + c[j];
        second[i][j] += determinant * A(a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + sumI * sumJ);
      }
    }
  }
};

template <class S, class A>
Moments<A> momentsOf(const ConvexViewT<S>& convex, const Vec3T<S>& origin) {
  Moments<A> moments;
  const auto relative = [&](std::uint32_t edge, A(&out)[3]) {
    for (int i = 0; i < 3; ++i) out[i] = A(convex.startOf(edge)[i]) - A(origin[i]);
  };
  for (const FaceT<S>& face : convex.faces) {
    A corner[3], previous[3], current[3];
    relative(face.edge, corner);
    std::uint32_t edge = convex.edges[face.edge].next;
    relative(edge, previous);
    for (edge = convex.edges[edge].next; edge != face.edge; edge = convex.edges[edge].next) {
      relative(edge, current);
      moments.addTetrahedron(corner, previous, current);
      for (int i = 0; i < 3; ++i) previous[i] = current[i];
    }
  }
  return moments;
}

/// Smallest pivot of the Cholesky factorisation: never below the smallest eigenvalue, and positive only if all are.
double smallestPivot(const Mat3d& matrix);

/// Keeps the tensor of a float needle positive definite: rounding to float can cost a long thin piece its smallest
/// moment. Adds less than 1e-5 of the tensor, and only where it is needed.
void regularize(Mat3& inertia);

/// The properties of the bounding box, but with this volume.
template <class S>
MassPropertiesT<S> massOfBounds(const ConvexViewT<S>& convex, const S& volume) {
  Vec3T<S> low = convex.vertices[0].point;
  Vec3T<S> high = low;
  MassPropertiesT<S> result;
  result.volume = volume;
  Vec3T<S> square;
  for (int i = 0; i < 3; ++i) {
    for (const VertexT<S>& vertex : convex.vertices) {
      low[i] = minOf<S>(low[i], vertex.point[i]);
      high[i] = maxOf<S>(high[i], vertex.point[i]);
    }
    result.center[i] = (low[i] + high[i]) / S(2);
    square[i] = (high[i] - low[i]) * (high[i] - low[i]);
  }
  for (int i = 0; i < 3; ++i) result.inertia(i, i) = volume * (square[(i + 1) % 3] + square[(i + 2) % 3]) / S(12);
  return result;
}

}  // namespace brittle::geometry::mass_detail

namespace brittle::geometry {

template <class S>
MassPropertiesT<S> massOf(const ConvexViewT<S>& convex) {
  using A = mass_detail::Sum<S>;
  MassPropertiesT<S> result;
  if (convex.vertices.empty()) return result;
  const Vec3T<S> origin = convex.vertices[0].point;
  const mass_detail::Moments<A> moments = mass_detail::momentsOf<S, A>(convex, origin);
  if (!(A(0) < moments.sixVolume)) {
    result.center = origin;
    return result;
  }
  A center[3], covariance[3][3];
  const A volume = moments.sixVolume / A(6);
  for (int i = 0; i < 3; ++i) center[i] = moments.first[i] / (A(4) * moments.sixVolume);
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) covariance[i][j] = moments.second[i][j] / A(120) - volume * center[i] * center[j];
  }
  if constexpr (std::is_floating_point_v<S>) {
    Mat3d matrix;
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j) matrix(i, j) = matrix(j, i) = covariance[i][j];
    }
    // A speck thinner than its caps are rough is partly inside out; no integral over it describes a body.
    if (!(mass_detail::smallestPivot(matrix) > 0.0)) return mass_detail::massOfBounds<S>(convex, S(volume));
  }
  result.volume = S(volume);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    result.center[i] = S(A(origin[i]) + center[i]);
    result.inertia(i, i) = S(covariance[j][j] + covariance[k][k]);
    const A& product = covariance[minOf(j, k)][maxOf(j, k)];
    result.inertia(j, k) = S(-product);
    result.inertia(k, j) = S(-product);
  }
  if constexpr (std::is_same_v<S, float>) mass_detail::regularize(result.inertia);
  return result;
}

template <class S>
MassPropertiesT<S> combined(const MassPropertiesT<S>& a, const MassPropertiesT<S>& b) {
  using A = mass_detail::Sum<S>;
  const A volumeA = A(a.volume);
  const A volumeB = A(b.volume);
  const A volume = volumeA + volumeB;
  if (!(A(0) < volumeA)) return b;
  if (!(A(0) < volumeB)) return a;
  const A shareB = volumeB / volume;
  const A reduced = volumeA * shareB;
  A between[3];
  for (int i = 0; i < 3; ++i) between[i] = A(b.center[i]) - A(a.center[i]);
  const A square = between[0] * between[0] + between[1] * between[1] + between[2] * between[2];
  MassPropertiesT<S> result;
  result.volume = S(volume);
  for (int i = 0; i < 3; ++i) {
    result.center[i] = S(A(a.center[i]) + shareB * between[i]);
    for (int j = 0; j < 3; ++j) {
      const A shift = (i == j ? square : A(0)) - between[i] * between[j];
      result.inertia(i, j) = S(A(a.inertia(i, j)) + A(b.inertia(i, j)) + reduced * shift);
    }
  }
  return result;
}

}  // namespace brittle::geometry
