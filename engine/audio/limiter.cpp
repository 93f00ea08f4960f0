#include "engine/audio/limiter.h"

#include <utility>

namespace brittle::audio {
namespace {

constexpr float kRecovery = 0.006f;  // of the way back to 1 per block: about 110 ms

float fitting(float peak) {
  return peak > kCeiling ? kCeiling / peak : 1.0f;
}

}  // namespace

void Limiter::process(Block& block) {
  const float peak = block.peak();
  const float recovered = gain_ > 0.9999f ? 1.0f : gain_ + (1.0f - gain_) * kRecovery;
  const float end = minOf(recovered, minOf(fitting(heldPeak_), fitting(peak)));
  std::swap(block, held_);
  heldPeak_ = peak;
  if (gain_ != 1.0f || end != 1.0f) {
    for (int i = 0; i < kBlockFrames; ++i) {
      const float gain = gain_ + (end - gain_) * (static_cast<float>(i) / static_cast<float>(kBlockFrames));
      block.left[i] *= gain;
      block.right[i] *= gain;
    }
  }
  gain_ = end;
}

}  // namespace brittle::audio
