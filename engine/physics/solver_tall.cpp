// The solver's rounds for tall stacks: see ContactSolver::solveTall.
#include "engine/physics/pair_velocity.h"
#include "engine/physics/solver.h"
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

/// Calls visit(row, i) with everything in a batch that has an impulse: points, slides, twist.
template <class Rows, class Visit>
void forEachImpulse(Rows& rows, Visit&& visit) {
  for (int i = 0; i < kMaxPoints; ++i) visit(rows.point[i].impulse, rows.point[i].mass, i);
  for (int i = 0; i < 2; ++i) visit(rows.slide[i].impulse, rows.slide[i].mass, kMaxPoints + i);
  visit(rows.twistImpulse, rows.twistMass, kMaxPoints + 2);
}

}  // namespace

void ContactSolver::solveTall(State& state, int rounds) {
  courses_.assign(batchCount_, Course{});
  double before = 0.0;
  for (int round = 0; round < rounds; ++round) {
    beginRound();
    sweep(state, false);
    sweep(state, true);
    if (round + 1 == rounds) return;  // rows must have had the last word
    const double length = lengthOfRound();
    goOn(length <= before && before > 0.0 ? static_cast<float>(length / before) : 0.0f);
    before = length;
  }
}

void ContactSolver::beginRound() {
  for (std::uint32_t b = 0; b < batchCount_; ++b)
    forEachImpulse(batches_[b].rows,
                   [&](const Float4& impulse, const Float4&, int i) { courses_[b].change[i] = impulse; });
}

/// What the round changed of the impulses, and its length: squares weighted by the rows' masses, so that twists and
/// pushes add up. [J]
double ContactSolver::lengthOfRound() {
  Float4 sum{};
  for (std::uint32_t b = 0; b < batchCount_; ++b) {
    forEachImpulse(batches_[b].rows, [&](const Float4& impulse, const Float4& mass, int i) {
      const Float4 change = impulse - courses_[b].change[i];
      courses_[b].change[i] = change;
      sum = sum + select(mass > Float4{}, change * change / select(mass > Float4{}, mass, Float4{} + 1.0f), Float4{});
    });
  }
  return (static_cast<double>(sum[0]) + static_cast<double>(sum[1])) +
         (static_cast<double>(sum[2]) + static_cast<double>(sum[3]));
}

/// All impulses go on by `share` of the way so far, and the round's change becomes part of the way.
void ContactSolver::goOn(float share) {
  const Float4 part = brittle::splat(share);
  for (std::uint32_t b = 0; b < batchCount_; ++b) {
    Batch& batch = batches_[b];
    Course& course = courses_[b];
    ContactRows<Float4> step = batch.rows;
    forEachImpulse(step, [&](Float4& impulse, const Float4&, int i) { impulse = course.way[i] * part; });
    forEachImpulse(batch.rows, [&](Float4& impulse, const Float4&, int i) {
      impulse = impulse + course.way[i] * part;
      course.way[i] = course.way[i] * part + course.change[i];
    });
    if (share == 0.0f) continue;
    PairVelocity<Float4> v = loadPair(*bodies_, batch.bodyA, batch.bodyB);
    step.warmStart(v);
    storePair(*bodies_, batch.bodyA, batch.bodyB, v);
  }
}

}  // namespace brittle::physics
