// effects/effect_set.h - which effects a scene calls for, and who asked. An effect that nobody demands has no stage
// that runs.
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
  std::string who;  // "file:line", or the name of the code that asked
};

class EffectSet {
 public:
  void demand(Effect effect, std::string who);
  bool has(Effect effect) const { return counts_[static_cast<std::size_t>(effect)] > 0; }
  std::uint32_t count(Effect effect) const { return counts_[static_cast<std::size_t>(effect)]; }
  const std::vector<Demand>& demands() const { return demands_; }
  void clear();

 private:
  std::array<std::uint32_t, kEffects> counts_{};
  std::vector<Demand> demands_;
};

}  // namespace brittle::effects
