// effects/effect_set.h - which effects a scene calls for, and who asked. A stage runs only if its effect is demanded,
// compiled in and not switched off by the player.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/effects/effect.h"

namespace brittle::effects {

/// A reason an effect is on: the content that asked for it.
struct Demand {
  Effect effect;
  std::string who;  // "file:line", or of a rule of the engine's own "by the game: which"
};

class EffectSet {
 public:
  void demand(Effect effect, std::string who);
  bool has(Effect effect) const { return counts_[static_cast<std::size_t>(effect)] > 0; }
  std::uint32_t count(Effect effect) const { return counts_[static_cast<std::size_t>(effect)]; }
  const std::vector<Demand>& demands() const { return demands_; }
  void clear();
  /// Every effect that somebody demands.
  EffectMask demanded() const;
  /// Demands those of `mask` that nobody does, in the name of `who`: a snapshot does not say who asked.
  void keep(EffectMask mask, const std::string& who);

  /// What the player does not want; demands are still noted.
  void switchOff(EffectMask mask) { off_ = mask; }
  /// Whether the effect's stage is to be called.
  bool runs(Effect effect) const { return has(effect) && isBuilt(effect) && !off_.has(effect); }
  /// All of those.
  EffectMask running() const;

 private:
  std::array<std::uint32_t, kEffects> counts_{};
  std::vector<Demand> demands_;
  EffectMask off_;
};

}  // namespace brittle::effects
