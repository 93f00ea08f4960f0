#include "engine/geometry/mass.h"

#include "engine/geometry/mass_impl.h"

namespace brittle::geometry {

double mass_detail::smallestPivot(const Mat3d& m) {
  const double d0 = m(0, 0);
  if (!(d0 > 0.0)) return d0;
  const double l10 = m(1, 0) / d0;
  const double l20 = m(2, 0) / d0;
  const double d1 = m(1, 1) - l10 * m(1, 0);
  if (!(d1 > 0.0)) return d1;
  const double l21 = (m(2, 1) - l20 * m(1, 0)) / d1;
  const double d2 = m(2, 2) - l20 * m(2, 0) - l21 * l21 * d1;
  return minOf(minOf(d0, d1), d2);
}

void mass_detail::regularize(Mat3& inertia) {
  constexpr double kSmallestShare = 0x1p-20;  // 8 units in the last place of a float, relative to the trace
  const Mat3d m = inertia.cast<double>();
  const double trace = m(0, 0) + m(1, 1) + m(2, 2);
  const double determinant = m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(1, 2)) -
                             m(0, 1) * (m(0, 1) * m(2, 2) - m(1, 2) * m(0, 2)) +
                             m(0, 2) * (m(0, 1) * m(1, 2) - m(1, 1) * m(0, 2));
  // The two larger moments multiply to at most (trace / 2)^2.
  const double smallest = 4.0 * determinant / (trace * trace);
  if (!(trace > 0.0) || smallest > kSmallestShare * trace) return;
  for (int i = 0; i < 3; ++i) inertia(i, i) += static_cast<float>(2.0 * kSmallestShare * trace);
}

MassProperties massOfSphere(float radius, const Vec3& center) {
  MassProperties result;
  const double r = radius;
  const double volume = 4.0 / 3.0 * 3.14159265358979323846 * r * r * r;
  result.volume = static_cast<float>(volume);
  result.center = center;
  result.inertia = Mat3::Identity() * static_cast<float>(0.4 * volume * r * r);
  return result;
}

template MassPropertiesT<float> massOf<float>(const ConvexViewT<float>&);
template MassPropertiesT<double> massOf<double>(const ConvexViewT<double>&);
template MassPropertiesT<float> combined<float>(const MassPropertiesT<float>&, const MassPropertiesT<float>&);
template MassPropertiesT<double> combined<double>(const MassPropertiesT<double>&, const MassPropertiesT<double>&);

}  // namespace brittle::geometry
