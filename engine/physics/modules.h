// physics/modules.h - which of physics' own effects are compiled in: who calls their code asks here with
// `if constexpr`, so that a build without one links nothing of it.
#pragma once

#include "engine/effects/built.h"

namespace brittle::physics {

inline constexpr bool kHasFracture = effects::isBuilt(effects::Effect::Fracture);
inline constexpr bool kHasJoints = effects::isBuilt(effects::Effect::Joints);
inline constexpr bool kHasDrives = effects::isBuilt(effects::Effect::Drives);
inline constexpr bool kHasDebris = effects::isBuilt(effects::Effect::Debris);
inline constexpr bool kHasStacks = effects::isBuilt(effects::Effect::Stacks);

}  // namespace brittle::physics
