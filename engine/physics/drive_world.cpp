// World's part about drives: definitions checked.
#include "engine/core/assert.h"
#include "engine/physics/state.h"
#include "engine/physics/world.h"

namespace brittle::physics {
namespace {

/// The first rule a definition breaks, or null.
const char* faultOf(const DriveDef& def) {
  if (!isFinite(def.position)) return "DriveDef::position is finite";
  if (!isFinite(def.rotation) || def.rotation.squaredNorm() < 0.999f || def.rotation.squaredNorm() > 1.001f) return "DriveDef::rotation is a unit quaternion";
  if (!isFinite(def.strength) || def.strength <= 0.0f) return "DriveDef::strength is above 0";
  if (!isFinite(def.maxSpeed) || def.maxSpeed < 0.0f) return "DriveDef::maxSpeed is not negative";
  if (!isFinite(def.maxAngularSpeed) || def.maxAngularSpeed < 0.0f) return "DriveDef::maxAngularSpeed is not negative";
  return nullptr;
}

bool isSound(const DriveDef& def) {
  const char* const fault = faultOf(def);
  if (fault) assertFailed(fault, __FILE__, __LINE__);
  return !fault;
}

}  // namespace

DriveHandle World::createDrive(const DriveDef& def) {
  if (!isSound(def)) return {};
  Drive drive;
  drive.def = def;
  drive.def.rotation.normalize();
  return state_->drives.insert(drive);
}

void World::setDrive(DriveHandle handle, const DriveDef& def) {
  BR_ASSERT(state_->drives.contains(handle));
  if (!state_->drives.contains(handle) || !isSound(def)) return;
  state_->drives[handle].def = def;
  state_->drives[handle].def.rotation.normalize();
}

void World::destroyDrive(DriveHandle drive) {
  BR_ASSERT(state_->drives.contains(drive));
  if (state_->drives.contains(drive)) state_->drives.erase(drive);
}

}  // namespace brittle::physics
