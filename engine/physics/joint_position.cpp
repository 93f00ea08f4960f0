// Pulls jointed bodies together by moving their poses, velocities untouched: what the velocity solver left over never becomes speed.
#include "engine/physics/state.h"

namespace brittle::physics {

namespace {

// The most one pass corrects, so that a joint made apart closes over some ticks instead of flinging its neighbours. Chosen by eye.
constexpr float kMostLinear = 0.2f;   // [m]
constexpr float kMostAngular = 0.5f;  // [rad]

/// Mass and centre as the rows need them, with the inertia of the pose as it is now. Its velocity collects the displacement.
SolverBody massOf(const Body* body) {
  SolverBody mass;
  if (!body || !body->isDynamic() || !body->awake) return mass;
  const Mat3 rotation = body->pose.rotation.toRotationMatrix();
  mass.invMass = body->invMass;
  mass.invInertia = rotation * body->localInvInertia * rotation.transpose();
  return mass;
}

void displace(Body* body, const SolverBody& by) {
  if (!body || by.invMass == 0.0f) return;
  body->center += by.velocity;
  body->pose.rotation = integrateRotation(body->pose.rotation, by.angularVelocity, 1.0f);
  body->placeByCenter();
}

/// How far the coordinate is beyond its limits, with sign. [m or rad]
float overrun(const Joint& joint, float coordinate) {
  if (joint.type == JointType::Rope) return maxOf(coordinate - joint.length, 0.0f);
  if (!joint.limited) return 0.0f;
  return coordinate - clampTo(coordinate, joint.lower, joint.upper);
}

/// One Newton step on the equalities, then on the limit without disturbing them.
void correct(const Joint& joint, Body* a, Body* b) {
  const JointRows rows =
      measureJoint(joint, a->pose, a->center, b ? b->pose : Transform{}, b ? b->center : Vec3(Vec3::Zero()));
  SolverBody massA = massOf(a);
  SolverBody massB = massOf(b);
  EqualityBlock block;
  block.factor(rows.equalities, rows.count, massA, massB);
  float push[kMaxEqualities];
  for (std::uint32_t i = 0; i < rows.count; ++i) {
    const float most = i < rows.linearCount ? kMostLinear : kMostAngular;
    push[i] = -clampTo(rows.error[i], -most, most);
  }
  block.solve(push);
  for (std::uint32_t i = 0; i < rows.count; ++i) rows.equalities[i].apply(massA, massB, push[i]);
  const float beyond = rows.hasCoordinate ? overrun(joint, rows.coordinate) : 0.0f;
  if (beyond != 0.0f) {
    const float most = joint.type == JointType::Hinge ? kMostAngular : kMostLinear;
    BoundedRow limit;
    limit.prepare(rows.coordinateRow, rows, block, massA, massB);
    limit.response.apply(massA, massB, -clampTo(beyond, -most, most) * limit.mass);
  }
  displace(a, massA);
  displace(b, massB);
}

}  // namespace

void JointSolver::correctPositions(State& state) {
  for (const PreparedJoint& prepared : joints_) {
    if (!state.joints.isAlive(prepared.joint)) continue;
    const Joint& joint = state.joints.at(prepared.joint);
    const Shape* shapeA = state.shapes.find(joint.a);
    const Shape* shapeB = state.shapes.find(joint.b);
    if (!shapeA || (joint.b && !shapeB) || (shapeB && shapeA->body == shapeB->body)) continue;
    correct(joint, &state.bodies[shapeA->body], shapeB ? &state.bodies[shapeB->body] : nullptr);
  }
}

}  // namespace brittle::physics
