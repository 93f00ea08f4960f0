#include "engine/audio/noise.h"

#include "engine/audio/filter.h"

namespace brittle::audio {

void addNoise(Samples& samples, const NoiseBurst& burst, Random& random) {
  constexpr std::size_t kRetune = 16;  // samples between two steps of the glide
  StateVariable filter;
  const std::size_t length = samplesIn(burst.length), attack = samplesIn(burst.attack);
  const float fall = exponential(-6.9077553f / maxOf(burst.decay * static_cast<float>(kSampleRate), 1.0f));
  float level = burst.amplitude;
  for (std::size_t i = 0; i < length && burst.start + i < samples.size(); ++i) {
    if (i % kRetune == 0) {
      const float t = static_cast<float>(i) / static_cast<float>(length);
      filter.tune(burst.from + (burst.to - burst.from) * t, burst.damping);
    }
    const float rise = i < attack ? static_cast<float>(i) / static_cast<float>(attack) : 1.0f;
    samples[burst.start + i] += filter.process(random.nextFloat(-1.0f, 1.0f)).band * level * rise;
    if (i >= attack) level *= fall;
  }
}

}  // namespace brittle::audio
