// sandbox/world_frame.h - a bare physics world as a picture: glass is what may break, stone what stands, balls are
// metal.
#pragma once

#include "engine/physics/world.h"
#include "engine/render/frame.h"

namespace brittle::sandbox {

/// Where a camera stands that circles about a point.
struct Orbit {
  Vec3 about = Vec3::Zero();  // [m]
  float turn = 0.5f;          // about Y [rad]; 0: from +Z
  float rise = 0.25f;         // above the horizon [rad]
  float distance = 4.0f;      // [m]
};

/// About everything that can break; of a world without such, about what can move.
Orbit orbitFor(const physics::World& world);
/// The view from there, looking at the point.
Transform viewFrom(const Orbit& orbit);

/// `restDark`: bodies put to rest are drawn darker. The frame points into the world's meshes: draw it before the world
/// goes on. `poolId`: another number for another world.
void fillFrame(physics::World& world, std::uint64_t poolId, const Orbit& orbit, bool restDark, render::Frame& frame);

}  // namespace brittle::sandbox
