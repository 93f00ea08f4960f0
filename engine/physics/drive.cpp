#include "engine/physics/drive.h"

#include <algorithm>
#include <cmath>

#include "engine/physics/state.h"

namespace brittle::physics {

namespace {

// Acceleration per unit of strength. Chosen by eye: at strength 1 a struck door swings away and is back within a
// second, at 10 it gives way for a few ticks only.
constexpr float kPush = 20.0f;  // [m/s2]
constexpr float kTurn = 40.0f;  // [rad/s2]
constexpr float kRigid = 100.0f;
// Closer to its target than this a driven body may sleep.
constexpr float kThere = 1e-3f;       // [m]
constexpr float kThereAngle = 5e-3f;  // [rad]

/// The speed from which a body can stop after `distance` when it loses a dt per tick: v^2 + v a dt = 2 a d, since the
/// sum of such falling steps is the distance. The last step just arrives and may take 9/8 of a dt (v = 3/2 a dt), so a
/// is 8/9 of what there is.
float stoppingSpeed(float distance, float acceleration, float fastest, float dt) {
  float speed = minOf(distance / dt, fastest);
  if (acceleration >= 0.0f) {
    const float a = acceleration * (8.0f / 9.0f);
    const float half = 0.5f * a * dt;
    speed = minOf(speed, std::sqrt(half * half + 2.0f * a * distance) - half);
  }
  return speed;
}

Vec3 offsetTo(const DriveDef& def, const Body& body) {
  const Quat& rotation = def.driveRotation ? def.rotation : body.pose.rotation;
  return def.position + rotation * body.localCenter - body.center;
}

/// The shortest rotation vector from the body to the target. [rad]
Vec3 turnTo(const DriveDef& def, const Body& body) {
  Quat turn = def.rotation * body.pose.rotation.conjugate();
  if (turn.w() < 0.0f) turn.coeffs() = -turn.coeffs();
  const float sine = turn.vec().norm();
  if (sine < 1e-9f) return Vec3::Zero();
  return turn.vec() * (2.0f * arcTangent(sine, turn.w()) / sine);
}

PreparedDrive prepareDrive(const DriveDef& def, const Body& body, const Vec3& gravity, float dt) {
  PreparedDrive drive;
  const bool isRigid = def.strength >= kRigid;
  const float push = isRigid ? -1.0f : def.strength * kPush;
  const float turn = isRigid ? -1.0f : def.strength * kTurn;
  if (def.drivePosition) {
    const Vec3 offset = offsetTo(def, body);
    const float distance = offset.norm();
    drive.linear = true;
    drive.limit = push * dt;
    drive.weight = gravity * (body.gravityScale * dt);
    if (distance > 1e-9f) drive.target = offset * (stoppingSpeed(distance, push, def.maxSpeed, dt) / distance);
  }
  if (def.driveRotation) {
    const Vec3 offset = turnTo(def, body);
    const float angle = offset.norm();
    drive.angular = true;
    drive.angularLimit = turn * dt;
    if (angle > 1e-9f) drive.angularTarget = offset * (stoppingSpeed(angle, turn, def.maxAngularSpeed, dt) / angle);
  }
  return drive;
}

bool isBefore(const PreparedDrive& a, const PreparedDrive& b) {
  return a.body.index != b.body.index ? a.body.index < b.body.index : a.drive < b.drive;
}

/// Changes `value` towards `target` as far as the accumulated change, seen from `free`, stays within `limit`.
void drive(const Vec3& target, const Vec3& free, float limit, Vec3& change, Vec3& value) {
  Vec3 paid = change + (target - value) - free;
  const float size = paid.norm();
  if (limit >= 0.0f && size > limit) paid *= limit / size;
  const Vec3 wanted = paid + free;
  value += wanted - change;
  change = wanted;
}

bool isThere(const DriveDef& def, const Body& body) {
  if (def.drivePosition && !(offsetTo(def, body).norm() < kThere)) return false;
  return !def.driveRotation || turnTo(def, body).norm() < kThereAngle;
}

void solveDrive(PreparedDrive& prepared, SolverBody& body) {
  if (prepared.linear) drive(prepared.target, -prepared.weight, prepared.limit, prepared.change, body.velocity);
  if (prepared.angular)
    drive(prepared.angularTarget, Vec3::Zero(), prepared.angularLimit, prepared.angularChange, body.angularVelocity);
}

}  // namespace

void DriveSolver::prepare(const State& state, float dt, bool isFirstPass) {
  spent_.swap(drives_);
  drives_.clear();
  if (state.drives.size() == 0) return;
  assemblies_.clear();
  state.drives.forEach([&](DriveHandle handle, const Drive& drive) {
    assemblies_.push_back({drive.def.assembly, handle.index});
  });
  std::sort(assemblies_.begin(), assemblies_.end());
  state.bodies.forEach([&](BodyHandle handle, const Body& body) {
    if (!body.isDynamic() || !body.awake) return;
    const AssemblyDrive first{body.assembly, 0};
    for (auto it = std::lower_bound(assemblies_.begin(), assemblies_.end(), first);
         it != assemblies_.end() && it->assembly == body.assembly; ++it) {
      PreparedDrive prepared = prepareDrive(state.drives.at(it->drive).def, body, state.gravity, dt);
      prepared.body = handle;
      prepared.drive = it->drive;
      const auto before =
          isFirstPass ? spent_.end() : std::lower_bound(spent_.begin(), spent_.end(), prepared, isBefore);
      if (before != spent_.end() && before->body == handle && before->drive == it->drive) {
        prepared.change = before->change;
        prepared.angularChange = before->angularChange;
      }
      drives_.push_back(prepared);
    }
  });
}

void DriveSolver::solve(SolverBody* bodies) {
  for (PreparedDrive& drive : drives_) solveDrive(drive, bodies[drive.body.index]);
}

void wakeByDrives(State& state) {
  if (state.drives.size() == 0) return;
  state.bodies.forEach([&](BodyHandle, Body& body) {
    if (!body.isDynamic() || body.awake) return;
    state.drives.forEach([&](DriveHandle, const Drive& drive) {
      if (drive.def.assembly == body.assembly && !isThere(drive.def, body)) body.wake();
    });
  });
}

void shiftDrives(State& state, const Vec3& offset) {
  state.drives.forEach([&](DriveHandle, Drive& drive) { drive.def.position -= offset; });
}

}  // namespace brittle::physics
