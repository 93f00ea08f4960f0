// World's part about drives in a build without them: there are none.
#include "engine/physics/world.h"

namespace brittle::physics {

DriveHandle World::createDrive(const DriveDef&) {
  return {};
}

void World::setDrive(DriveHandle, const DriveDef&) {}

void World::destroyDrive(DriveHandle) {}

}  // namespace brittle::physics
