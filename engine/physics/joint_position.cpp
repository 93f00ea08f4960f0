// Pulls jointed bodies together by moving their poses, velocities untouched: what the velocity solver left over never
// becomes speed.
#include "engine/physics/state.h"

namespace brittle::physics {

namespace {

// The most one pass corrects, so that a joint made apart closes over some ticks instead of flinging its neighbours.
// Chosen by eye.
constexpr float kMostLinear = 0.2f;   // [m]
constexpr float kMostAngular = 0.5f;  // [rad]

/// Mass with the inertia of the pose as it is now. Its velocity collects the displacement.
SolverBody massOf(const Body& body) {
  SolverBody mass;
  if (!body.isDynamic() || !body.awake) return mass;
  const Mat3 rotation = body.pose.rotation.toRotationMatrix();
  mass.invMass = body.invMass;
  mass.invInertia = rotation * body.localInvInertia * rotation.transpose();
  return mass;
}

void displace(Body& body, SolverBody& by) {
  if (by.invMass == 0.0f) return;
  body.center += by.velocity;
  body.pose.rotation = integrateRotation(body.pose.rotation, by.angularVelocity, 1.0f);
  body.placeByCenter();
  by = SolverBody{};  // a body of several joints moves once
}

/// How far the coordinate is beyond its limits, with sign. [m or rad]
float overrun(const Joint& joint, float coordinate) {
  if (joint.type == JointType::Rope) return maxOf(coordinate - joint.length, 0.0f);
  if (!joint.limited) return 0.0f;
  return coordinate - clampTo(coordinate, joint.lower, joint.upper);
}

void correctLimit(const Joint& joint, PreparedJoint& prepared, SolverBody& a, SolverBody& b) {
  const JointRows& rows = prepared.rows;
  if (!rows.hasCoordinate) return;
  const float beyond = overrun(joint, rows.coordinate + rows.coordinateRow.speed(a, b));
  if (beyond == 0.0f) return;
  const float most = joint.type == JointType::Hinge ? kMostAngular : kMostLinear;
  BoundedRow limit;
  prepared.block.factor(rows.equalities, rows.count, a, b);
  limit.prepare(rows.coordinateRow, rows, prepared.block, a, b);
  limit.response.apply(a, b, -clampTo(beyond, -most, most) * limit.mass);
}

}  // namespace

/// One Newton step on all equalities of a group, then on the limits.
void JointSolver::correctGroup(State& state, const JointGroup& group) {
  moved_.clear();
  residual_.clear();
  const ActiveJoint* const first = active_.data() + group.first;
  for (const ActiveJoint* active = first; active != first + group.count; ++active) {
    moved_.emplace_back();
    PreparedJoint& joint = moved_.back();
    joint.bodyA = active->bodyA;
    joint.bodyB = active->bodyB;
    joint.rows = measureJoint(state, state.joints.at(active->joint), active->bodyA, active->bodyB);
    moves_[active->bodyA] = massOf(state.bodies.at(active->bodyA));
    if (active->bodyB != kWorldBody) moves_[active->bodyB] = massOf(state.bodies.at(active->bodyB));
    for (std::uint32_t i = 0; i < joint.rows.count; ++i) {
      const float most = i < joint.rows.linearCount ? kMostLinear : kMostAngular;
      residual_.push_back(-clampTo(joint.rows.error[i], -most, most));
    }
  }
  moving_.factor(moved_.data(), group.count, moves_.data());
  moving_.solve(residual_.data());
  SolverBody world;
  const double* push = residual_.data();
  for (const PreparedJoint& joint : moved_) {
    SolverBody& b = joint.bodyB == kWorldBody ? world : moves_[joint.bodyB];
    for (std::uint32_t i = 0; i < joint.rows.count; ++i)
      joint.rows.equalities[i].apply(moves_[joint.bodyA], b, static_cast<float>(*push++));
  }
  for (std::uint32_t i = 0; i < group.count; ++i) {
    PreparedJoint& joint = moved_[i];
    correctLimit(state.joints.at(first[i].joint), joint, moves_[joint.bodyA],
                 joint.bodyB == kWorldBody ? world : moves_[joint.bodyB]);
  }
  for (const PreparedJoint& joint : moved_) {
    displace(state.bodies.at(joint.bodyA), moves_[joint.bodyA]);
    if (joint.bodyB != kWorldBody) displace(state.bodies.at(joint.bodyB), moves_[joint.bodyB]);
  }
}

void JointSolver::correctPositions(State& state) {
  if (groups_.empty()) return;
  if (moves_.size() < state.bodies.capacity()) moves_.resize(state.bodies.capacity());
  for (const JointGroup& group : groups_) correctGroup(state, group);
}

}  // namespace brittle::physics
