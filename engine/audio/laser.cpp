// Lasers: mains hum with its overtones, and the crackle of what they burn.
#include "engine/audio/noise.h"
#include "engine/audio/synthesis.h"
#include "engine/math/trig.h"
#include "engine/math/types.h"

namespace brittle::audio {
namespace {

void addCrackle(Samples& samples, int clicks, float within, Random& random) {
  for (int i = 0; i < clicks; ++i) {
    const float at = random.nextFloat(0.0f, within);
    const float pitch = random.nextFloat(1800.0f, 6500.0f);
    const float loud = random.nextFloat(0.15f, 0.6f);
    addNoise(samples, {samplesIn(at), 0.02f, 0.0003f, 0.012f, pitch, 0.6f * pitch, 1.0f, loud}, random);
  }
}

}  // namespace

Samples laserHum(Random& random) {
  constexpr float pitches[] = {100.0f, 200.0f, 301.0f, 599.0f, 1204.0f};
  constexpr float gains[] = {0.5f, 0.35f, 0.2f, 0.1f, 0.06f};
  Samples samples(samplesIn(1.6f), 0.0f);
  const float off = random.nextFloat(0.99f, 1.01f);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double turns = 6.28318530717959 * static_cast<double>(i) / static_cast<double>(kSampleRate);
    float sum = 0.0f;
    for (int k = 0; k < 5; ++k)
      sum += gains[k] * static_cast<float>(sineOf(static_cast<double>(pitches[k] * off) * turns));
    // Half a sine's hump: two that overlap by half keep their power.
    samples[i] = sum * sine(kPi * static_cast<float>(i) / static_cast<float>(samples.size()));
  }
  return samples;
}

Samples laserHit(Random& random) {
  Samples samples(samplesIn(0.35f), 0.0f);
  addNoise(samples, {0, 0.3f, 0.01f, 0.2f, 4200.0f, 2800.0f, 1.2f, 0.25f}, random);
  addCrackle(samples, 9, 0.28f, random);
  return samples;
}

Samples laserDischarge(Random& random) {
  Samples samples(samplesIn(0.9f), 0.0f);
  const float tone = random.nextFloat(0.8f, 1.25f);
  double phase = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(kSampleRate);
    const float pitch = tone * (70.0f + 1500.0f * exponential(-9.0f * t));
    const auto buzz = static_cast<float>(sineOf(phase) + 0.4 * sineOf(2.01 * phase));
    samples[i] += 0.6f * buzz * exponential(-5.5f * t);
    phase += 6.28318530717959 * static_cast<double>(pitch) / static_cast<double>(kSampleRate);
  }
  addNoise(samples, {0, 0.25f, 0.0005f, 0.18f, 3000.0f, 500.0f, 1.2f, 0.9f}, random);
  addCrackle(samples, 22, 0.6f, random);
  return samples;
}

}  // namespace brittle::audio
