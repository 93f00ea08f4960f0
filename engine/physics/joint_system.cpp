// Building and factoring the joint matrix, and who hangs together.
#include "engine/physics/joint_system.h"

#include <algorithm>

namespace brittle::physics {

namespace {

// Added to each diagonal entry, relative. Large enough that the rounding of positions (1e-7) in a redundant loop is not
// taken for stiffness, small enough that one refinement leaves 1 % at a pivot of 1e-3. Derived.
constexpr double kRegularisation = 1e-5;

// Elimination costs up to the cube of a group's rows. Larger ones are cut into groups that the iterations bring
// together. Chosen: the worst case, all on one body, stays at a few milliseconds.
constexpr std::uint32_t kLargestGroup = 24;

bool moves(const SolverBody* bodies, std::uint32_t slot) {
  return slot != kWorldBody && bodies[slot].invMass > 0.0f;
}

bool shareMovingBody(const PreparedJoint& p, const PreparedJoint& q, const SolverBody* bodies) {
  const bool a = moves(bodies, p.bodyA) && (p.bodyA == q.bodyA || p.bodyA == q.bodyB);
  return a || (moves(bodies, p.bodyB) && (p.bodyB == q.bodyA || p.bodyB == q.bodyB));
}

std::uint32_t rootOf(std::uint32_t* roots, std::uint32_t slot) {
  while (roots[slot] != slot) {
    roots[slot] = roots[roots[slot]];
    slot = roots[slot];
  }
  return slot;
}

double dotDouble(const Vec3& a, const Vec3& b) {
  return a.cast<double>().dot(b.cast<double>());
}

/// The part of a matrix entry that comes from one body.
double coupling(const SolverBody& body, const Vec3& linearP, const Vec3& angularP, const Vec3& linearQ,
                const Vec3& angularQ) {
  const Vec3d turn = body.invInertia.cast<double>() * angularQ.cast<double>();
  return double(body.invMass) * dotDouble(linearP, linearQ) + angularP.cast<double>().dot(turn);
}

double entry(const PreparedJoint& p, std::uint32_t i, const PreparedJoint& q, std::uint32_t j,
             const SolverBody* bodies) {
  const JointRow& a = p.rows.equalities[i];
  const JointRow& b = q.rows.equalities[j];
  double sum = 0.0;
  if (moves(bodies, p.bodyA)) {
    if (p.bodyA == q.bodyA) sum += coupling(bodies[p.bodyA], a.linear, a.angularA, b.linear, b.angularA);
    if (p.bodyA == q.bodyB) sum -= coupling(bodies[p.bodyA], a.linear, a.angularA, b.linear, b.angularB);
  }
  if (moves(bodies, p.bodyB)) {
    if (p.bodyB == q.bodyA) sum -= coupling(bodies[p.bodyB], a.linear, a.angularB, b.linear, b.angularA);
    if (p.bodyB == q.bodyB) sum += coupling(bodies[p.bodyB], a.linear, a.angularB, b.linear, b.angularB);
  }
  return sum;
}

}  // namespace

void JointSystem::addJoint(const PreparedJoint* joints, const std::uint32_t* starts, std::uint32_t p,
                           std::uint32_t firstCoupled, const SolverBody* bodies) {
  for (std::uint32_t i = 0; i < joints[p].rows.count; ++i) {
    const std::uint32_t row = starts[p] + i;
    const std::uint32_t first = starts[firstCoupled];
    rows_.push_back({first, static_cast<std::uint32_t>(entries_.size())});
    entries_.resize(entries_.size() + (row - first), 0.0);
    for (std::uint32_t q = firstCoupled; q <= p; ++q) {
      if (q != p && !shareMovingBody(joints[p], joints[q], bodies)) continue;
      const std::uint32_t last = q == p ? i : joints[q].rows.count;
      for (std::uint32_t j = 0; j < last; ++j) at(row, starts[q] + j) = entry(joints[p], i, joints[q], j, bodies);
    }
    diagonal_.push_back(entry(joints[p], i, joints[p], i, bodies) * (1.0 + kRegularisation));
  }
}

void JointSystem::factor(const PreparedJoint* joints, std::uint32_t count, const SolverBody* bodies) {
  rows_.clear();
  entries_.clear();
  diagonal_.clear();
  starts_.clear();
  std::uint32_t row = 0;
  for (std::uint32_t p = 0; p < count; ++p) {
    starts_.push_back(row);
    row += joints[p].rows.count;
    std::uint32_t firstCoupled = 0;
    while (firstCoupled < p && !shareMovingBody(joints[p], joints[firstCoupled], bodies)) ++firstCoupled;
    addJoint(joints, starts_.data(), p, firstCoupled, bodies);
  }
  for (std::uint32_t i = 0; i < rowCount(); ++i) {
    // Entries become g = L D first, then L once the row is complete.
    for (std::uint32_t j = rows_[i].first; j < i; ++j) {
      double value = at(i, j);
      for (std::uint32_t k = maxOf(rows_[i].first, rows_[j].first); k < j; ++k) value -= at(i, k) * at(j, k);
      at(i, j) = value;
    }
    double pivot = diagonal_[i];
    for (std::uint32_t j = rows_[i].first; j < i; ++j) {
      const double g = at(i, j);
      at(i, j) = g * diagonal_[j];
      pivot -= g * at(i, j);
    }
    diagonal_[i] = pivot > 0.0 ? 1.0 / pivot : 0.0;  // nothing can move this row: leave it out
  }
}

void JointSystem::solve(double* values) const {
  const std::uint32_t count = rowCount();
  for (std::uint32_t i = 0; i < count; ++i) {
    const double* row = entries_.data() + rows_[i].offset;
    for (std::uint32_t j = rows_[i].first; j < i; ++j) values[i] -= row[j - rows_[i].first] * values[j];
  }
  for (std::uint32_t i = 0; i < count; ++i) values[i] *= diagonal_[i];
  for (std::uint32_t i = count; i-- > 0;) {
    const double* row = entries_.data() + rows_[i].offset;
    for (std::uint32_t j = rows_[i].first; j < i; ++j) values[j] -= row[j - rows_[i].first] * values[i];
  }
}

void groupJoints(std::vector<ActiveJoint>& joints, const SolverBody* bodies, std::uint32_t* roots,
                 std::vector<JointGroup>& groups) {
  for (const ActiveJoint& joint : joints) {
    roots[joint.bodyA] = joint.bodyA;
    if (joint.bodyB != kWorldBody) roots[joint.bodyB] = joint.bodyB;
  }
  for (const ActiveJoint& joint : joints) {
    if (!moves(bodies, joint.bodyA) || !moves(bodies, joint.bodyB)) continue;
    const std::uint32_t a = rootOf(roots, joint.bodyA);
    const std::uint32_t b = rootOf(roots, joint.bodyB);
    roots[maxOf(a, b)] = minOf(a, b);
  }
  for (ActiveJoint& joint : joints) joint.group = rootOf(roots, moves(bodies, joint.bodyA) ? joint.bodyA : joint.bodyB);
  std::sort(joints.begin(), joints.end(), [](const ActiveJoint& a, const ActiveJoint& b) {
    return a.group != b.group ? a.group < b.group : a.joint < b.joint;
  });
  groups.clear();
  for (std::uint32_t i = 0; i < joints.size(); ++i) {
    const bool isFull = !groups.empty() && groups.back().count == kLargestGroup;
    if (groups.empty() || isFull || joints[i - 1].group != joints[i].group) groups.push_back({i, 0});
    ++groups.back().count;
  }
}

}  // namespace brittle::physics
