// physics/contact_prepare.h - from a manifold to solver rows and back, one lane at a time. Private to the contact
// solver.
#pragma once

#include "engine/physics/point_lanes.h"
#include "engine/physics/state.h"

namespace brittle::physics {

inline void setLane(float& target, int, float value) {
  target = value;
}
inline void setLane(Float4& target, int lane, float value) {
  target[lane] = value;
}
template <class N>
inline void setLane(Wide3<N>& target, int lane, const Vec3& value) {
  setLane(target.x, lane, value.x());
  setLane(target.y, lane, value.y());
  setLane(target.z, lane, value.z());
}
inline float lane(float value, int) {
  return value;
}
inline float lane(const Float4& value, int i) {
  return value[i];
}
template <class N>
inline Vec3 lane(const Wide3<N>& value, int i) {
  return Vec3(lane(value.x, i), lane(value.y, i), lane(value.z, i));
}

/// The time left of the tick for a pair: a striker already moved to its impact has less. [s]
inline float timeLeft(const Body& a, const Body& b, float dt) {
  return maxOf(dt - maxOf(a.timeUsed, b.timeUsed), 1e-3f * dt);
}

/// A row along `direction` at the arms rA, rB [m]; its effective mass is 1 / compliance, 0 if nothing gives way.
template <class N>
void fillRow(const SolverBody& a, const SolverBody& b, const Vec3& rA, const Vec3& rB, const Vec3& direction,
             float impulse, int i, Row<N>& row) {
  const Vec3 angularA = rA.cross(direction);
  const Vec3 angularB = rB.cross(direction);
  const Vec3 turnA = a.invInertia * angularA;
  const Vec3 turnB = b.invInertia * angularB;
  const float compliance = (a.invMass + b.invMass) + (angularA.dot(turnA) + angularB.dot(turnB));
  setLane(row.angularA, i, angularA);
  setLane(row.angularB, i, angularB);
  setLane(row.turnA, i, turnA);
  setLane(row.turnB, i, turnB);
  setLane(row.mass, i, compliance > 0.0f ? 1.0f / compliance : 0.0f);
  setLane(row.impulse, i, impulse);
}

/// The rows along the normal of all points at `places`.
template <class N>
void fillNormals(const SolverBody& a, const SolverBody& b, const Manifold& manifold, const Wide3<Float4>& places, int i,
                 ContactRows<N>& rows) {
  const Wide3<Float4> normal = splat(manifold.normal);
  const Wide3<Float4> angularA = cross(places - splat(a.center), normal);
  const Wide3<Float4> angularB = cross(places - splat(b.center), normal);
  const Wide3<Float4> turnA = product(a.invInertia, angularA);
  const Wide3<Float4> turnB = product(b.invInertia, angularB);
  const Float4 compliance = brittle::splat(a.invMass + b.invMass) + (dot(angularA, turnA) + dot(angularB, turnB));
  const Float4 mass = select(compliance > Float4{}, 1.0f / compliance, Float4{});
  for (int p = 0; p < manifold.count; ++p) {
    Row<N>& row = rows.point[p];
    setLane(row.angularA, i, lane(angularA, p));
    setLane(row.angularB, i, lane(angularB, p));
    setLane(row.turnA, i, lane(turnA, p));
    setLane(row.turnB, i, lane(turnB, p));
    setLane(row.mass, i, mass[p]);
    setLane(row.impulse, i, manifold.points[p].normalImpulse);
  }
}

template <class N>
void fillFriction(const SolverBody& a, const SolverBody& b, const Contact& contact, const Vec3& middle, float radius,
                  int i, ContactRows<N>& rows) {
  const Manifold& manifold = contact.manifold;
  const Vec3 u = perpendicular(manifold.normal);
  const Vec3 tangents[2] = {u, manifold.normal.cross(u)};
  for (int t = 0; t < 2; ++t) {
    setLane(rows.tangent[t], i, tangents[t]);
    fillRow(a, b, middle - a.center, middle - b.center, tangents[t], manifold.frictionImpulse.dot(tangents[t]), i,
            rows.slide[t]);
  }
  const Vec3 turnA = a.invInertia * manifold.normal;
  const Vec3 turnB = b.invInertia * manifold.normal;
  const float compliance = manifold.normal.dot(turnA + turnB);
  setLane(rows.twistTurnA, i, turnA);
  setLane(rows.twistTurnB, i, turnB);
  setLane(rows.twistMass, i, compliance > 0.0f ? 1.0f / compliance : 0.0f);
  setLane(rows.twistImpulse, i, manifold.twistImpulse);
  setLane(rows.twistRadius, i, radius);
  setLane(rows.friction, i, contact.friction);
}

template <class N>
void fillLane(const State& state, const Contact& contact, GapRule gap, float dt, int i, ContactRows<N>& rows) {
  const Body& bodyA = state.bodyOf(state.shapes[contact.a]);
  const Body& bodyB = state.bodyOf(state.shapes[contact.b]);
  const SolverBody& a = state.solverBodies[state.shapes[contact.a].body.index];
  const SolverBody& b = state.solverBodies[state.shapes[contact.b].body.index];
  const Manifold& manifold = contact.manifold;
  const float time = timeLeft(bodyA, bodyB, dt);
  setLane(rows.normal, i, manifold.normal);
  setLane(rows.invMassA, i, a.invMass);
  setLane(rows.invMassB, i, b.invMass);
  const Wide3<Float4> places = lanesOf(manifold, bodyA.pose, bodyB.pose).middle();
  fillNormals(a, b, manifold, places, i, rows);
  const float share = 1.0f / static_cast<float>(maxOf(manifold.count, 1));
  const Vec3 first = lane(places, 0);
  Vec3 middle = first;  // a sum of places would round by where the origin lies; differences do not
  for (int p = 0; p < manifold.count; ++p) {
    const float separation = manifold.points[p].separation;
    const bool open = separation > 0.0f && gap == GapRule::Speculative;
    setLane(rows.target[p], i, open ? -separation / time : 0.0f);
    middle += (lane(places, p) - first) * share;
  }
  float radius = 0.0f;
  for (int p = 0; p < manifold.count; ++p) radius += (lane(places, p) - middle).norm() * share;
  fillFriction(a, b, contact, middle, radius, i, rows);
}

template <class N>
void storeLane(const ContactRows<N>& rows, int i, Manifold& manifold) {
  for (int p = 0; p < manifold.count; ++p) manifold.points[p].normalImpulse = lane(rows.point[p].impulse, i);
  manifold.frictionImpulse = lane(rows.tangent[0], i) * lane(rows.slide[0].impulse, i) +
                             lane(rows.tangent[1], i) * lane(rows.slide[1].impulse, i);
  manifold.twistImpulse = lane(rows.twistImpulse, i);
}

}  // namespace brittle::physics
