#include "engine/physics/integrate.h"

#include "engine/core/profile.h"
#include "engine/effects/has/joints.h"
#include "engine/physics/collide.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/contact_prepare.h"
#include "engine/physics/edit.h"
#include "engine/physics/sweep.h"

namespace brittle::physics {
namespace {

constexpr float kPushRatio = 0.2f;  // part of the overlap removed per pass [-]; more makes stacks jitter
constexpr float kMaxPush = 0.1f;    // of the smaller inner radius, per pass [-]

/// The velocities that bring an animated body to its target in this tick.
void followTarget(Body& body, float dt) {
  if (!body.hasTarget) {
    body.velocity.setZero();
    body.angularVelocity.setZero();
    return;
  }
  body.velocity = (body.target.toWorld(body.localCenter) - body.center) / dt;
  body.angularVelocity = rotationBetween(body.pose.rotation, body.target.rotation) / dt;
}

void moveAnimated(State& state) {
  state.bodies.forEach([&](BodyHandle, Body& body) {
    if (body.type != BodyType::Animated || !body.hasTarget) return;
    body.pose = body.target;
    body.placeByPose();
    body.hasTarget = false;
    body.target = {};
  });
}

/// A push turns a body by little: to first order, and back to unit length.
void displace(Body& body, const Vec3& way, const Vec3& turn) {
  body.center += way;
  Quat& rotation = body.pose.rotation;
  rotation.coeffs() += 0.5f * (Quat(0.0f, turn.x(), turn.y(), turn.z()) * rotation).coeffs();
  rotation.normalize();
  body.placeByCenter();
}

void pushApart(State& state, const Contact& contact) {
  const Shape& shapeA = state.shapes[contact.a];
  const Shape& shapeB = state.shapes[contact.b];
  Body& a = state.bodyOf(shapeA);
  Body& b = state.bodyOf(shapeB);
  const float invMassA = a.awake ? a.invMass : 0.0f;
  const float invMassB = b.awake ? b.invMass : 0.0f;
  if (invMassA + invMassB == 0.0f) return;
  const float slop = contactSlop(shapeA, shapeB);
  const Vec3& normal = contact.manifold.normal;
  for (int i = 0; i < contact.manifold.count; ++i) {
    const ManifoldPoint& point = contact.manifold.points[i];
    if (point.separation > 0.0f) continue;  // it was open when the tick began: the next one sees what it has become
    const Vec3 onA = a.pose.toWorld(point.localA);
    const Vec3 onB = b.pose.toWorld(point.localB);
    const float overlap = -(onB - onA).dot(normal) - slop;
    if (overlap <= 0.0f) continue;
    const float push = minOf(kPushRatio * overlap, kMaxPush * minOf(shapeA.innerRadius, shapeB.innerRadius));
    const Vec3 angularA = (onA - a.center).cross(normal);
    const Vec3 angularB = (onB - b.center).cross(normal);
    const Vec3 turnA = invMassA > 0.0f ? Vec3(a.invInertia * angularA) : Vec3(Vec3::Zero());
    const Vec3 turnB = invMassB > 0.0f ? Vec3(b.invInertia * angularB) : Vec3(Vec3::Zero());
    const float compliance = invMassA + invMassB + angularA.dot(turnA) + angularB.dot(turnB);
    const float impulse = push / compliance;
    if (invMassA > 0.0f) displace(a, normal * (-impulse * invMassA), turnA * -impulse);
    if (invMassB > 0.0f) displace(b, normal * (impulse * invMassB), turnB * impulse);
  }
}

bool isOverlapping(const Contact& contact) {
  for (int i = 0; i < contact.manifold.count; ++i)
    if (contact.manifold.points[i].separation <= 0.0f) return true;
  return false;
}

}  // namespace

void integrateVelocities(State& state, float dt) {
  state.bodies.forEach([&](BodyHandle, Body& body) {
    body.timeUsed = 0.0f;
    body.waitsAtGlass = false;
    if (body.type == BodyType::Animated) followTarget(body, dt);
    if (!body.isDynamic() || !body.awake) return;
    body.velocity += state.gravity * (body.gravityScale * dt);
    refreshInertia(body);
  });
}

void integratePositions(State& state, float dt) {
  BR_ZONE("integrate positions");
  findPairsOnTheWay(state, dt);
  beginSweeps(state);
  moveAnimated(state);
  for (const Heavy& next : state.moveOrder) sweepBody(state, next.body, dt);
}

void correctPositions(State& state) {
  BR_ZONE("correct positions");
  state.overlapping.clear();
  state.contacts.forEach([&](ContactHandle handle, const Contact& contact) {
    if (isOverlapping(contact) && !contact.passable) state.overlapping.push_back(handle.index);
  });
  for (int pass = 0; pass < state.accuracy.positionIterations; ++pass) {
    for (const std::uint32_t slot : state.overlapping) pushApart(state, state.contacts.at(slot));
    if constexpr (effects::kHasJoints) state.jointSolver.correctPositions(state);
  }
  confineBodies(state);
}

}  // namespace brittle::physics
