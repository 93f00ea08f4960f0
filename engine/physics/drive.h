// physics/drive.h - drives: bodies pulled to a pose with a bounded push.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/archive.h"
#include "engine/math/transform.h"
#include "engine/physics/ids.h"

namespace brittle::physics {

/// Pulls a body towards a pose, softly: an obstacle that can be knocked out of its way. Acts on every dynamic body that
/// the shapes of an assembly now belong to, each once. The force law, per body of mass m [kg] and inertia I [kg m2]:
/// the drive carries the weight of what it moves, and beside that pushes with at most strength * 20 m/s2 * m [N] and
/// turns with at most strength * 40 rad/s2 * I [N m] towards the speed from which it can just stop at the target, but
/// no faster than the limits below. From strength 100 on both are unlimited.
struct DriveDef {
  std::uint32_t assembly = 0;
  bool drivePosition = false;
  Vec3 position = Vec3::Zero();  // world target of the assembly's original body frame [m]
  bool driveRotation = false;
  Quat rotation = Quat::Identity();
  float strength = 10.0f;         // 1: soft, 10: firm, 100: rigid [-], above 0
  float maxSpeed = 10.0f;         // [m/s]
  float maxAngularSpeed = 10.0f;  // [rad/s]
};

struct Drive {
  DriveDef def;

  template <class Archive>
  void serialize(Archive& ar) {
    ar(def.assembly);
    ar(def.drivePosition);
    ar(def.position);
    ar(def.driveRotation);
    ar(def.rotation);
    ar(def.strength);
    ar(def.maxSpeed);
    ar(def.maxAngularSpeed);
  }
};

struct State;
struct SolverBody;

/// A drive on one body, in velocities: the mass cancels.
struct PreparedDrive {
  BodyHandle body;
  std::uint32_t drive = 0;  // slot
  bool linear = false, angular = false;
  Vec3 target = Vec3::Zero();         // [m/s]
  Vec3 angularTarget = Vec3::Zero();  // [rad/s]
  Vec3 weight = Vec3::Zero();         // what gravity took this tick, to be given back [m/s]
  float limit = 0.0f;                 // of the change beside that [m/s]; negative: none
  float angularLimit = 0.0f;          // [rad/s]
  Vec3 change = Vec3::Zero();         // accumulated
  Vec3 angularChange = Vec3::Zero();
};

struct AssemblyDrive {
  std::uint32_t assembly = 0;
  std::uint32_t drive = 0;  // slot
  friend bool operator<(const AssemblyDrive& a, const AssemblyDrive& b) {
    return a.assembly != b.assembly ? a.assembly < b.assembly : a.drive < b.drive;
  }
};

/// The drives of one tick; used as JointSolver is.
class DriveSolver {
 public:
  /// `isFirstPass` false: a later pass of the same tick: what was spent so far goes on counting.
  void prepare(const State& state, float dt, bool isFirstPass = true);
  void solve(SolverBody* bodies);

 private:
  std::vector<PreparedDrive> drives_;      // by body slot, then drive slot
  std::vector<PreparedDrive> spent_;       // of the pass before
  std::vector<AssemblyDrive> assemblies_;  // sorted
};

/// Wakes sleeping bodies that a drive has not at its target yet. Before the velocities of a tick are integrated.
void wakeByDrives(State& state);

/// Targets after the origin moved by `offset` [m].
void shiftDrives(State& state, const Vec3& offset);

}  // namespace brittle::physics
