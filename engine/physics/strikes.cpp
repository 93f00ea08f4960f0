#include "engine/physics/strikes.h"

#include <algorithm>

#include "engine/core/profile.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/contact_prepare.h"
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

constexpr float kResidual = 2.5e-7f;  // closing speed left, relative to before, that counts as not stopped: 2 ulp

/// Whether a body breaks at all in this tick: pieces born in it are rigid for the rest of it.
bool canBreak(const State& state, const Body& body) {
  return body.breakable && body.bornTick != state.tick;
}

/// Which of two breakable bodies a contact may break: the weaker, by slot if equal.
bool breaksA(const State& state, const Body& a, const Body& b) {
  if (!canBreak(state, b)) return true;
  return canBreak(state, a) && a.breaking.strength < b.breaking.strength;
}

bool isGapOpen(const Contact& contact) {
  if (contact.reached) return false;
  for (int i = 0; i < contact.manifold.count; ++i)
    if (contact.manifold.points[i].separation <= 0.0f) return false;
  return true;
}

void findCandidates(State& state, std::vector<StrikeCandidate>& candidates) {
  candidates.clear();
  state.contacts.forEach([&](ContactHandle handle, Contact& contact) {
    contact.strike = kNoStrike;
    if (contact.manifold.count == 0) return;
    const BodyHandle handleA = state.shapes[contact.a].body;
    const BodyHandle handleB = state.shapes[contact.b].body;
    const Body& a = state.bodies[handleA];
    const Body& b = state.bodies[handleB];
    if ((!canBreak(state, a) && !canBreak(state, b)) || (!a.awake && !b.awake)) return;
    const bool struckIsA = breaksA(state, a, b);
    const BodyHandle struck = struckIsA ? handleA : handleB;
    const BodyHandle body = struckIsA ? handleB : handleA;
    const BodyHandle payer = payerOf(state, body);
    candidates.push_back({struck, payer == struck ? body : payer, body, handle.index});
  });
  std::sort(candidates.begin(), candidates.end());  // a total order: contact slots are unique
}

/// Speeds and place of a strike before the solve, and what it would take to stop it. Returns that impulse. [N s]
float measure(const State& state, Strike& strike) {
  float closing = 0.0f;
  bool isFirst = true;
  for (std::uint32_t i = 0; i < strike.contactCount; ++i) {
    const Contact& contact = state.contacts.at(state.strikes.contacts[strike.firstContact + i]);
    const BodyHandle handleA = state.shapes[contact.a].body;
    const Body& a = state.bodies[handleA];
    const Body& b = state.bodyOf(state.shapes[contact.b]);
    const bool struckIsA = handleA == strike.struck;
    for (int p = 0; p < contact.manifold.count; ++p) {
      const ManifoldPoint& point = contact.manifold.points[p];
      const Vec3 at = a.pose.toWorld(point.localA);
      const Vec3 other = b.pose.toWorld(point.localB);
      const Vec3 middle = 0.5f * (at + other);
      const Vec3 relative = a.velocityAt(middle) - b.velocityAt(middle);
      const float speed = contact.manifold.normal.dot(relative);
      ContactRows<float> rows;
      fillRow(state.solverBodies[handleA.index], state.solverBodies[state.shapes[contact.b].body.index],
              middle - a.center, middle - b.center, contact.manifold.normal, 0.0f, 0, rows.point[0]);
      closing = maxOf(closing, maxOf(speed, 0.0f) * rows.point[0].mass);
      strike.mass = maxOf(strike.mass, rows.point[0].mass);
      if (isFirst || speed > strike.approachSpeed) {
        strike.approachSpeed = maxOf(speed, 0.0f);
        strike.relativeVelocity = struckIsA ? Vec3(-relative) : relative;
        strike.point = struckIsA ? at : other;
        isFirst = false;
      }
    }
  }
  return closing;
}

void gatherStrikes(State& state, const std::vector<StrikeCandidate>& candidates) {
  Strikes& strikes = state.strikes;
  strikes.clear();
  for (const StrikeCandidate& candidate : candidates) {
    const bool same = !strikes.list.empty() && strikes.list.back().struck == candidate.struck &&
                      strikes.list.back().striker == candidate.striker && strikes.list.back().body == candidate.body;
    if (!same) {
      Strike& strike = strikes.list.emplace_back();
      strike.body = candidate.body;
      strike.striker = candidate.striker;
      strike.struck = candidate.struck;
      strike.firstContact = static_cast<std::uint32_t>(strikes.contacts.size());
    }
    ++strikes.list.back().contactCount;
    strikes.contacts.push_back(candidate.contact);
    state.contacts.at(candidate.contact).strike = static_cast<std::uint32_t>(strikes.list.size() - 1);
  }
}

bool touchedLastTick(const State& state, const Strike& strike) {
  for (std::uint32_t i = 0; i < strike.contactCount; ++i)
    if (state.contacts.at(state.strikes.contacts[strike.firstContact + i]).touching) return true;
  return false;
}

/// J within 1/60 s. A load that has been resting since the last tick may spend it for every 1/60 s of a longer tick.
float strengthFor(const State& state, const Strike& strike, float dt) {
  const float strength = state.bodies[strike.struck].breaking.strength;
  const float restSpeed = 2.0f * state.gravity.norm() * dt;
  const bool resting = touchedLastTick(state, strike) && strike.approachSpeed <= restSpeed;
  return resting ? strength * maxOf(1.0f, 60.0f * dt) : strength;
}

void classify(State& state, Strike& strike, float dt) {
  strike.velocityBefore = state.bodies[strike.body].velocity;
  const float closing = measure(state, strike);
  const float strength = strengthFor(state, strike, dt);
  const float spent = spentOn(state, strike.striker, strike.struck);
  strike.capacity = maxOf(strength - spent, 0.0f);
  for (std::uint32_t i = 0; i < strike.contactCount; ++i) {
    const Contact& contact = state.contacts.at(state.strikes.contacts[strike.firstContact + i]);
    strike.touching = strike.touching || !isGapOpen(contact);
    for (int p = 0; p < contact.manifold.count; ++p) strike.impulse += contact.manifold.points[p].normalImpulse;
  }
  // A piece in its maker's way is no shield and no lever: glass stops it, but only the maker's own touch breaks the
  // glass.
  strike.limit = strike.body == strike.striker ? strike.capacity : minOf(strike.capacity, strike.impulse + closing);
  bool waits = false;
  const bool paid = spent >= strength * (1.0f - 1e-6f);
  const bool mayPass = paid && state.bodies[strike.body].isDynamic();  // glass does not pass through what cannot move
  for (std::uint32_t i = 0; i < strike.contactCount; ++i) {
    Contact& contact = state.contacts.at(state.strikes.contacts[strike.firstContact + i]);
    contact.passable = mayPass;
    waits = waits || contact.waits;
  }
  strike.mayBreak = state.bodies[strike.struck].brokenTick != state.tick;
  if (state.accuracy.fractureMode == FractureMode::InStep) {
    strike.active = !paid && (strike.touching || (closing < kWeakRatio * strike.capacity && !waits));
  } else {
    strike.active = !paid;
    strike.isCapped = state.accuracy.impulseCap;
  }
}

void removeContactImpulses(State& state, const Strike& strike) {
  for (std::uint32_t i = 0; i < strike.contactCount; ++i)
    state.contacts.at(state.strikes.contacts[strike.firstContact + i]).manifold.forgetImpulses();
}

}  // namespace

// The list is sorted, so partners stand beside each other.
BodyHandle sweptBody(const State& state, const Strike& strike) {
  return state.bodies[strike.body].type == BodyType::Static ? strike.struck : strike.body;
}

void chargeStrikes(State& state, float dt) {
  if (60.0f * dt >= 1.0f) return;  // it would have faded by the next tick
  for (const Strike& strike : state.strikes.list)
    if (strike.active && strike.impulse > 0.0f) charge(state, strike.striker, strike.struck, strike.impulse);
}

void limitImpulses(State& state, float dt) {
  BR_ZONE("limit impulses");
  findCandidates(state, state.strikes.candidates);
  gatherStrikes(state, state.strikes.candidates);
  for (Strike& strike : state.strikes.list) {
    classify(state, strike, dt);
    if (!strike.active) removeContactImpulses(state, strike);
  }
}

bool findSaturated(State& state) {
  bool any = false;
  for (std::size_t s = 0; s < state.strikes.list.size(); ++s) {
    Strike& strike = state.strikes.list[s];
    if (!strike.active) continue;
    float left = 0.0f;
    float approach = strike.approachSpeed;  // the tick's own: an earlier pass may have taken it away already
    for (std::uint32_t i = 0; i < strike.contactCount; ++i) {
      const Contact& contact = state.contacts.at(state.strikes.contacts[strike.firstContact + i]);
      const SolverBody& a = state.solverBodies[state.shapes[contact.a].body.index];
      const SolverBody& b = state.solverBodies[state.shapes[contact.b].body.index];
      for (int p = 0; p < contact.manifold.count; ++p) {
        const Vec3 at = state.bodyOf(state.shapes[contact.a]).pose.toWorld(contact.manifold.points[p].localA);
        left = maxOf(left, contact.manifold.normal.dot(a.velocityAt(at - a.center) - b.velocityAt(at - b.center)));
        approach = maxOf(approach, contact.approach[p]);
      }
    }
    strike.leftSpeed = left;
    const bool spentAll = strike.impulse + spentByPartners(state.strikes, s) >= strike.capacity * kAllSpent;
    const bool stopped = left <= kResidual * approach;
    const bool inStep = state.accuracy.fractureMode == FractureMode::InStep;
    strike.saturated = spentAll && (!stopped || !strike.isCapped) && (strike.touching || !inStep);
    any = any || (strike.saturated && strike.mayBreak);
  }
  return any;
}

bool isStruckFast(const State& state, float dt) {
  return std::any_of(state.strikes.list.begin(), state.strikes.list.end(), [&](const Strike& strike) {
    // Not a fresh piece in its maker's way: small, so that it is always fast, and seen by nobody.
    if (!strike.saturated || !strike.mayBreak || !(strike.body == strike.striker)) return false;
    const float size = 2.0f * state.bodies[sweptBody(state, strike)].radius;
    return strike.relativeVelocity.norm() * dt > size;
  });
}

fracture::Impact impactOf(const State& state, const Strike& strike) {
  const Body& struck = state.bodies[strike.struck];
  const Body& body = state.bodies[strike.body];
  const Contact& contact = state.contacts.at(state.strikes.contacts[strike.firstContact]);
  const Vec3 normal =
      state.shapes[contact.a].body == strike.struck ? Vec3(-contact.manifold.normal) : contact.manifold.normal;
  fracture::Impact impact;
  impact.point = struck.pose.toLocal(strike.point);
  if (body.type != BodyType::Static) impact.toCenter = struck.pose.toLocal(body.center) - impact.point;
  impact.direction = struck.pose.unrotate(normalizedOr(strike.relativeVelocity, normal));
  impact.speed = strike.relativeVelocity.norm();
  impact.strikerRadius = body.type == BodyType::Static ? 0.0f : minOf(body.radius, struck.radius);
  return impact;
}

void holdSaturated(State& state, float dt) {
  if (state.accuracy.fractureMode != FractureMode::InStep) return;
  BodyHandle last;  // the list is sorted by who is struck
  for (const Strike& strike : state.strikes.list) {
    if (!strike.saturated) continue;
    state.held.push_back({strike.striker, strike.struck, impactOf(state, strike), strike.impulse});
    Body& body = state.bodies[sweptBody(state, strike)];
    if (body.isDynamic() && body.timeUsed != dt) {
      body.timeUsed = dt;
      state.counters.omissions.add(Omission::StoppedStriker);
    }
    if (strike.struck == last) continue;
    last = strike.struck;
    ++state.counters.held;
    state.counters.omissions.add(Omission::HeldBreak);
  }
}

}  // namespace brittle::physics
