// effects/effect.h - everything that costs time or memory and that a scene can do without. Each has a module of its
// own (has/NAME.h), which runs only where content demands it (effect_set.h) and the player has not switched it off.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace brittle::effects {

enum class Effect : std::uint8_t {
  // Physical: part of the state and its hash.
  Fracture,    // glass breaks inside the step
  Joints,      // ropes, hinges, sliders, welds
  Drives,      // soft pulls towards a pose
  Debris,      // crumbs too small to be bodies
  Stacks,      // piles that stand
  Water,       // slows what falls into it; ripples
  Explosions,  // of nitro balls and barrels
  Lasers,      // beams that hurt
  SlowMotion,  // time that runs slower for a while
  CameraRoll,  // the room turns about the way, and with it where a throw goes
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

/// Any number of effects.
class EffectMask {
 public:
  constexpr bool has(Effect effect) const { return (bits_ & bitOf(effect)) != 0; }
  constexpr EffectMask with(Effect effect) const { return EffectMask(bits_ | bitOf(effect)); }
  constexpr EffectMask with(EffectMask others) const { return EffectMask(bits_ | others.bits_); }
  /// Those that are in both.
  constexpr EffectMask both(EffectMask others) const { return EffectMask(bits_ & others.bits_); }
  constexpr bool isEmpty() const { return bits_ == 0; }
  friend constexpr bool operator==(EffectMask, EffectMask) = default;

  constexpr EffectMask() = default;
  /// Bits beyond the known effects are dropped.
  static constexpr EffectMask ofBits(std::uint32_t bits) { return EffectMask(bits & (bitOf(Effect::Count) - 1)); }
  constexpr std::uint32_t bits() const { return bits_; }

 private:
  constexpr explicit EffectMask(std::uint32_t bits) : bits_(bits) {}
  static constexpr std::uint32_t bitOf(Effect effect) { return 1u << static_cast<unsigned>(effect); }
  std::uint32_t bits_ = 0;
};
static_assert(kEffects < 32);

/// All effects of a kind.
EffectMask maskOf(Kind kind);
/// Nothing if no effect has that name.
std::optional<Effect> effectNamed(std::string_view name);
const EffectInfo& infoOf(Effect effect);
inline const char* nameOf(Effect effect) {
  return infoOf(effect).name;
}
/// Whether its module is compiled in. Where a stage is called, kHasNAME says so to the compiler.
bool isBuilt(Effect effect);

}  // namespace brittle::effects
