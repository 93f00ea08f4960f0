#include "engine/physics/stack.h"

#include <algorithm>

#include "engine/core/profile.h"
#include "engine/physics/collide.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/contact_prepare.h"
#include "engine/physics/pair_velocity.h"

namespace brittle::physics {
namespace {
constexpr float kUpright = 0.98f;   // cosine: what is steeper than 11 degrees rather wedges than bears (measured) [-]
constexpr std::uint32_t kPile = 2;  // bodies that stand on each other and are held [-]
constexpr int kTall = 4;            // bodies: the default sweeps do for what is lower (measured) [-]
constexpr int kRoundsPerLevel = 2;  // measured: with one, a stack that must fall stays for two seconds
constexpr int kMostRounds = 200;    // whatever the height
constexpr int kSweeps = 10;         // over the supports of one body; most need two
constexpr float kStill = 1e-6f;     // of what gravity adds in a tick: slower changes are rounding [-]
constexpr float kSlow = 2.0f;       // of the same: what is faster does not stand [-]

bool isGround(const Body& body) {
  return !body.isDynamic() || !body.awake;
}

/// How far a body that stood falls in a tick without what it stands on. [m]
float fallOf(const State& state, float dt) {
  return state.gravity.norm() * dt * dt;
}

bool isReached(const State& state, const Contact& contact, float dt) {
  const Shape& a = state.shapes[contact.a];
  const Shape& b = state.shapes[contact.b];
  const float reach = contactSlop(a, b) + minOf(fallOf(state, dt), minOf(a.innerRadius, b.innerRadius));
  for (int i = 0; i < contact.manifold.count; ++i)
    if (contact.manifold.points[i].separation <= reach) return true;
  return false;
}

/// Visits the contacts of a body with what is under it, or where it would fall to within the tick: visit(contact, other
/// body).
template <class Visit>
void forEachSupport(const State& state, BodyHandle handle, float dt, Visit&& visit) {
  const Vec3 up = -state.gravity.normalized();
  forEachShape(state, state.bodies[handle], [&](ShapeHandle, const Shape& shape) {
    forEachContact(state, shape, [&](std::uint32_t slot, std::uint32_t side) {
      const Contact& contact = state.contacts.at(slot);
      const float upright = contact.manifold.normal.dot(up) * (side == 0 ? -1.0f : 1.0f);
      if (contact.manifold.count > 0 && upright > kUpright && !contact.passable && isReached(state, contact, dt))
        visit(contact, state.shapes[side == 0 ? contact.b : contact.a].body);
      return true;
    });
  });
}

}  // namespace

void Stacks::findStanding(const State& state, float dt) {
  standing_.clear();
  const float slowest = kSlow * state.gravity.norm() * dt;
  state.bodies.forEach([&](BodyHandle handle, const Body& body) {
    if (!body.isDynamic() || !body.awake) return;
    if (body.velocity.norm() + body.angularVelocity.norm() * body.radius > slowest) return;
    standing_.push_back({-state.gravity.dot(body.center), handle});
  });
}

std::uint32_t Stacks::findLevels(const State& state, float dt) {
  std::sort(standing_.begin(), standing_.end());
  level_.assign(state.bodies.capacity(), 0);
  std::uint32_t tallest = 0;
  for (const Standing& one : standing_) {
    std::uint32_t level = 0;
    forEachSupport(state, one.body, dt, [&](const Contact&, BodyHandle under) {
      const std::uint32_t below = level_[under.index];
      if (isGround(state.bodies[under]))
        level = maxOf(level, 1u);
      else if (below > 0)
        level = maxOf(level, below + 1);
    });
    level_[one.body.index] = level;
    tallest = maxOf(tallest, level);
  }
  return tallest;
}

void Stacks::gatherSupports(const State& state, BodyHandle body, float dt) {
  supports_.clear();
  forEachSupport(state, body, dt, [&](const Contact& contact, BodyHandle under) {
    if (!isGround(state.bodies[under]) && level_[under.index] == 0) return;
    Support& support = supports_.emplace_back();
    support.bodyA = state.shapes[contact.a].body.index;
    support.bodyB = state.shapes[contact.b].body.index;
    support.points = contact.manifold.count;
    fillLane(state, contact, GapRule::Speculative, dt, 0, support.rows);
  });
}

void Stacks::holdBody(State& state, BodyHandle handle, float dt) {
  gatherSupports(state, handle, dt);
  SolverBody& self = state.solverBodies[handle.index];
  const float still = kStill * state.gravity.norm() * dt;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const Vec3 velocity = self.velocity;
    const Vec3 spin = self.angularVelocity;
    for (Support& support : supports_) {
      PairVelocity<float> v = loadPair(state.solverBodies, support.bodyA, support.bodyB);
      support.rows.solveFriction(v);
      support.rows.solveNormals(support.points, 2 * support.points - 1, sweep % 2 != 0, v);
      storePair(state.solverBodies, support.bodyA, support.bodyB, v);
    }
    const float turned = (self.angularVelocity - spin).norm() * state.bodies[handle].radius;
    if ((self.velocity - velocity).norm() + turned < still) break;
  }
  self.invMass = 0.0f;  // to what stands on it
  self.invInertia.setZero();
}

void Stacks::measure(const State& state, float dt) {
  BR_ZONE("measure stacks");
  height_ = 0;
  if (!state.accuracy.stacks || state.gravity.isZero()) return;
  findStanding(state, dt);
  if (standing_.size() < kPile) return;
  const std::uint32_t tallest = findLevels(state, dt);
  if (tallest >= kPile) height_ = static_cast<int>(tallest);
}

int Stacks::rounds() const {
  return height_ < kTall ? 0 : minOf(kRoundsPerLevel * height_, kMostRounds);
}

void Stacks::hold(State& state, float dt) {
  BR_ZONE("hold stacks");
  if (height_ == 0) return;
  findStanding(state, dt);  // again: what was hit or broke stands no more
  findLevels(state, dt);
  for (const Standing& one : standing_)
    if (level_[one.body.index] > 0) holdBody(state, one.body, dt);
  for (const Standing& one : standing_) {
    Body& body = state.bodies[one.body];
    SolverBody& packed = state.solverBodies[one.body.index];
    body.velocity = packed.velocity;
    body.angularVelocity = packed.angularVelocity;
    packed.invMass = body.invMass;
    packed.invInertia = body.invInertia;
  }
}

}  // namespace brittle::physics
