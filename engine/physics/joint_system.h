// physics/joint_system.h - all equalities of joints that hang together, solved at once: a chain of twenty is as stiff
// as one joint. Only the joint files use this.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/physics/joint_rows.h"

namespace brittle::physics {

/// A joint that acts this tick, and between which bodies.
struct ActiveJoint {
  std::uint32_t joint = 0;             // slot
  std::uint32_t bodyA = 0, bodyB = 0;  // slots
  std::uint32_t group = 0;             // lowest body slot of those it hangs together with
};

/// Joints [first, first + count) of the sorted list, connected through moving bodies (very large ones are cut).
struct JointGroup {
  std::uint32_t first = 0, count = 0;
};

/// Sorts joints by group, then by slot. `roots` is scratch, at least as long as there are bodies.
void groupJoints(std::vector<ActiveJoint>& joints, const SolverBody* bodies, std::uint32_t* roots,
                 std::vector<JointGroup>& groups);

/// The inverse mass matrix of the rows of some groups, factored as L D L^T within its envelope (each row from its first
/// entry to the diagonal; elimination fills nothing outside). In double: redundant loops stay harmless by a relative
/// regularisation that the solver's iterations refine away where the system is sound. Source: George, Liu, Computer
/// Solution of Large Sparse Positive Definite Systems, 1981, chapter 4.
class JointSystem {
 public:
  /// `bodies` holds inverse masses by body slot.
  void factor(const PreparedJoint* joints, std::uint32_t count, const SolverBody* bodies);
  std::uint32_t rowCount() const { return static_cast<std::uint32_t>(rows_.size()); }
  /// values := K^-1 values, in the order of the joints' rows.
  void solve(double* values) const;

 private:
  struct Row {
    std::uint32_t first = 0;   // column of its first entry
    std::uint32_t offset = 0;  // of that entry in entries_
  };
  void addJoint(const PreparedJoint* joints, const std::uint32_t* starts, std::uint32_t p, std::uint32_t firstCoupled,
                const SolverBody* bodies);
  double& at(std::uint32_t row, std::uint32_t column) {
    return entries_[rows_[row].offset + (column - rows_[row].first)];
  }

  std::vector<Row> rows_;
  std::vector<double> entries_;        // without the diagonal
  std::vector<double> diagonal_;       // then its inverse
  std::vector<std::uint32_t> starts_;  // first row of each joint
};

}  // namespace brittle::physics
