#include "engine/audio/slow_motion.h"

#include "engine/math/trig.h"
#include "engine/math/types.h"

namespace brittle::audio {
namespace {

float eased(float t) {
  t = clampTo(t, 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace

Samples timeBend(bool rising) {
  constexpr float kPartials[] = {1.0f, 1.5f, 2.0f, 3.0f, 4.0f};  // root, fifth and octaves: at home in any key of C
  constexpr float kHighest = 523.25f;                            // C5 [Hz]
  const float length = rising ? 0.7f : 1.5f;
  Samples samples(samplesIn(length), 0.0f);
  double turns = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(samples.size());
    const float down = rising ? 1.0f - eased(t) : eased(t);
    const float frequency = kHighest * exponential(-1.3862944f * down);  // ln 4: two octaves
    turns += static_cast<double>(frequency) / static_cast<double>(kSampleRate);
    const float swell = eased(t / 0.08f) * eased((1.0f - t) / 0.5f);
    const float flutter = 1.0f - 0.35f * down * (0.5f + 0.5f * sine(2.0f * kPi * 9.0f * t));
    float sum = 0.0f;
    float strength = 1.0f;
    for (const float partial : kPartials) {
      sum += strength * static_cast<float>(sineOf(6.283185307179586 * turns * static_cast<double>(partial)));
      strength *= 0.55f - 0.15f * down;  // duller as it sinks
    }
    samples[i] = swell * flutter * sum;
  }
  return samples;
}

}  // namespace brittle::audio
