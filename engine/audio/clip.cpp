#include "engine/audio/clip.h"

#include <cmath>

#include "engine/math/types.h"

namespace brittle::audio {
namespace {

constexpr float kFade = 0.005f;  // [s]

float largest(const Samples& samples) {
  float peak = 0.0f;
  for (const float sample : samples) peak = maxOf(peak, std::fabs(sample));
  return peak;
}

}  // namespace

Clip::Clip(const Samples& samples, float peak) : samples_(samples.size() + kBefore + kAfter, 0.0f) {
  const float found = largest(samples);
  const float scale = found > 0.0f ? peak / found : 0.0f;
  const std::size_t fade = minOf(samplesIn(kFade), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t left = samples.size() - 1 - i;
    const float out = left < fade ? static_cast<float>(left) / static_cast<float>(fade) : 1.0f;
    samples_[kBefore + i] = samples[i] * scale * out;
  }
  loudest_.assign((samples.size() + kStep - 1) / kStep, 0.0f);
  float loudest = 0.0f;
  for (std::size_t i = samples.size(); i-- > 0;) {
    loudest = maxOf(loudest, std::fabs(samples_[kBefore + i]));
    loudest_[i / kStep] = loudest;
  }
}

}  // namespace brittle::audio
