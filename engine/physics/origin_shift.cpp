// Moving the origin: everything in world space that outlives a tick moves with it, so that what is far from where the
// world began is computed with the same bits as what is near.
#include "engine/effects/has/drives.h"
#include "engine/effects/has/joints.h"
#include "engine/physics/state.h"
#include "engine/physics/world.h"

namespace brittle::physics {

void World::shiftOrigin(const Vec3& offset) {
  State& state = *state_;
  for (int i = 0; i < 3; ++i)
    BR_ASSERT(offset[i] * 256.0f == static_cast<float>(static_cast<std::int64_t>(offset[i] * 256.0f)));
  state.bodies.forEach([&](BodyHandle, Body& body) {
    body.pose.position -= offset;
    body.center -= offset;
    if (body.hasTarget) body.target.position -= offset;
  });
  for (Crumb& crumb : state.debris.crumbs) crumb.position -= offset;
  state.tree.shift(-offset);
  if constexpr (effects::kHasJoints) shiftJoints(state, offset);
  if constexpr (effects::kHasDrives) shiftDrives(state, offset);
}

}  // namespace brittle::physics
