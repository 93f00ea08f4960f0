// physics/joint.h - ball, hinge, slider, rope and weld joints, and motors. A joint goes with the shape that
// holds its anchor: when that is split, with the piece that contains the anchor; when the anchor is carved out, the
// joint is gone. Joint impulses never break glass.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/archive.h"
#include "engine/math/transform.h"
#include "engine/physics/ids.h"
#include "engine/physics/joint_rows.h"
#include "engine/physics/joint_system.h"

namespace brittle::physics {

enum class JointType : std::uint8_t { Ball, Hinge, Slider, Rope, Weld };

/// The coordinate of a hinge or slider is that of A relative to B, about or along `axis` (B is the frame or rail, A
/// turns or slides), so a positive motor speed moves A forward when B is the world. Of a body of several shapes the one
/// that holds the anchor is jointed (ties: the one given).
struct JointDef {
  JointType type = JointType::Ball;
  ShapeHandle a;                // must be a shape
  ShapeHandle b;                // null: the world
  Vec3 anchorA = Vec3::Zero();  // world, now [m]
  Vec3 anchorB = Vec3::Zero();  // world, now; ignored except by ropes (others share anchorA)
  Vec3 axis = Vec3::UnitY();    // hinge and slider: unit, world, now
  float length = -1.0f;         // rope: longest distance of the anchors [m]; negative: as they are now
  bool limited = false;  // hinge [rad, -pi to pi] and slider [m]: keep the coordinate in [lower, upper], 0 as created
  float lower = 0.0f, upper = 0.0f;
  bool motor = false;             // hinge and slider: drive the coordinate's speed ...
  float motorSpeed = 0.0f;        // ... to this [rad/s or m/s] ...
  float motorLimit = 0.0f;        // ... with at most this torque or force [N m or N]
  bool collideConnected = false;  // whether the two bodies collide with each other
};

struct Joint {
  JointType type = JointType::Ball;
  ShapeHandle a, b;
  Vec3 localAnchorA = Vec3::Zero();  // in A's body frame (pieces keep the frame, so it survives breaking)
  Vec3 localAnchorB = Vec3::Zero();  // in B's body frame, or world for none
  Vec3 localAxisA = Vec3::UnitY();
  Vec3 localAxisB = Vec3::UnitY();
  Quat referenceRotation = Quat::Identity();  // of B relative to A as created
  float length = 0.0f;
  bool limited = false;
  float lower = 0.0f, upper = 0.0f;
  bool motor = false;
  float motorSpeed = 0.0f, motorLimit = 0.0f;
  bool collideConnected = false;
  float gapA = 0.0f, gapB = 0.0f;  // from the anchor to the shape that holds it, as created [m]
  // Accumulated this tick; next tick's warm start; on A, B takes the opposite [N s, N m s].
  Vec3 linearImpulse = Vec3::Zero();
  Vec3 angularImpulse = Vec3::Zero();
  float limitImpulse = 0.0f;
  float motorImpulse = 0.0f;

  template <class Archive>
  void serialize(Archive& ar) {
    ar(type);
    ar(a);
    ar(b);
    ar(localAnchorA);
    ar(localAnchorB);
    ar(localAxisA);
    ar(localAxisB);
    ar(referenceRotation);
    ar(length);
    ar(limited);
    ar(lower);
    ar(upper);
    ar(motor);
    ar(motorSpeed);
    ar(motorLimit);
    ar(collideConnected);
    ar(gapA);
    ar(gapB);
    ar(linearImpulse);
    ar(angularImpulse);
    ar(limitImpulse);
    ar(motorImpulse);
  }
};

struct State;
struct SolverBody;

/// The joints of one tick. World calls, in this order: prepare (once per solve), warmStart, then solve in
/// every iteration, store at the end. Works on solver bodies (see solver_body.h) indexed by body slot.
class JointSolver {
 public:
  /// Reads poses from the bodies, inverse masses from State::solverBodies, which must be filled. `isFirstPass` false: a
  /// later pass of the same tick, without warmStart: what was spent so far (stored before) goes on counting.
  void prepare(const State& state, float dt, bool isFirstPass = true);
  void warmStart(SolverBody* bodies) const;
  void solve(SolverBody* bodies);
  /// Pushes anchors together by moving positions only (no velocity is touched). One pass.
  void correctPositions(State& state);
  void store(State& state) const;
  bool isEmpty() const { return joints_.empty(); }

 private:
  void findActive(const State& state);
  void solveGroup(std::size_t index, SolverBody* bodies);
  void correctGroup(State& state, const JointGroup& group);

  std::vector<ActiveJoint> active_;  // by group, then slot
  std::vector<JointGroup> groups_;
  std::vector<std::uint32_t> roots_;
  std::vector<PreparedJoint> joints_;  // as active_
  std::vector<JointSystem> systems_;   // as groups_
  std::vector<double> residual_;
  std::vector<PreparedJoint> moved_;  // one group, at the poses of a position pass
  std::vector<SolverBody> moves_;     // by body slot; velocities are displacements
  JointSystem moving_;
  float dt_ = 0.0f;
};

/// After `source` was replaced by pieces (still in the local frame of its body): joints whose anchor lay in `source`
/// move to the piece that contains the anchor (ties: the first), else to the nearest within `slop` [m] (anchors that
/// stood off the shape when created: within that distance more), else are removed. `source` may be among the pieces;
/// fragments that fly off are not, so a joint whose anchor is carved out is gone. Returns how many were removed.
std::uint32_t moveJoints(State& state, ShapeHandle source, const ShapeHandle* pieces, std::uint32_t count, float slop);

/// True if a joint with collideConnected off holds the two bodies together. Linear in the number of joints.
bool jointForbidsCollision(const State& state, BodyHandle a, BodyHandle b);

/// Wakes sleeping bodies that a joint holds to a moving one or that a motor turns. Before the velocities of a tick are
/// integrated.
void wakeByJoints(State& state);

/// Joints to the world after the origin moved by `offset` [m].
void shiftJoints(State& state, const Vec3& offset);

}  // namespace brittle::physics
