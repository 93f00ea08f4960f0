// physics/contact_rows.h - the velocity constraints of one contact (N = float) or of four independent ones (N =
// Float4): a normal row per point, and at the middle of the points friction along two tangents and a twist about the
// normal. Private to the contact solver. Source: Catto, Iterative Dynamics with Temporal Coherence, 2005 (accumulated,
// clamped impulses).
#pragma once

#include <cstdint>

#include "engine/math/simd.h"
#include "engine/physics/manifold.h"
#include "engine/physics/solver_body.h"

namespace brittle::physics {

/// The velocities of the two bodies of a contact while its rows are solved.
template <class N>
struct PairVelocity {
  Wide3<N> linearA, angularA, linearB, angularB;
};

/// One row along a direction at a point: `angular` is arm x direction, `turn` is what a unit impulse changes of the
/// spin.
template <class N>
struct Row {
  Wide3<N> angularA, angularB, turnA, turnB;
  N mass{};     // effective [kg]; 0 for an unused lane
  N impulse{};  // accumulated [N s]
};

template <class N>
struct ContactRows {
  Wide3<N> normal;
  N invMassA{}, invMassB{};
  N friction{};
  Row<N> point[kMaxPoints];
  N target[kMaxPoints]{};  // least relative normal velocity [m/s]; negative while a gap may still close
  Wide3<N> tangent[2];
  Row<N> slide[2];
  Wide3<N> twistTurnA, twistTurnB;
  N twistMass{}, twistImpulse{}, twistRadius{};

  N speedAlong(const Wide3<N>& direction, const Row<N>& row, const PairVelocity<N>& v) const {
    return dot(direction, v.linearB - v.linearA) + (dot(row.angularB, v.angularB) - dot(row.angularA, v.angularA));
  }
  void apply(const Wide3<N>& direction, const Row<N>& row, N impulse, PairVelocity<N>& v) const {
    v.linearA = v.linearA - direction * (invMassA * impulse);
    v.angularA = v.angularA - row.turnA * impulse;
    v.linearB = v.linearB + direction * (invMassB * impulse);
    v.angularB = v.angularB + row.turnB * impulse;
  }
  N normalSum() const { return (point[0].impulse + point[1].impulse) + (point[2].impulse + point[3].impulse); }

  void warmStart(PairVelocity<N>& v) const {
    for (const Row<N>& row : point) apply(normal, row, row.impulse, v);
    for (int i = 0; i < 2; ++i) apply(tangent[i], slide[i], slide[i].impulse, v);
    v.angularA = v.angularA - twistTurnA * twistImpulse;
    v.angularB = v.angularB + twistTurnB * twistImpulse;
  }

  /// The first `count` points in `steps` steps: one after the other, and from the last one on back again. They share
  /// the normal, so the bodies' linear motion along it is one number meanwhile.
  void solveNormals(int count, int steps, bool backwards, PairVelocity<N>& v) {
    const N zero{};
    const N invMass = invMassA + invMassB;
    N parting = dot(normal, v.linearB - v.linearA);
    N sum{};
    for (int step = 0; step < steps; ++step) {
      const int there = step < count ? step : 2 * count - 2 - step;
      const int i = backwards ? count - 1 - there : there;
      Row<N>& row = point[i];
      const N speed = parting + (dot(row.angularB, v.angularB) - dot(row.angularA, v.angularA));
      const N clamped = maxOf(row.impulse - row.mass * (speed - target[i]), zero);
      const N change = clamped - row.impulse;
      row.impulse = clamped;
      parting = parting + invMass * change;
      sum = sum + change;
      v.angularA = v.angularA - row.turnA * change;
      v.angularB = v.angularB + row.turnB * change;
    }
    v.linearA = v.linearA - normal * (invMassA * sum);
    v.linearB = v.linearB + normal * (invMassB * sum);
  }

  /// Friction within the cone that the present normal impulses allow.
  void solveFriction(PairVelocity<N>& v) {
    const N limit = friction * maxOf(normalSum(), N{});  // negative while solveTall goes on: none, not 0 / 0
    N wanted[2];
    for (int i = 0; i < 2; ++i) wanted[i] = slide[i].impulse - slide[i].mass * speedAlong(tangent[i], slide[i], v);
    const N length = squareRoot(wanted[0] * wanted[0] + wanted[1] * wanted[1]);
    const N one = N{} + 1.0f;
    const N scale = select(length > limit, limit / select(length > limit, length, one), one);
    for (int i = 0; i < 2; ++i) {
      const N clamped = wanted[i] * scale;
      apply(tangent[i], slide[i], clamped - slide[i].impulse, v);
      slide[i].impulse = clamped;
    }
    const N spin = dot(normal, v.angularB - v.angularA);
    const N twistLimit = limit * twistRadius;
    const N twist = minOf(maxOf(twistImpulse - twistMass * spin, N{} - twistLimit), twistLimit);
    v.angularA = v.angularA - twistTurnA * (twist - twistImpulse);
    v.angularB = v.angularB + twistTurnB * (twist - twistImpulse);
    twistImpulse = twist;
  }
};

}  // namespace brittle::physics
