#include "engine/physics/solver.h"

#include "engine/physics/contact_prepare.h"
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

template <class Get>
Wide3<Float4> gather(const std::uint32_t (&index)[kLanes], Get&& get) {
  const Vec3& p = get(index[0]);
  const Vec3& q = get(index[1]);
  const Vec3& r = get(index[2]);
  const Vec3& s = get(index[3]);
  return {Float4{p.x(), q.x(), r.x(), s.x()}, Float4{p.y(), q.y(), r.y(), s.y()}, Float4{p.z(), q.z(), r.z(), s.z()}};
}

Wide3<float> wide(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 narrow(const Wide3<float>& v) { return Vec3(v.x, v.y, v.z); }

PairVelocity<float> load(const std::vector<SolverBody>& bodies, std::uint32_t a, std::uint32_t b) {
  return {wide(bodies[a].velocity), wide(bodies[a].angularVelocity), wide(bodies[b].velocity), wide(bodies[b].angularVelocity)};
}

void store(std::vector<SolverBody>& bodies, std::uint32_t a, std::uint32_t b, const PairVelocity<float>& v) {
  bodies[a].velocity = narrow(v.linearA);
  bodies[a].angularVelocity = narrow(v.angularA);
  bodies[b].velocity = narrow(v.linearB);
  bodies[b].angularVelocity = narrow(v.angularB);
}

PairVelocity<Float4> load(const std::vector<SolverBody>& bodies, const std::uint32_t (&a)[kLanes], const std::uint32_t (&b)[kLanes]) {
  const auto linear = [&](std::uint32_t i) -> const Vec3& { return bodies[i].velocity; };
  const auto angular = [&](std::uint32_t i) -> const Vec3& { return bodies[i].angularVelocity; };
  return {gather(a, linear), gather(a, angular), gather(b, linear), gather(b, angular)};
}

void store(std::vector<SolverBody>& bodies, const std::uint32_t (&a)[kLanes], const std::uint32_t (&b)[kLanes],
           const PairVelocity<Float4>& v) {
  for (int lane = 0; lane < kLanes; ++lane) {
    bodies[a[lane]].velocity = Vec3(v.linearA.x[lane], v.linearA.y[lane], v.linearA.z[lane]);
    bodies[a[lane]].angularVelocity = Vec3(v.angularA.x[lane], v.angularA.y[lane], v.angularA.z[lane]);
    bodies[b[lane]].velocity = Vec3(v.linearB.x[lane], v.linearB.y[lane], v.linearB.z[lane]);
    bodies[b[lane]].angularVelocity = Vec3(v.angularB.x[lane], v.angularB.y[lane], v.angularB.z[lane]);
  }
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
  colorContacts(state);
  buildBatches(state, dt);
  buildStrikes(state, dt);
  if (warmStart) warmStartRows(state);
}

// Greedy: each contact takes the first colour that neither of its moving bodies has yet. Slot order, so always the same.
void ContactSolver::colorContacts(State& state) {
  for (auto& list : byColor_) list.clear();
  colorMasks_.assign(bodies_->size(), 0);
  state.contacts.forEach([&](ContactHandle handle, Contact& contact) {
    if (contact.manifold.count == 0 || contact.strike != kNoStrike) return;
    const std::uint32_t a = state.shapes[contact.a].body.index;
    const std::uint32_t b = state.shapes[contact.b].body.index;
    const bool movesA = (*bodies_)[a].invMass > 0.0f;
    const bool movesB = (*bodies_)[b].invMass > 0.0f;
    if (!movesA && !movesB) return;
    const std::uint32_t taken = (movesA ? colorMasks_[a] : 0u) | (movesB ? colorMasks_[b] : 0u);
    int color = 0;
    while (color < kColors && (taken >> color & 1u) != 0) ++color;
    if (color < kColors) {
      if (movesA) colorMasks_[a] |= 1u << color;
      if (movesB) colorMasks_[b] |= 1u << color;
    }
    byColor_[color].push_back(handle.index);
  });
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

void ContactSolver::buildStrikes(State& state, float dt) {
  singles_.clear();
  for (std::uint32_t s = 0; s < state.strikes.list.size(); ++s) {
    const Strike& strike = state.strikes.list[s];
    if (!strike.active) continue;
    for (std::uint32_t i = 0; i < strike.contactCount; ++i) {
      Single& single = singles_.emplace_back();
      single.contact = state.strikes.contacts[strike.firstContact + i];
      const Contact& contact = state.contacts.at(single.contact);
      single.strike = s;
      single.bodyA = state.shapes[contact.a].body.index;
      single.bodyB = state.shapes[contact.b].body.index;
      single.points = contact.manifold.count;
      fillLane(state, contact, strike.touching ? GapRule::Touching : GapRule::Speculative, dt, 0, single.rows);
    }
  }
}

void ContactSolver::warmStartRows(State& state) {
  for (std::uint32_t i = 0; i < batchCount_; ++i) {
    PairVelocity<Float4> v = load(*bodies_, batches_[i].bodyA, batches_[i].bodyB);
    batches_[i].rows.warmStart(v);
    physics::store(*bodies_, batches_[i].bodyA, batches_[i].bodyB, v);
  }
  for (Single& single : singles_) {
    PairVelocity<float> v = load(*bodies_, single.bodyA, single.bodyB);
    single.rows.warmStart(v);
    physics::store(*bodies_, single.bodyA, single.bodyB, v);
  }
  state.jointSolver.warmStart(bodies_->data());
}

void ContactSolver::solve(State& state, int iterations) {
  for (int i = 0; i < iterations; ++i) {
    state.jointSolver.solve(bodies_->data());
    solveBatches();
    solveStrikes(state);
  }
}

void ContactSolver::solveBatches() {
  for (std::uint32_t i = 0; i < batchCount_; ++i) {
    Batch& batch = batches_[i];
    PairVelocity<Float4> v = load(*bodies_, batch.bodyA, batch.bodyB);
    batch.rows.solveFriction(v);
    batch.rows.solveNormals(batch.points, v);
    physics::store(*bodies_, batch.bodyA, batch.bodyB, v);
  }
}

// Normals of a whole strike first, then its cap, then friction within what the cap left.
void ContactSolver::solveStrikes(State& state) {
  std::size_t first = 0;
  while (first < singles_.size()) {
    const std::uint32_t s = singles_[first].strike;
    std::size_t end = first;
    for (; end < singles_.size() && singles_[end].strike == s; ++end) {
      Single& single = singles_[end];
      PairVelocity<float> v = load(*bodies_, single.bodyA, single.bodyB);
      single.rows.solveNormals(single.points, v);
      physics::store(*bodies_, single.bodyA, single.bodyB, v);
    }
    capStrike(state, first, end);
    for (std::size_t i = first; i < end; ++i) {
      PairVelocity<float> v = load(*bodies_, singles_[i].bodyA, singles_[i].bodyB);
      singles_[i].rows.solveFriction(v);
      physics::store(*bodies_, singles_[i].bodyA, singles_[i].bodyB, v);
    }
    first = end;
  }
}

// What the other bodies of the same budget (a striker and its fresh pieces) spend on the same struck body [N s]. The list is sorted,
// so they stand beside it.
float ContactSolver::spentByPartners(const std::vector<Strike>& list, std::size_t s) {
  const auto isPartner = [&](std::size_t i) { return list[i].striker == list[s].striker && list[i].struck == list[s].struck; };
  float spent = 0.0f;
  for (std::size_t i = s; i > 0 && isPartner(i - 1); --i) spent += list[i - 1].impulse;
  for (std::size_t i = s + 1; i < list.size() && isPartner(i); ++i) spent += list[i].impulse;
  return spent;
}

// Scales all points alike, so that a flat hit is capped without being turned.
void ContactSolver::capStrike(State& state, std::size_t first, std::size_t end) {
  Strike& strike = state.strikes.list[singles_[first].strike];
  float sum = 0.0f;
  for (std::size_t i = first; i < end; ++i) sum += singles_[i].rows.normalSum();
  const float capacity = maxOf(strike.capacity - spentByPartners(state.strikes.list, singles_[first].strike), 0.0f);
  strike.impulse = minOf(sum, capacity);
  if (sum <= capacity || !strike.isCapped) return;
  const float scale = capacity / sum;
  for (std::size_t i = first; i < end; ++i) {
    Single& single = singles_[i];
    PairVelocity<float> v = load(*bodies_, single.bodyA, single.bodyB);
    for (int p = 0; p < single.points; ++p) {
      Row<float>& row = single.rows.point[p];
      const float capped = row.impulse * scale;
      single.rows.apply(single.rows.normal, row, capped - row.impulse, v);
      row.impulse = capped;
    }
    physics::store(*bodies_, single.bodyA, single.bodyB, v);
  }
}

void ContactSolver::store(State& state) const {
  for (std::uint32_t i = 0; i < batchCount_; ++i)
    for (int lane = 0; lane < batches_[i].lanes; ++lane)
      storeLane(batches_[i].rows, lane, state.contacts.at(batches_[i].contact[lane]).manifold);
  for (const Single& single : singles_) storeLane(single.rows, 0, state.contacts.at(single.contact).manifold);
  state.jointSolver.store(state);
}

// One row at a time on a copy of the velocities: rebounds are few.
void ContactSolver::applyRestitution(State& state) {
  constexpr float kSlowest = 0.5f;  // [m/s] below, things come to rest; chosen by eye
  state.contacts.forEach([&](ContactHandle, Contact& contact) {
    if (contact.restitution == 0.0f || contact.manifold.count == 0) return;
    if (contact.strike != kNoStrike && state.strikes.list[contact.strike].saturated) return;
    const std::uint32_t a = state.shapes[contact.a].body.index;
    const std::uint32_t b = state.shapes[contact.b].body.index;
    if ((*bodies_)[a].invMass == 0.0f && (*bodies_)[b].invMass == 0.0f) return;
    ContactRows<float> rows;
    fillLane(state, contact, GapRule::Touching, 1.0f, 0, rows);
    PairVelocity<float> v = load(*bodies_, a, b);
    for (int i = 0; i < contact.manifold.count; ++i) {
      if (contact.approach[i] < kSlowest || contact.manifold.points[i].normalImpulse <= 0.0f) continue;
      const float missing = contact.restitution * contact.approach[i] - rows.speedAlong(rows.normal, rows.point[i], v);
      if (missing <= 0.0f) continue;
      rows.apply(rows.normal, rows.point[i], rows.point[i].mass * missing, v);
    }
    physics::store(*bodies_, a, b, v);
  });
}

}  // namespace brittle::physics
