#include "engine/effects/effect_set.h"

namespace brittle::effects {

void EffectSet::demand(Effect effect, std::string who) {
  ++counts_[static_cast<std::size_t>(effect)];
  demands_.push_back({effect, std::move(who)});
}

void EffectSet::clear() {
  counts_.fill(0);
  demands_.clear();
}

}  // namespace brittle::effects
