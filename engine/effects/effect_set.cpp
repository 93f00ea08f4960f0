#include "engine/effects/effect_set.h"

namespace brittle::effects {

void EffectSet::demand(Effect effect, std::string who) {
  ++counts_[static_cast<std::size_t>(effect)];
  demands_.push_back({effect, std::move(who)});
}

EffectMask EffectSet::demanded() const {
  EffectMask mask;
  for (std::size_t i = 0; i < kEffects; ++i)
    if (counts_[i] > 0) mask = mask.with(static_cast<Effect>(i));
  return mask;
}

void EffectSet::keep(EffectMask mask, const std::string& who) {
  for (std::size_t i = 0; i < kEffects; ++i)
    if (const auto effect = static_cast<Effect>(i); mask.has(effect) && !has(effect)) demand(effect, who);
}

EffectMask EffectSet::running() const {
  EffectMask mask;
  for (std::size_t i = 0; i < kEffects; ++i)
    if (const auto effect = static_cast<Effect>(i); runs(effect)) mask = mask.with(effect);
  return mask;
}

void EffectSet::clear() {
  counts_.fill(0);
  demands_.clear();
}

}  // namespace brittle::effects
