#include "engine/physics/integrate.h"

#include "engine/core/profile.h"
#include "engine/physics/collide.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/contact_prepare.h"
#include "engine/physics/edit.h"

namespace brittle::physics {
namespace {

constexpr float kFastRatio = 0.5f;      // swept if it moves further than this part of its inner radius [-]
constexpr int kMaxSlides = 3;           // surfaces a fast body may slide along within a tick
constexpr float kPushRatio = 0.2f;      // part of the overlap removed per pass [-]; more makes stacks jitter
constexpr float kMaxPush = 0.1f;        // of the smaller inner radius, per pass [-]

/// The velocities that bring an animated body to its target in this tick.
void followTarget(Body& body, float dt) {
  if (!body.hasTarget) {
    body.velocity.setZero();
    body.angularVelocity.setZero();
    return;
  }
  body.velocity = (body.target.toWorld(body.localCenter) - body.center) / dt;
  Quat turn = body.target.rotation * body.pose.rotation.conjugate();
  if (turn.w() < 0.0f) turn.coeffs() = -turn.coeffs();
  const float s = turn.vec().norm();
  const float angle = 2.0f * arcTangent(s, turn.w());
  body.angularVelocity = s > 1e-9f ? Vec3(turn.vec() * (angle / (s * dt))) : Vec3(Vec3::Zero());
}

void moveBody(Body& body, float time) {
  body.center += body.velocity * time;
  body.pose.rotation = integrateRotation(body.pose.rotation, body.angularVelocity, time);
  body.placeByCenter();
}

/// What stops a fast body: things that do not give way.
bool isObstacle(const State& state, const Body& mover, const Body& other) {
  return !other.isDynamic() || !other.awake || (state.tick != other.bornTick && other.mass > 5.0f * mover.mass);
}

struct Stop {
  bool hit = false;
  float time = 0.0f;
  Vec3 normal = Vec3::UnitY();  // away from the obstacle
};

Stop firstObstacle(const State& state, const Body& body, float time) {
  Stop stop;
  const geometry::Motion motion{body.pose, body.center, body.velocity, body.angularVelocity};
  forEachShape(state, body, [&](ShapeHandle, const Shape& shape) {
    forEachContact(state, shape, [&](std::uint32_t slot, std::uint32_t side) {
      const Contact& contact = state.contacts.at(slot);
      const Shape& other = state.shapes[side == 0 ? contact.b : contact.a];
      const Body& obstacle = state.bodyOf(other);
      if (contact.passable || !isObstacle(state, body, obstacle)) return true;
      const float target = contactSlop(shape, other);
      const geometry::Motion otherMotion{obstacle.pose, obstacle.center, obstacle.velocity, obstacle.angularVelocity};
      const geometry::Impact impact = geometry::timeOfImpact(proxyOf(shape, state.meshes), motion, proxyOf(other, state.meshes),
                                                             otherMotion, time, target);
      // A pair that touches already is the solver's: stopping it at time 0 would hold it in place while its velocity grows.
      if (impact.hit && impact.time > 0.0f && (!stop.hit || impact.time < stop.time)) stop = {true, impact.time, Vec3(-impact.normal)};
      return true;
    });
  });
  return stop;
}

/// Moves to the first obstacle, then along it with what is left of the time. Velocity is left alone: the next tick's contact
/// deals with it.
void moveSwept(State& state, Body& body, float time) {
  const Vec3 velocity = body.velocity;
  const Vec3 spin = body.angularVelocity;
  for (int i = 0; i < kMaxSlides && time > 0.0f; ++i) {
    const Stop stop = firstObstacle(state, body, time);
    moveBody(body, stop.hit ? stop.time : time);
    if (!stop.hit) break;
    time -= stop.time;
    body.velocity -= stop.normal * minOf(body.velocity.dot(stop.normal), 0.0f);
    body.angularVelocity.setZero();
    if (i == kMaxSlides - 1) time = 0.0f;
  }
  body.velocity = velocity;
  body.angularVelocity = spin;
}

bool isFast(const Body& body, float time) {
  const float way = (body.velocity.norm() + body.angularVelocity.norm() * body.radius) * time;
  return way > kFastRatio * body.innerRadius;
}

void displace(Body& body, const Vec3& way, const Vec3& turn) {
  body.center += way;
  body.pose.rotation = integrateRotation(body.pose.rotation, turn, 1.0f);
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
    const Vec3 armA = onA - a.center;
    const Vec3 armB = onB - b.center;
    const Vec3 turnA = invMassA > 0.0f ? Vec3(a.invInertia * armA.cross(normal)) : Vec3(Vec3::Zero());
    const Vec3 turnB = invMassB > 0.0f ? Vec3(b.invInertia * armB.cross(normal)) : Vec3(Vec3::Zero());
    const float compliance = invMassA + invMassB + armA.cross(normal).dot(turnA) + armB.cross(normal).dot(turnB);
    const float impulse = push / compliance;
    if (invMassA > 0.0f) displace(a, normal * (-impulse * invMassA), turnA * -impulse);
    if (invMassB > 0.0f) displace(b, normal * (impulse * invMassB), turnB * impulse);
  }
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
  state.bodies.forEach([&](BodyHandle, Body& body) {
    if (body.type == BodyType::Animated && body.hasTarget) {
      body.pose = body.target;
      body.placeByPose();
      body.hasTarget = false;
    }
    if (!body.isDynamic() || !body.awake) return;
    const float time = dt - body.timeUsed;
    body.timeUsed = 0.0f;
    if (time <= 0.0f) return;
    if (isFast(body, time)) {
      ++state.counters.swept;
      moveSwept(state, body, time);
    } else {
      moveBody(body, time);
    }
  });
}

void correctPositions(State& state) {
  for (int pass = 0; pass < state.accuracy.positionIterations; ++pass) {
    state.contacts.forEach([&](ContactHandle, const Contact& contact) {
      if (contact.manifold.count > 0 && !contact.passable) pushApart(state, contact);
    });
    state.jointSolver.correctPositions(state);
  }
}

}  // namespace brittle::physics
