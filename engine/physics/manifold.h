// physics/manifold.h - where two shapes touch or are about to: up to 4 points with one normal, kept and refreshed from
// tick to tick.
#pragma once

#include <cstdint>

#include "engine/core/archive.h"
#include "engine/geometry/gjk.h"
#include "engine/math/transform.h"

namespace brittle::physics {

inline constexpr int kMaxPoints = 4;

struct ManifoldPoint {
  Vec3 localA = Vec3::Zero();  // in the local frame of A's body [m]
  Vec3 localB = Vec3::Zero();
  float separation = 0.0f;     // along the normal [m]; negative: overlap
  float normalImpulse = 0.0f;  // accumulated this tick; next tick's warm start [N s]

  template <class Archive>
  void serialize(Archive& a) {
    a(localA);
    a(localB);
    a(separation);
    a(normalImpulse);
  }
};

struct Manifold {
  Vec3 normal = Vec3::UnitY();  // unit, world, from A towards B
  ManifoldPoint points[kMaxPoints];
  std::int32_t count = 0;
  // Friction acts at the middle of the points: two tangents and a twist about the normal. World; the solver's own.
  Vec3 frictionImpulse = Vec3::Zero();  // [N s]
  float twistImpulse = 0.0f;            // [N m s]
  geometry::SimplexCache simplex;
  // What the points were computed at: while the pair hardly moves, they are only refreshed (contact recycling). Whoever
  // puts points in by hand, or changes a mesh, leaves or sets `computed` false and the next update searches afresh.
  Transform computedAt;              // B's pose seen from A
  Vec3 localNormal = Vec3::UnitY();  // the normal in A's frame, or in B's:
  bool normalOfB = false;            // it is that of a face of B and turns with it
  float reach = 0.0f;           // farthest vertex of the smaller shape from the first point [m]; negative: not known
  float computedMargin = 0.0f;  // [m]
  bool computed = false;
  bool seeded = false;  // came from the cut, not from a search

  void forgetImpulses() {
    for (ManifoldPoint& point : points) point.normalImpulse = 0.0f;
    frictionImpulse.setZero();
    twistImpulse = 0.0f;
  }

  template <class Archive>
  void serialize(Archive& a) {
    a(normal);
    for (ManifoldPoint& point : points) a(point);
    a(count);
    a(frictionImpulse);
    a(twistImpulse);
    a(simplex.count);
    a(simplex.a);
    a(simplex.b);
    a(simplex.axis);
    a(computedAt.position);
    a(computedAt.rotation);
    a(localNormal);
    a(normalOfB);
    a(reach);
    a(computedMargin);
    a(computed);
    a(seeded);
  }
};

enum class ManifoldKind : std::uint8_t {
  Incremental,  // GJK's closest points, one more each tick, up to 4 kept
  Clipped,      // the two facing faces clipped against each other, all points at once
};

struct ManifoldSettings {
  ManifoldKind kind = ManifoldKind::Clipped;
  float recycleDistance = 0.01f;  // refresh instead of recompute while the pair moved less than this fraction of the
                                  // smaller shape's inner radius [-]; 0: always recompute. Measured: at 0.1 a stack of
                                  // ten falls where it stands with 0
};

/// Brings the manifold of a pair up to date: points closer than `margin` [m] (speculative ones have positive
/// separation), accumulated impulses kept with the points that survive. No points: the pair is further apart than the
/// margin. `sizeA` and `sizeB` are the inner radii [m], which tolerances are relative to. No allocation once the
/// scratch is warm. The normal is that of a face where one is nearly along the direction of least distance and the pair
/// is close, or exactly along it at any distance; else it is that direction itself, with one point.
void updateManifold(const geometry::Proxy& a, const Transform& poseA, float sizeA, const geometry::Proxy& b,
                    const Transform& poseB, float sizeB, float margin, const ManifoldSettings& settings,
                    Manifold& manifold);

}  // namespace brittle::physics
