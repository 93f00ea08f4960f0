#include "engine/audio/blast.h"

#include "engine/audio/modes.h"
#include "engine/audio/noise.h"
#include "engine/math/trig.h"
#include "engine/math/types.h"

namespace brittle::audio {
namespace {

/// The pressure wave: a sine that starts high and runs down to `lowest` as the ball of fire grows. [Hz]
void addPressureWave(Samples& samples, float highest, float lowest, float fall, float length, float amplitude) {
  double phase = 0.0;
  const float rate = static_cast<float>(kSampleRate);
  for (std::size_t i = 0; i < samplesIn(length) && i < samples.size(); ++i) {
    const float t = static_cast<float>(i) / rate;
    const float frequency = lowest + (highest - lowest) * exponential(-t / fall);
    phase += static_cast<double>(2.0f * kPi * frequency / rate);
    const float envelope = exponential(-5.0f * t / length) * minOf(t / 0.002f, 1.0f);
    samples[i] += amplitude * envelope * static_cast<float>(sineOf(phase));
  }
}

}  // namespace

Samples blast(float size, Random& random) {
  const float length = 0.8f + 1.7f * size;
  Samples samples(samplesIn(length), 0.0f);
  const float detune = random.nextFloat(0.92f, 1.08f);
  const float slow = random.nextFloat(0.7f, 1.4f);
  addPressureWave(samples, (190.0f - 60.0f * size) * detune, (58.0f - 24.0f * size) * detune,
                  (0.05f + 0.07f * size) * slow, 0.5f + 0.9f * size, 1.0f);
  // The crack, the roar that follows it, and what rumbles on.
  addNoise(samples, {0, 0.09f, 0.0005f, 0.07f, 4200.0f, 1200.0f, 1.4f, 0.9f - 0.3f * size}, random);
  addNoise(samples, {0, length, 0.004f, 0.55f + 0.8f * size, 900.0f - 350.0f * size, 120.0f, 1.2f, 0.8f}, random);
  addNoise(samples, {samplesIn(0.05f), length - 0.05f, 0.12f, 0.9f + 1.3f * size, 160.0f, 55.0f, 0.8f, 0.6f * size},
           random);
  const int bits = static_cast<int>(5.0f + 9.0f * size);
  for (int i = 0; i < bits; ++i) {  // what it threw up comes down
    const float at = random.nextFloat(0.18f, 0.55f + 0.9f * size);
    const float pitch = random.nextFloat(300.0f, 1400.0f);
    const float strength = random.nextFloat(0.02f, 0.08f);
    addNoise(samples, {samplesIn(at), 0.05f, 0.001f, 0.04f, pitch, 0.7f * pitch, 0.9f, strength}, random);
  }
  return samples;
}

}  // namespace brittle::audio
