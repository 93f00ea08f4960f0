// physics/explosion.h - a blast in a world: glass near it breaks, what is loose is pushed, where nothing stands
// between. The module of Effect::Explosions; written with World's own calls, so that breaking and pushing are counted
// as ever.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/physics/world.h"

namespace brittle::physics {

/// All lengths from the centre. What does not burst shields what is behind it; glass that bursts does not.
struct ExplosionDef {
  Vec3 center = Vec3::Zero();  // [m], outside of what stands still
  float breakReach = 1.0f;     // breaks what may break up to here [m] >= 0
  float pushReach = 3.0f;      // pushes up to here [m] > 0
  float pressure = 60.0f;      // impulse on each m2 that faces a centre close by [N s/m2] >= 0
  float mostSpeed = 12.0f;     // light things do not gain more [m/s] > 0
  float breakSpeed = 12.0f;    // cracks as a hit of this speed close by makes them [m/s] > 0
};

/// What came of one.
struct Explosion {
  std::vector<BreakEvent> breaks;  // nearest first; impulse: what the body held [N s]
  Vec3 momentum = Vec3::Zero();    // given to all that is loose, together [N s]
  float impulse = 0.0f;            // the same, magnitudes added [N s]
  std::uint32_t pushed = 0;        // shapes
};

/// The share of a blast that arrives at `distance` of `reach`: (1 - distance / reach)^2, 0 beyond.
float shareAt(float distance, float reach);

/// What a shape of `area` [m2] towards the centre and of `mass` [kg] gains at `distance` [m]. [N s]
float impulseAt(const ExplosionDef& def, float distance, float area, float mass);

/// The area of a convex's outline seen along the unit vector `direction` of its own frame: half of what its faces turn
/// that way or the other. [m2]
float outlineArea(const geometry::ConvexView& convex, const Vec3& direction);

/// Breaks, nearest first, then pushes each loose shape at its middle, away from the centre. A function of the world and
/// the definition.
Explosion explode(World& world, const ExplosionDef& def);

}  // namespace brittle::physics
