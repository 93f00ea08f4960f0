// physics/solver_body.h - what the velocity solver reads and writes of a body, packed.
#pragma once

#include "engine/math/types.h"

namespace brittle::physics {

/// Indexed by body slot. Static and animated bodies have zero inverse mass and inertia: writing their velocity is
/// harmless.
struct SolverBody {
  Vec3 velocity = Vec3::Zero();         // [m/s]
  float pad = 0.0f;                     // so that a velocity is read and written as four lanes
  Vec3 angularVelocity = Vec3::Zero();  // [rad/s]
  float angularPad = 0.0f;
  float invMass = 0.0f;            // [1/kg]
  Vec3 center = Vec3::Zero();      // world [m]
  Mat3 invInertia = Mat3::Zero();  // world [1/(kg m2)]

  void applyImpulse(const Vec3& impulse, const Vec3& arm) {
    velocity += impulse * invMass;
    angularVelocity += invInertia * arm.cross(impulse);
  }
  Vec3 velocityAt(const Vec3& arm) const { return velocity + angularVelocity.cross(arm); }
};

}  // namespace brittle::physics
