#include "engine/physics/solver.h"

#include <algorithm>

#include "engine/core/profile.h"
#include "engine/effects/has/drives.h"
#include "engine/effects/has/joints.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/contact_prepare.h"
#include "engine/physics/pair_velocity.h"
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

/// Whether a point was hit hard enough to rebound.
bool rebounds(const Contact& contact, int point) {
  constexpr float kSlowest = 0.5f;  // [m/s] below, things come to rest; chosen by eye
  return contact.approach[point] >= kSlowest && contact.manifold.points[point].normalImpulse > 0.0f;
}

}  // namespace

void ContactSolver::loadBodies(State& state) {
  bodies_ = &state.solverBodies;
  bodies_->assign(state.bodies.capacity() + 1, SolverBody{});  // the last one is nobody: unused lanes point at it
  state.bodies.forEach([&](BodyHandle handle, const Body& body) {
    SolverBody& packed = (*bodies_)[handle.index];
    packed.center = body.center;
    packed.velocity = body.velocity;
    packed.angularVelocity = body.angularVelocity;
    if (!body.isDynamic() || !body.awake) return;
    packed.invMass = body.invMass;
    packed.invInertia = body.invInertia;
  });
}

void ContactSolver::storeBodies(State& state) const {
  state.bodies.forEach([&](BodyHandle handle, Body& body) {
    if (!body.isDynamic() || !body.awake) return;
    body.velocity = (*bodies_)[handle.index].velocity;
    body.angularVelocity = (*bodies_)[handle.index].angularVelocity;
  });
}

void ContactSolver::prepare(State& state, float dt, bool warmStart) {
  singles_.clear();
  groups_.clear();
  blockCount_ = 0;
  findLightBodies(state);
  for (std::uint32_t light = 0; light < isLight_.size(); ++light)
    if (isLight_[light] != 0) buildBlock(state, light, dt);
  buildStrikes(state, dt);
  colorContacts(state);
  buildBatches(state, dt);
  if (warmStart) warmStartRows(state);
}

// Greedy: each contact takes the first colour that neither of its moving bodies has yet. Slot order, so always the
// same.
void ContactSolver::colorContacts(State& state) {
  for (auto& list : byColor_) list.clear();
  colorMasks_.assign(bodies_->size(), 0);
  for (const std::uint32_t slot : state.reach.contacts) {
    const Contact& contact = state.contacts.at(slot);
    if (contact.strike != kNoStrike || contact.solvedAlone) continue;
    const std::uint32_t a = state.shapes[contact.a].body.index;
    const std::uint32_t b = state.shapes[contact.b].body.index;
    const bool movesA = (*bodies_)[a].invMass > 0.0f;
    const bool movesB = (*bodies_)[b].invMass > 0.0f;
    if (!movesA && !movesB) continue;
    const std::uint32_t taken = (movesA ? colorMasks_[a] : 0u) | (movesB ? colorMasks_[b] : 0u);
    int color = 0;
    while (color < kColors && (taken >> color & 1u) != 0) ++color;
    if (color < kColors) {
      if (movesA) colorMasks_[a] |= 1u << color;
      if (movesB) colorMasks_[b] |= 1u << color;
    }
    byColor_[color].push_back(slot);
  }
}

void ContactSolver::buildBatches(State& state, float dt) {
  batchCount_ = 0;
  const auto nobody = static_cast<std::uint32_t>(bodies_->size() - 1);
  for (int color = 0; color <= kColors; ++color) {
    const std::uint32_t width = color < kColors ? kLanes : 1;
    for (std::size_t first = 0; first < byColor_[color].size(); first += width) {
      if (batchCount_ == batches_.size()) batches_.emplace_back();
      Batch& batch = batches_[batchCount_++];
      batch = Batch{};
      const std::size_t end = minOf(first + width, byColor_[color].size());
      for (int lane = 0; lane < kLanes; ++lane) batch.bodyA[lane] = batch.bodyB[lane] = nobody;
      for (std::size_t i = first; i < end; ++i) {
        const int lane = batch.lanes++;
        const Contact& contact = state.contacts.at(byColor_[color][i]);
        batch.contact[lane] = byColor_[color][i];
        batch.bodyA[lane] = state.shapes[contact.a].body.index;
        batch.bodyB[lane] = state.shapes[contact.b].body.index;
        batch.points = maxOf(batch.points, contact.manifold.count);
        fillLane(state, contact, GapRule::Speculative, dt, lane, batch.rows);
      }
    }
  }
}

/// The body slot of the one that something much heavier that moves pushes: impulses through it would creep. Or nobody.
std::uint32_t ContactSolver::lighterOf(const State& state, const Contact& contact) const {
  const float ratio = state.accuracy.directSolveMassRatio;
  const std::uint32_t a = state.shapes[contact.a].body.index;
  const std::uint32_t b = state.shapes[contact.b].body.index;
  const float invMassA = (*bodies_)[a].invMass;
  const float invMassB = (*bodies_)[b].invMass;
  if (ratio <= 0.0f || invMassA == 0.0f || invMassB == 0.0f) return kNobody;
  if (invMassA > ratio * invMassB) return a;
  return invMassB > ratio * invMassA ? b : kNobody;
}

void ContactSolver::findLightBodies(State& state) {
  isLight_.assign(bodies_->size(), 0);
  for (const std::uint32_t slot : state.reach.contacts) {
    Contact& contact = state.contacts.at(slot);
    contact.solvedAlone = false;
    const std::uint32_t light = lighterOf(state, contact);
    if (light != kNobody) isLight_[light] = 1;
  }
}

void ContactSolver::addSingle(State& state, std::uint32_t slot, float dt) {
  Contact& contact = state.contacts.at(slot);
  contact.solvedAlone = true;
  Single& single = singles_.emplace_back();
  single.contact = slot;
  single.strike = contact.strike;
  single.bodyA = state.shapes[contact.a].body.index;
  single.bodyB = state.shapes[contact.b].body.index;
  single.points = contact.manifold.count;
  const bool touching = contact.strike != kNoStrike && state.strikes.list[contact.strike].touching;
  fillLane(state, contact, touching ? GapRule::Touching : GapRule::Speculative, dt, 0, single.rows);
}

/// The contacts of a light body that is squeezed, that is, touched by more than one other; strikes kept together.
void ContactSolver::buildBlock(State& state, std::uint32_t light, float dt) {
  blockContacts_.clear();
  int rows = 0;
  bool squeezed = false;
  std::uint32_t firstOther = kNobody;
  forEachShape(state, state.bodies.at(light), [&](ShapeHandle, const Shape& shape) {
    forEachContact(state, shape, [&](std::uint32_t slot, std::uint32_t side) {
      const Contact& contact = state.contacts.at(slot);
      const bool waits = contact.strike != kNoStrike && !state.strikes.list[contact.strike].active;
      const bool isTakenIn =
          contact.manifold.count > 0 && state.reach.takesIn(state.shapes[contact.a].body, state.shapes[contact.b].body);
      if (!isTakenIn || contact.solvedAlone || waits) return true;
      const std::uint32_t other = state.shapes[side == 0 ? contact.b : contact.a].body.index;
      squeezed = squeezed || (firstOther != kNobody && other != firstOther);
      firstOther = other;
      rows += contact.manifold.count;
      blockContacts_.push_back(slot);
      return true;
    });
  });
  if (!squeezed || rows > kMaxBlockRows) return;
  std::sort(blockContacts_.begin(), blockContacts_.end(), [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t strikeA = state.contacts.at(a).strike;
    const std::uint32_t strikeB = state.contacts.at(b).strike;
    return strikeA != strikeB ? strikeA < strikeB : a < b;
  });
  const auto first = static_cast<std::uint32_t>(singles_.size());
  for (const std::uint32_t slot : blockContacts_) addSingle(state, slot, dt);
  if (blockCount_ == blocks_.size()) blocks_.emplace_back();
  physics::buildBlock(&singles_[first], static_cast<std::uint32_t>(blockContacts_.size()), blocks_[blockCount_]);
  groups_.push_back({first, static_cast<std::uint32_t>(singles_.size()), light, blockCount_++});
}

void ContactSolver::buildStrikes(State& state, float dt) {
  for (const Strike& strike : state.strikes.list) {
    if (!strike.active || !state.reach.takesIn(strike.body, strike.struck)) continue;
    const auto first = static_cast<std::uint32_t>(singles_.size());
    for (std::uint32_t i = 0; i < strike.contactCount; ++i) {
      const std::uint32_t slot = state.strikes.contacts[strike.firstContact + i];
      if (!state.contacts.at(slot).solvedAlone) addSingle(state, slot, dt);
    }
    const auto end = static_cast<std::uint32_t>(singles_.size());
    if (end > first) groups_.push_back({first, end, kNobody, 0});
  }
}

void ContactSolver::warmStartRows(State& state) {
  for (std::uint32_t i = 0; i < batchCount_; ++i) {
    PairVelocity<Float4> v = loadPair(*bodies_, batches_[i].bodyA, batches_[i].bodyB);
    batches_[i].rows.warmStart(v);
    storePair(*bodies_, batches_[i].bodyA, batches_[i].bodyB, v);
  }
  for (Single& single : singles_) {
    PairVelocity<float> v = loadPair(*bodies_, single.bodyA, single.bodyB);
    single.rows.warmStart(v);
    storePair(*bodies_, single.bodyA, single.bodyB, v);
  }
  if constexpr (effects::kHasJoints) state.jointSolver.warmStart(bodies_->data());
}

void ContactSolver::solve(State& state, int iterations) {
  for (int i = 0; i < iterations; ++i) sweep(state, i % 2 != 0);
}

void ContactSolver::sweep(State& state, bool backwards) {
  if constexpr (effects::kHasJoints) state.jointSolver.solve(bodies_->data());
  if constexpr (effects::kHasDrives) state.driveSolver.solve(bodies_->data());
  solveBatches(backwards);
  solveGroups(state);
}

// Every other sweep runs backwards: what travels through a stack in one direction only would tilt it. For the same
// reason, and as it converges far better for what loading a contact costs, the points of one are visited there and
// back.
void ContactSolver::solveBatches(bool backwards) {
  for (std::uint32_t i = 0; i < batchCount_; ++i) {
    Batch& batch = batches_[backwards ? batchCount_ - 1 - i : i];
    PairVelocity<Float4> v = loadPair(*bodies_, batch.bodyA, batch.bodyB);
    batch.rows.solveFriction(v);
    batch.rows.solveNormals(batch.points, 2 * batch.points - 1, backwards, v);
    storePair(*bodies_, batch.bodyA, batch.bodyB, v);
  }
}

float ContactSolver::sumOf(std::uint32_t first, std::uint32_t end) const {
  float sum = 0.0f;
  for (std::uint32_t i = first; i < end; ++i) sum += singles_[i].rows.normalSum();
  return sum;
}

void ContactSolver::solveGroups(State& state) {
  for (const Group& group : groups_) {
    if (group.light != kNobody)
      solveLightBody(state, group);
    else
      solveStrike(state, group);
    for (std::uint32_t i = group.first; i < group.end; ++i) {
      PairVelocity<float> v = loadPair(*bodies_, singles_[i].bodyA, singles_[i].bodyB);
      singles_[i].rows.solveFriction(v);
      storePair(*bodies_, singles_[i].bodyA, singles_[i].bodyB, v);
    }
  }
}

void ContactSolver::solveLightBody(State& state, const Group& group) {
  limits_.clear();
  for (std::uint32_t first = group.first; first < group.end;) {
    std::uint32_t end = first + 1;
    while (end < group.end && singles_[end].strike == singles_[first].strike) ++end;
    const std::uint32_t s = singles_[first].strike;
    if (s != kNoStrike) {
      Strike& strike = state.strikes.list[s];
      strike.impulse -= sumOf(first, end);
      const float left = minOf(strike.capacity - spentByPartners(state.strikes, s), strike.limit) - strike.impulse;
      limits_.push_back({first - group.first, end - group.first, strike.isCapped ? maxOf(left, 0.0f) : 3.0e38f});
    }
    first = end;
  }
  solveBlock(group.light, &singles_[group.first], limits_.data(), static_cast<std::uint32_t>(limits_.size()), *bodies_,
             blocks_[group.block]);
  for (const BlockLimit& limit : limits_)
    state.strikes.list[singles_[group.first + limit.first].strike].impulse +=
        sumOf(group.first + limit.first, group.first + limit.end);
}

// Normals of a whole strike first, then its cap, which scales all points alike, so that a flat hit is capped without
// being turned.
void ContactSolver::solveStrike(State& state, const Group& group) {
  const std::uint32_t s = singles_[group.first].strike;
  Strike& strike = state.strikes.list[s];
  strike.impulse -= sumOf(group.first, group.end);
  for (std::uint32_t i = group.first; i < group.end; ++i) {
    Single& single = singles_[i];
    PairVelocity<float> v = loadPair(*bodies_, single.bodyA, single.bodyB);
    single.rows.solveNormals(single.points, single.points, false, v);
    storePair(*bodies_, single.bodyA, single.bodyB, v);
  }
  const float sum = sumOf(group.first, group.end);
  const float left =
      maxOf(minOf(strike.capacity - spentByPartners(state.strikes, s), strike.limit) - strike.impulse, 0.0f);
  if (sum > left && strike.isCapped) scaleNormals(group, left / sum);
  strike.impulse += sumOf(group.first, group.end);
}

void ContactSolver::scaleNormals(const Group& group, float scale) {
  for (std::uint32_t i = group.first; i < group.end; ++i) {
    Single& single = singles_[i];
    PairVelocity<float> v = loadPair(*bodies_, single.bodyA, single.bodyB);
    for (int p = 0; p < single.points; ++p) {
      Row<float>& row = single.rows.point[p];
      const float capped = row.impulse * scale;
      single.rows.apply(single.rows.normal, row, capped - row.impulse, v);
      row.impulse = capped;
    }
    storePair(*bodies_, single.bodyA, single.bodyB, v);
  }
}

void ContactSolver::store(State& state) const {
  for (std::uint32_t i = 0; i < batchCount_; ++i)
    for (int lane = 0; lane < batches_[i].lanes; ++lane)
      storeLane(batches_[i].rows, lane, state.contacts.at(batches_[i].contact[lane]).manifold);
  for (const Single& single : singles_) storeLane(single.rows, 0, state.contacts.at(single.contact).manifold);
  if constexpr (effects::kHasJoints) state.jointSolver.store(state);
}

// One row at a time: rebounds are few. Bodies have moved since the solve, so their centres are read anew.
void ContactSolver::applyRestitution(State& state) {
  BR_ZONE("restitution");
  bool any = false;
  state.contacts.forEach([&](ContactHandle, Contact& contact) {
    if (contact.restitution == 0.0f) return;
    bool rebound = false;
    for (int i = 0; i < contact.manifold.count; ++i) rebound = rebound || rebounds(contact, i);
    if (!rebound) return;
    if (contact.strike != kNoStrike && state.strikes.list[contact.strike].saturated) return;
    const std::uint32_t a = state.shapes[contact.a].body.index;
    const std::uint32_t b = state.shapes[contact.b].body.index;
    if ((*bodies_)[a].invMass == 0.0f && (*bodies_)[b].invMass == 0.0f) return;
    any = true;
    (*bodies_)[a].center = state.bodies.at(a).center;
    (*bodies_)[b].center = state.bodies.at(b).center;
    ContactRows<float> rows;
    fillLane(state, contact, GapRule::Touching, 1.0f, 0, rows);
    PairVelocity<float> v = loadPair(*bodies_, a, b);
    for (int i = 0; i < contact.manifold.count; ++i) {
      if (!rebounds(contact, i)) continue;
      const float missing = contact.restitution * contact.approach[i] - rows.speedAlong(rows.normal, rows.point[i], v);
      if (missing <= 0.0f) continue;
      rows.apply(rows.normal, rows.point[i], rows.point[i].mass * missing, v);
    }
    storePair(*bodies_, a, b, v);
  });
  if (any) storeBodies(state);
}

// What stopped a heavy body is no estimate of what holds it in the next tick, and would have to creep out of the shards
// it went through: they would throw it back. A load at rest is one, and stays.
void ContactSolver::forgetImpacts(State& state, float dt) {
  isLight_.assign(state.bodies.capacity(), 0);
  const float restSpeed = 2.0f * state.gravity.norm() * dt;
  bool any = false;
  state.contacts.forEach([&](ContactHandle, const Contact& contact) {
    float approach = 0.0f;
    for (int i = 0; i < contact.manifold.count; ++i) approach = maxOf(approach, contact.approach[i]);
    const std::uint32_t light = approach > restSpeed ? lighterOf(state, contact) : kNobody;
    if (light == kNobody) return;
    isLight_[light] = 1;
    any = true;
  });
  if (!any) return;
  state.contacts.forEach([&](ContactHandle, Contact& contact) {
    const bool light =
        isLight_[state.shapes[contact.a].body.index] != 0 || isLight_[state.shapes[contact.b].body.index] != 0;
    if (light) contact.manifold.forgetImpulses();
  });
}

}  // namespace brittle::physics
