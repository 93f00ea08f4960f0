#include "engine/effects/effect_set.h"

namespace brittle::effects {

const char* nameOf(Effect effect) {
  switch (effect) {
    case Effect::Fracture:
      return "fracture";
    case Effect::Joints:
      return "joints";
    case Effect::Drives:
      return "drives";
    case Effect::Debris:
      return "debris";
    case Effect::Fog:
      return "fog";
    case Effect::Bloom:
      return "bloom";
    case Effect::Mirror:
      return "mirror";
    case Effect::Shadows:
      return "shadows";
    case Effect::Decals:
      return "decals";
    case Effect::Particles:
      return "particles";
    case Effect::Reverb:
      return "reverb";
    case Effect::Echo:
      return "echo";
    case Effect::LowPass:
      return "low-pass";
    case Effect::Music:
      return "music";
    case Effect::Count:
      break;
  }
  return "none";
}

void EffectSet::demand(Effect effect, std::string who) {
  ++counts_[static_cast<std::size_t>(effect)];
  demands_.push_back({effect, std::move(who)});
}

void EffectSet::clear() {
  counts_.fill(0);
  demands_.clear();
}

}  // namespace brittle::effects
