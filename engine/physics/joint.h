// physics/joint.h - ball, hinge, slider, rope and weld joints, motors and drives. A joint goes with the shape that holds its
// anchor: when that is split, with the piece that contains the anchor; when the anchor is carved out, the joint is gone.
// Joint impulses never break glass.
#pragma once

#include <cstdint>

#include "engine/core/archive.h"
#include "engine/math/transform.h"
#include "engine/physics/ids.h"

namespace brittle::physics {

enum class JointType : std::uint8_t { Ball, Hinge, Slider, Rope, Weld };

struct JointDef {
  JointType type = JointType::Ball;
  ShapeHandle a;                       // must be a shape
  ShapeHandle b;                       // null: the world
  Vec3 anchorA = Vec3::Zero();         // world, now [m]
  Vec3 anchorB = Vec3::Zero();         // world, now; ignored except by ropes (others share anchorA)
  Vec3 axis = Vec3::UnitY();           // hinge and slider: unit, world, now
  float length = -1.0f;                // rope: longest distance of the anchors [m]; negative: as they are now
  bool limited = false;                // hinge [rad] and slider [m]: keep the coordinate in [lower, upper], 0 as created
  float lower = 0.0f, upper = 0.0f;
  bool motor = false;                  // hinge and slider: drive the coordinate's speed ...
  float motorSpeed = 0.0f;             // ... to this [rad/s or m/s] ...
  float motorLimit = 0.0f;             // ... with at most this torque or force [N m or N]
  bool collideConnected = false;       // whether the two bodies collide with each other
};

struct Joint {
  JointType type = JointType::Ball;
  ShapeHandle a, b;
  Vec3 localAnchorA = Vec3::Zero();    // in A's body frame (pieces keep the frame, so it survives breaking)
  Vec3 localAnchorB = Vec3::Zero();    // in B's body frame, or world for none
  Vec3 localAxisA = Vec3::UnitY();
  Vec3 localAxisB = Vec3::UnitY();
  Quat referenceRotation = Quat::Identity();  // of B relative to A as created
  float length = 0.0f;
  bool limited = false;
  float lower = 0.0f, upper = 0.0f;
  bool motor = false;
  float motorSpeed = 0.0f, motorLimit = 0.0f;
  bool collideConnected = false;
  // Accumulated this tick; next tick's warm start [N s, N m s].
  Vec3 linearImpulse = Vec3::Zero();
  Vec3 angularImpulse = Vec3::Zero();
  float limitImpulse = 0.0f;
  float motorImpulse = 0.0f;

  template <class Archive>
  void serialize(Archive& a);
};

/// Pulls a body towards a pose, softly: an obstacle that can be knocked out of its way. Acts on every body that the shapes of
/// an assembly now belong to, each once.
struct DriveDef {
  std::uint32_t assembly = 0;
  bool drivePosition = false;
  Vec3 position = Vec3::Zero();        // world target of the assembly's original body frame [m]
  bool driveRotation = false;
  Quat rotation = Quat::Identity();
  float strength = 10.0f;              // 1: soft, 10: firm, 100: rigid [-]; see joint.cpp for the force it stands for
  float maxSpeed = 10.0f;              // [m/s]
  float maxAngularSpeed = 10.0f;       // [rad/s]
};

struct Drive {
  DriveDef def;
  template <class Archive>
  void serialize(Archive& a);
};

struct State;
struct SolverBody;

/// The joints and drives of one tick. World calls, in this order: prepare (once per solve), warmStart, then solve in every iteration,
/// store at the end. Works on solver bodies (see solver_body.h) indexed by body slot.
class JointSolver {
 public:
  void prepare(const State& state, float dt);
  void warmStart(SolverBody* bodies) const;
  void solve(SolverBody* bodies);
  /// Pushes anchors together by moving positions only (no velocity is touched). One pass.
  void correctPositions(State& state);
  void store(State& state) const;
  bool isEmpty() const { return rows_ == 0; }

 private:
  std::uint32_t rows_ = 0;
};

/// After `source` was replaced by pieces (still in the local frame of its body): joints whose anchor lay in `source` move to the
/// piece that contains the anchor (ties: the first), else to the nearest within `slop` [m], else are removed. `source` may be
/// among the pieces. Returns how many were removed.
std::uint32_t moveJoints(State& state, ShapeHandle source, const ShapeHandle* pieces, std::uint32_t count, float slop);

}  // namespace brittle::physics
