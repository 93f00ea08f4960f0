// physics/debris_step.h - the life of light debris: made by breaking, falling, resting on static geometry, recycled.
#pragma once

#include <functional>

#include "engine/effects/has/debris.h"
#include "engine/physics/state.h"

namespace brittle::physics {

/// A crumb of `volume` [m3]; overwrites the oldest when Accuracy::maxDebris are alive.
void addCrumb(State& state, const Vec3& position, const Vec3& velocity, float volume, std::uint32_t color);
/// A crumb that is no more, or never was.
inline void noteRecycled(State& state, float volume) {
  ++state.debris.recycled;
  state.debris.recycledVolume += volume;
  state.counters.omissions.add(Omission::RecycledCrumb);
}
/// What becomes of a piece too small to be a body: a crumb, or without the module its volume is counted as recycled.
inline void shed(State& state, const Vec3& position, const Vec3& velocity, float volume, std::uint32_t color) {
  if constexpr (effects::kHasDebris) {
    addCrumb(state, position, velocity, volume, color);
  } else {
    noteRecycled(state, volume);
  }
}
void stepDebris(State& state, float dt);
/// Those that `isGone` says yes to, in no particular order of asking; their volume counts as recycled.
void removeCrumbs(State& state, const std::function<bool(const Crumb&)>& isGone);

}  // namespace brittle::physics
