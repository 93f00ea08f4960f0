// game/sim/water.h - what water does to what falls into it: it carries and slows it, and is splashed. A stage of its
// own before and after the world's step, called only in rooms that demand water.
//
// A body is taken for a ball of its volume V and radius r about its centre: it carries as much of its weight as the
// share s of that ball below the surface pushes aside, and slows by its speed squared,
//
//   dv/dt = -g s Dw/D - c |v| v,   c = s Cd A Dw / (2 m),   A = pi r^2
//
// with the water's density Dw, the body's D and its mass m. The second is solved exactly over a tick, so it never turns
// a body round however fast it is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/types.h"
#include "engine/physics/world.h"
#include "game/sim/room_plan.h"

namespace brittle::sim {

/// The share of a ball of this radius [m] that is below the surface when its centre is `height` [m] above it.
float sunkShare(float height, float radius);

class Waters {
 public:
  /// What fell into water in a step.
  struct Entry {
    physics::BodyHandle body;
    Vec3 point = Vec3::Zero();     // on the surface [m]
    Vec3 velocity = Vec3::Zero();  // before it [m/s]
    float size = 0.0f;             // cube root of its volume [m]
  };

  /// Before the world's step of `seconds`. `shift`: from the room's frame to the world's; `gravity`: in
  /// rules::kGravity.
  void slow(physics::World& world, std::span<const PlannedWater> waters, float shift, float gravity,
            float seconds = rules::kTickSeconds);
  /// After it: those that came through a surface from above, in slot order, at most rules::kMaxSplashes. Valid until
  /// the next step.
  std::span<const Entry> entries(const physics::World& world, std::span<const PlannedWater> waters, float shift);
  /// How many more there were.
  std::uint32_t refused() const { return refused_; }

 private:
  /// What is over or in water, before the step.
  struct Swimmer {
    physics::BodyHandle body;
    float radius = 0.0f;  // of a ball of its volume [m]
    float size = 0.0f;    // cube root of that
    float lowest = 0.0f;  // [m]
    Vec3 velocity = Vec3::Zero();
  };
  void find(const physics::World& world, std::span<const PlannedWater> waters, float shift);
  void slow(physics::World& world, const Swimmer& swimmer, float share, float gravity, float seconds) const;

  // Kept to avoid allocating every tick.
  std::vector<Swimmer> swimmers_;
  std::vector<Entry> entries_;
  std::uint32_t refused_ = 0;
};

}  // namespace brittle::sim
