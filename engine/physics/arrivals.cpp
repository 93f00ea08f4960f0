#include "engine/physics/arrivals.h"

#include <algorithm>

#include "engine/core/profile.h"
#include "engine/physics/collide.h"
#include "engine/physics/contact_prepare.h"
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

constexpr float kSweepTarget = 0x1p-20f;  // a sweep closer than this is a hit [m]

geometry::Motion motionOf(const State& state, BodyHandle handle) {
  const Body& body = state.bodies[handle];
  const SolverBody& solved = state.solverBodies[handle.index];
  return {body.pose, body.center, solved.velocity, solved.angularVelocity};
}

/// When the two bodies of a strike first meet within the rest of the tick, at the velocities after the solve; negative:
/// never. [s]
float timeReached(const State& state, const Strike& strike, float dt) {
  float first = -1.0f;
  for (std::uint32_t i = 0; i < strike.contactCount; ++i) {
    const Contact& contact = state.contacts.at(state.strikes.contacts[strike.firstContact + i]);
    const Shape& a = state.shapes[contact.a];
    const Shape& b = state.shapes[contact.b];
    const float time = timeLeft(state.bodyOf(a), state.bodyOf(b), dt);
    const geometry::Impact impact =
        geometry::timeOfImpact(proxyOf(a, state.meshes), motionOf(state, a.body), proxyOf(b, state.meshes),
                               motionOf(state, b.body), time, kSweepTarget);
    if (impact.hit && (first < 0.0f || impact.time < first)) first = impact.time;
  }
  return first;
}

void advanceBody(State& state, BodyHandle handle, float time) {
  Body& body = state.bodies[handle];
  if (!body.isDynamic() || time <= 0.0f) return;
  const geometry::Motion motion = motionOf(state, handle);
  body.pose = geometry::poseAt(motion, time);
  body.center = body.pose.toWorld(body.localCenter);
  body.timeUsed += time;
}

void markReached(State& state, const Strike& strike) {
  for (std::uint32_t i = 0; i < strike.contactCount; ++i)
    state.contacts.at(state.strikes.contacts[strike.firstContact + i]).reached = true;
}

void undo(SolverBody& body, const Vec3& impulse, const Vec3& at) {
  body.applyImpulse(impulse, at - body.center);
}

/// Takes back what a strike's normals did to the velocities; friction through a gap is negligible and left.
void undoNormals(State& state, const Strike& strike) {
  for (std::uint32_t i = 0; i < strike.contactCount; ++i) {
    Contact& contact = state.contacts.at(state.strikes.contacts[strike.firstContact + i]);
    const BodyHandle a = state.shapes[contact.a].body;
    const BodyHandle b = state.shapes[contact.b].body;
    contact.waits = true;
    for (int p = 0; p < contact.manifold.count; ++p) {
      ManifoldPoint& point = contact.manifold.points[p];
      const Vec3 at = 0.5f * (state.bodies[a].pose.toWorld(point.localA) + state.bodies[b].pose.toWorld(point.localB));
      undo(state.solverBodies[a.index], contact.manifold.normal * point.normalImpulse, at);
      undo(state.solverBodies[b.index], contact.manifold.normal * -point.normalImpulse, at);
      point.normalImpulse = 0.0f;
    }
  }
}

/// Something pushed a weak strike to its limit through a gap that is still open: it would pay now and again when it
/// touches.
bool paidThroughGap(const State& state, std::size_t s) {
  const Strike& strike = state.strikes.list[s];
  const float spent = strike.impulse + spentByPartners(state.strikes, s);
  return !strike.touching && spent >= strike.capacity * kAllSpent && strike.impulse > 0.0f;
}

/// Something drove a piece against glass, so that it may break what its own motion could not when that was measured.
bool wasDriven(const State& state, const Strike& strike) {
  if (strike.body == strike.striker || strike.leftSpeed * strike.mass < kWeakRatio * strike.capacity) return false;
  for (std::uint32_t i = 0; i < strike.contactCount; ++i)
    if (state.contacts.at(state.strikes.contacts[strike.firstContact + i]).waits) return false;  // once per tick
  return true;
}

/// They get their impulse back and wait for the sweep like the strong ones.
bool releaseStrikes(State& state) {
  state.touchedBodies.clear();
  for (std::size_t s = 0; s < state.strikes.list.size(); ++s) {
    Strike& strike = state.strikes.list[s];
    if (!strike.active || !(paidThroughGap(state, s) || wasDriven(state, strike))) continue;
    undoNormals(state, strike);
    state.touchedBodies.push_back(strike.body);
    state.touchedBodies.push_back(strike.struck);
  }
  if (state.touchedBodies.empty()) return false;
  state.contactSolver.storeBodies(state);
  return true;
}

/// Which strikes get there within the tick: by body, then by time. Who stands at glass that did not give way goes
/// nowhere.
void findArrivals(State& state, float dt) {
  std::vector<Arrival>& arrivals = state.strikes.arrivals;
  arrivals.clear();
  for (const Strike& strike : state.strikes.list)
    if (strike.saturated) state.bodies[sweptBody(state, strike)].waitsAtGlass = true;
  for (std::uint32_t i = 0; i < state.strikes.list.size(); ++i) {
    const Strike& strike = state.strikes.list[i];
    const BodyHandle body = sweptBody(state, strike);
    const bool isOnItsWay = !strike.touching && !strike.active && strike.capacity > 0.0f;
    if (!isOnItsWay || state.bodies[body].waitsAtGlass) continue;
    const float time = timeReached(state, strike, dt);
    if (time >= 0.0f) arrivals.push_back({i, body, time});
  }
  std::sort(arrivals.begin(), arrivals.end(), [](const Arrival& a, const Arrival& b) {
    if (!(a.body == b.body)) return a.body < b.body;
    return a.time != b.time ? a.time < b.time : a.strike < b.strike;
  });
}

/// Each body as far as what it reaches first.
void moveToArrivals(State& state) {
  state.touchedBodies.clear();
  float firstTime = 0.0f;
  for (const Arrival& arrival : state.strikes.arrivals) {
    const bool isFirst = state.touchedBodies.empty() || !(state.touchedBodies.back() == arrival.body);
    if (isFirst) {
      firstTime = arrival.time;
      advanceBody(state, arrival.body, arrival.time);
      state.touchedBodies.push_back(arrival.body);
    }
    // What the same body reaches at the same moment (a seam between two panes) counts as well; later ones wait.
    if (arrival.time <= firstTime) markReached(state, state.strikes.list[arrival.strike]);
  }
}

}  // namespace

bool advanceStrikers(State& state, float dt) {
  BR_ZONE("advance strikers");
  if (state.accuracy.fractureMode != FractureMode::InStep) return false;
  if (releaseStrikes(state)) return true;
  findArrivals(state, dt);
  if (state.strikes.arrivals.empty()) return false;
  moveToArrivals(state);
  detectCollisionsOf(state, state.touchedBodies, dt);
  return true;
}

}  // namespace brittle::physics
