#include "engine/audio/mixer.h"

namespace brittle::audio {

/// Glides to what the room asks for within a quarter of a second; a room that asks for none does without.
void Mixer::applyLowPass() {
  constexpr float kGlide = 0.01f;  // of the way per block
  if (lowPass_ == 0.0f && lowPassGoal_ == 0.0f) return;
  lowPass_ += (lowPassGoal_ - lowPass_) * kGlide;
  if (lowPassGoal_ == 0.0f && lowPass_ < 1e-3f) lowPass_ = 0.0f;
  lowLeft_.tune(cutoffOf(lowPass_), 1.41421356f);
  lowRight_.tune(cutoffOf(lowPass_), 1.41421356f);
  for (int i = 0; i < kBlockFrames; ++i) {
    block_.left[i] = lowLeft_.process(block_.left[i]).low;
    block_.right[i] = lowRight_.process(block_.right[i]).low;
  }
  lowLeft_.settle();
  lowRight_.settle();
}

}  // namespace brittle::audio
