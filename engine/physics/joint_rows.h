// physics/joint_rows.h - a joint as rows of a linear system: what JointSolver prepares once and iterates on. Every row
// measures a speed of body A relative to body B; an impulse along it acts on A, its opposite on B. Only the joint files
// use this.
#pragma once

#include <cstdint>

#include "engine/math/transform.h"
#include "engine/physics/ids.h"
#include "engine/physics/solver_body.h"

namespace brittle::physics {

struct Joint;
struct State;

inline constexpr std::uint32_t kMaxEqualities = 6;
inline constexpr std::uint32_t kWorldBody = 0xffffffff;  // the body slot of the world

/// speed = linear . (vA - vB) + angularA . wA - angularB . wB
struct JointRow {
  Vec3 linear = Vec3::Zero();
  Vec3 angularA = Vec3::Zero();
  Vec3 angularB = Vec3::Zero();

  float speed(const SolverBody& a, const SolverBody& b) const {
    return (linear.dot(a.velocity - b.velocity) + angularA.dot(a.angularVelocity)) - angularB.dot(b.angularVelocity);
  }
  void apply(SolverBody& a, SolverBody& b, float impulse) const {
    a.velocity += linear * (a.invMass * impulse);
    a.angularVelocity += a.invInertia * (angularA * impulse);
    b.velocity -= linear * (b.invMass * impulse);
    b.angularVelocity -= b.invInertia * (angularB * impulse);
  }
  void add(const JointRow& other, float factor) {
    linear += other.linear * factor;
    angularA += other.angularA * factor;
    angularB += other.angularB * factor;
  }
};

/// Speed along `row` that a unit impulse along `other` makes. [1/kg or 1/(kg m2)]
float inverseMassBetween(const JointRow& row, const JointRow& other, const SolverBody& a, const SolverBody& b);

/// Up to six rows that hold exactly, solved together by a factorisation L D L^T of their inverse mass matrix. A row
/// that the ones before it imply (or that nothing can move) is left out by itself.
class EqualityBlock {
 public:
  void factor(const JointRow* rows, std::uint32_t count, const SolverBody& a, const SolverBody& b);
  /// values := K^-1 values
  void solve(float* values) const;
  std::uint32_t count() const { return count_; }

 private:
  std::uint32_t count_ = 0;
  float lower_[kMaxEqualities][kMaxEqualities];
  float inverseDiagonal_[kMaxEqualities];
};

/// A joint as it stands: rows, and how far off they are.
struct JointRows {
  JointRow equalities[kMaxEqualities];
  float error[kMaxEqualities];  // [m or rad]
  std::uint32_t count = 0;
  std::uint32_t linearCount = 0;  // the linear rows come first
  bool hasCoordinate = false;     // hinge [rad], slider [m]; rope: the distance of its anchors [m]
  JointRow coordinateRow;
  float coordinate = 0.0f;
  Vec3 armA = Vec3::Zero(), armB = Vec3::Zero();  // from the centres to the anchors, world [m]
  Vec3 axis = Vec3::Zero();                       // hinge only, world
};

/// The joint at the poses its bodies have now; slots as in ActiveJoint.
JointRows measureJoint(const State& state, const Joint& joint, std::uint32_t bodyA, std::uint32_t bodyB);

/// A row with bounds on its impulse: motor, limit or rope. `response` is `row` less what the joint's equalities answer
/// to it, so that an impulse along it leaves them as they are.
struct BoundedRow {
  JointRow row, response;
  float answer[kMaxEqualities] = {};  // impulse of each equality for a unit impulse of this row
  float mass = 0.0f;                  // speed to impulse; 0: cannot move
  float target = 0.0f;                // speed to reach, within the bounds [m/s or rad/s]
  float low = 0.0f, high = 0.0f;      // of the accumulated impulse [N s or N m s]
  float impulse = 0.0f;               // accumulated

  void prepare(const JointRow& from, const JointRows& rows, const EqualityBlock& block, const SolverBody& a,
               const SolverBody& b);
};

enum BoundedKind : std::uint32_t { kLower, kUpper, kMotor, kBoundedCount };  // a rope is an upper limit

struct PreparedJoint {
  std::uint32_t joint = 0;             // slot
  std::uint32_t bodyA = 0, bodyB = 0;  // slots
  JointRows rows;
  EqualityBlock block;
  float impulse[kMaxEqualities] = {};  // accumulated
  BoundedRow bounded[kBoundedCount];
  bool active[kBoundedCount] = {};
  bool isRope = false;
  float mostTurning = 0.0f;      // bounds of the biases, see joint.cpp [m/s]
  float mostAxisTurning = 0.0f;  // [rad/s]
};

}  // namespace brittle::physics
