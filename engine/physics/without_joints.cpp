// World's part about joints in a build without them: there are none.
#include "engine/physics/world.h"

namespace brittle::physics {

JointHandle World::createJoint(const JointDef&) {
  return {};
}

void World::destroyJoint(JointHandle) {}

void World::setMotor(JointHandle, bool, float, float) {}

bool World::isAlive(JointHandle) const {
  return false;
}

const Joint& World::joint(JointHandle) const {
  static const Joint none;
  return none;
}

}  // namespace brittle::physics
