#include "engine/physics/strikes.h"

#include <algorithm>

#include "engine/core/profile.h"
#include "engine/physics/collide.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/contact_prepare.h"

namespace brittle::physics {
namespace {

constexpr std::int32_t kOwnedTicks = 15;  // how long a piece spends its maker's budget (a quarter of a second)
constexpr float kSweepTarget = 0x1p-20f;  // a sweep closer than this is a hit [m]
constexpr float kWeakRatio = 0.25f;       // a closing impulse below this part of the capacity need not be swept
constexpr float kAllSpent = 0.99f;    // part of the capacity that counts as all of it; what is not stopped decides [-]
constexpr float kResidual = 2.5e-7f;  // closing speed left, relative to before, that counts as not stopped: 2 ulp

/// Who pays: a fresh piece spends the budget of the striker that broke it loose.
BodyHandle payerOf(const State& state, BodyHandle handle) {
  const Body& body = state.bodies[handle];
  const bool owned = body.striker && state.tick - body.bornTick <= kOwnedTicks && state.bodies.contains(body.striker);
  return owned ? body.striker : handle;
}

/// Whether a body breaks at all in this tick: pieces born in it are rigid for the rest of it.
bool canBreak(const State& state, const Body& body) {
  return body.breakable && body.bornTick != state.tick;
}

/// Where the budget of a pair is, or would be: budgets are sorted by striker, then struck.
std::size_t budgetIndex(const State& state, BodyHandle striker, BodyHandle struck) {
  const auto isBefore = [](const Budget& budget, const Budget& key) {
    return budget.striker == key.striker ? budget.struck < key.struck : budget.striker < key.striker;
  };
  const auto it = std::lower_bound(state.budgets.begin(), state.budgets.end(), Budget{striker, struck}, isBefore);
  return static_cast<std::size_t>(it - state.budgets.begin());
}

bool isBudgetOf(const State& state, std::size_t i, BodyHandle striker, BodyHandle struck) {
  return i < state.budgets.size() && state.budgets[i].striker == striker && state.budgets[i].struck == struck;
}

float spentOn(const State& state, BodyHandle striker, BodyHandle struck) {
  const std::size_t i = budgetIndex(state, striker, struck);
  return isBudgetOf(state, i, striker, struck) ? state.budgets[i].spent : 0.0f;
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
  for (std::uint32_t i = 0; i < strike.contactCount; ++i) {
    Contact& contact = state.contacts.at(state.strikes.contacts[strike.firstContact + i]);
    contact.passable = paid;
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

/// The body whose way is swept: the one that comes, or the struck one if the other stands still.
BodyHandle sweptBody(const State& state, const Strike& strike) {
  return state.bodies[strike.body].type == BodyType::Static ? strike.struck : strike.body;
}

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

void removeContactImpulses(State& state, const Strike& strike) {
  for (std::uint32_t i = 0; i < strike.contactCount; ++i)
    state.contacts.at(state.strikes.contacts[strike.firstContact + i]).manifold.forgetImpulses();
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

}  // namespace

// The list is sorted, so partners stand beside each other.
float spentByPartners(const Strikes& strikes, std::size_t s) {
  const std::vector<Strike>& list = strikes.list;
  const auto isPartner = [&](std::size_t i) {
    return list[i].striker == list[s].striker && list[i].struck == list[s].struck;
  };
  float spent = 0.0f;
  for (std::size_t i = s; i > 0 && isPartner(i - 1); --i) spent += list[i - 1].impulse;
  for (std::size_t i = s + 1; i < list.size() && isPartner(i); ++i) spent += list[i].impulse;
  return spent;
}

void fadeBudgets(State& state, float dt) {
  const float keep = maxOf(0.0f, 1.0f - 60.0f * dt);
  std::erase_if(state.budgets, [&](Budget& budget) {
    budget.spent *= keep;
    return budget.spent < 1e-12f || !state.bodies.contains(budget.striker) || !state.bodies.contains(budget.struck);
  });
}

void charge(State& state, BodyHandle striker, BodyHandle struck, float impulse) {
  const std::size_t i = budgetIndex(state, striker, struck);
  if (!isBudgetOf(state, i, striker, struck))
    state.budgets.insert(state.budgets.begin() + static_cast<std::ptrdiff_t>(i), Budget{striker, struck, 0.0f});
  state.budgets[i].spent += impulse;
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

bool advanceStrikers(State& state, float dt) {
  BR_ZONE("advance strikers");
  std::vector<Arrival>& arrivals = state.strikes.arrivals;
  arrivals.clear();
  if (state.accuracy.fractureMode != FractureMode::InStep) return false;
  if (releaseStrikes(state)) return true;
  for (const Strike& strike : state.strikes.list)
    if (strike.saturated) state.bodies[sweptBody(state, strike)].waitsAtGlass = true;
  for (std::uint32_t i = 0; i < state.strikes.list.size(); ++i) {
    const Strike& strike = state.strikes.list[i];
    if (strike.touching || strike.active || strike.capacity <= 0.0f ||
        state.bodies[sweptBody(state, strike)].waitsAtGlass)
      continue;
    const float time = timeReached(state, strike, dt);
    if (time >= 0.0f) arrivals.push_back({i, sweptBody(state, strike), time});
  }
  if (arrivals.empty()) return false;
  std::sort(arrivals.begin(), arrivals.end(), [](const Arrival& a, const Arrival& b) {
    if (!(a.body == b.body)) return a.body < b.body;
    return a.time != b.time ? a.time < b.time : a.strike < b.strike;
  });
  state.touchedBodies.clear();
  float firstTime = 0.0f;
  for (const Arrival& arrival : arrivals) {
    const bool first = state.touchedBodies.empty() || !(state.touchedBodies.back() == arrival.body);
    if (first) {
      firstTime = arrival.time;
      advanceBody(state, arrival.body, arrival.time);
      state.touchedBodies.push_back(arrival.body);
    }
    // What the same body reaches at the same moment (a seam between two panes) counts as well; later ones wait.
    if (arrival.time <= firstTime) markReached(state, state.strikes.list[arrival.strike]);
  }
  detectCollisionsOf(state, state.touchedBodies, dt);
  return true;
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
    if (body.isDynamic()) body.timeUsed = dt;
    if (strike.struck == last) continue;
    last = strike.struck;
    ++state.counters.held;
    ++state.counters.totalHeld;
  }
}

}  // namespace brittle::physics
