// game/sim/charge.h - what a ball carries. Used by the simulation and by what shows it.
#pragma once

#include <cstdint>

namespace brittle::sim {

/// What a ball does at its first touch: nothing more, a blast, a large one.
enum class Charge : std::uint8_t { None, Nitro, Barrel };

}  // namespace brittle::sim
