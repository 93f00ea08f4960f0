// hard_cases/support.h - which bodies stand, hang or are held, found by distance and by joints alone: without the
// engine's contacts and without its own idea of rest.
#pragma once

#include <vector>

#include "engine/physics/world.h"

namespace brittle::physics {

inline constexpr float kHolds = 0.003f;  // closer is support [m]: more than the slop and one tick's fall from rest

/// Whether two shapes are closer than `gap` [m].
bool areNear(const World& world, const Shape& a, const Shape& b, float gap);

/// By body slot: those that stand on what does not fall (static, animated, driven or weightless bodies) or hang from
/// it, directly or through others.
std::vector<bool> standing(const World& world);

/// Bodies asleep although nothing supports them: they float.
int floatingSleepers(const World& world);

}  // namespace brittle::physics
