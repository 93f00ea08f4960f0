// effects/effect.h - everything that costs time or memory and that a scene can do without. Each has a module of its
// own (built.h), which runs only where content demands it (effect_set.h) and the player has not switched it off.
#pragma once

#include <cstddef>
#include <cstdint>

namespace brittle::effects {

enum class Effect : std::uint8_t {
  // Physical: part of the state and its hash.
  Fracture,    // glass breaks inside the step
  Joints,      // ropes, hinges, sliders, welds
  Drives,      // soft pulls towards a pose
  Debris,      // crumbs too small to be bodies
  Stacks,      // tall piles that stand
  Water,       // slows what falls into it; ripples
  Explosions,  // of nitro balls and barrels
  Lasers,      // beams that hurt
  SlowMotion,  // time that runs slower for a while
  // Only seen:
  Fog,
  Bloom,         // lamps shine beyond their outline
  Mirror,        // polished floors show the room
  Shadows,       // soft ones under things
  Decals,        // pictures on surfaces
  Air,           // what floats in a room's air
  Splinters,     // sparkle and dust where something breaks or is hit
  Smoke,         // puffs that scripts let out
  DepthOfField,  // what is far from where one looks is blurred
  CameraRoll,    // the room turns about the way
  // Only heard:
  Reverb,
  Echo,
  LowPass,
  Music,
  Count
};

inline constexpr std::size_t kEffects = static_cast<std::size_t>(Effect::Count);

enum class Kind : std::uint8_t { Physical, Seen, Heard };

/// What a list of effects says of one.
struct EffectInfo {
  const char* name;  // as on the command line
  Kind kind;
  const char* demandedBy;  // which content asks for it
};

const EffectInfo& infoOf(Effect effect);
inline const char* nameOf(Effect effect) { return infoOf(effect).name; }

}  // namespace brittle::effects
