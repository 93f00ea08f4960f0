// Sounds that tell the player something: bells, the crash, doors, the throw.
#include "engine/audio/modes.h"
#include "engine/audio/noise.h"
#include "engine/audio/synthesis.h"
#include "engine/math/trig.h"
#include "engine/math/types.h"

namespace brittle::audio {
namespace {

/// `from` into `to` from `at` on. [s]
void mix(const Samples& from, float at, float gain, Samples& to) {
  const std::size_t start = samplesIn(at);
  for (std::size_t i = 0; i < from.size() && start + i < to.size(); ++i) to[start + i] += gain * from[i];
}

void addThump(Samples& samples, float at, float high, float low, float decay, float amplitude) {
  const std::size_t start = samplesIn(at);
  double phase = 0.0;
  float level = amplitude;
  const float fall = exponential(-6.9077553f / (decay * static_cast<float>(kSampleRate)));
  const float settle = exponential(-1.0f / (0.03f * static_cast<float>(kSampleRate)));
  float above = high - low;
  for (std::size_t i = start; i < samples.size() && level > 1e-4f * amplitude; ++i) {
    samples[i] += level * static_cast<float>(sineOf(phase));
    phase += 2.0 * 3.14159265358979 * static_cast<double>(low + above) / static_cast<double>(kSampleRate);
    level *= fall;
    above *= settle;
  }
}

}  // namespace

float pitchOf(float note) {
  return static_cast<float>(440.0 * power(2.0, (static_cast<double>(note) - 69.0) / 12.0));
}

/// A bar of glass over a tuned tube, as a celesta's: the octaves that the tube holds up, and the bar's own inharmonic
/// partials, gone soon. Two tones a little apart make it live; their mean is the pitch.
Samples bell(float pitch) {
  const auto held = static_cast<float>(clampTo(1.9 * power(520.0 / static_cast<double>(pitch), 0.4), 0.7, 2.2));
  Samples samples(samplesIn(held * 1.15f), 0.0f);
  for (const float side : {-1.0f, 1.0f}) {
    addMode(samples, 0, {pitch * (1.0f + side * 0.0004f), held, 0.5f});
    addMode(samples, 0, {pitch * 2.0f * (1.0f + side * 0.0006f), held * 0.5f, 0.09f});
  }
  addMode(samples, 0, {pitch * 4.0f, held * 0.3f, 0.10f});
  addMode(samples, 0, {pitch * 2.757f, held * 0.16f, 0.16f});
  addMode(samples, 0, {pitch * 5.404f, held * 0.08f, 0.12f});
  addMode(samples, 0, {pitch * 8.933f, held * 0.04f, 0.06f});
  return samples;
}

Samples crash(Random& random) {
  Samples samples(samplesIn(1.7f), 0.0f);
  addThump(samples, 0.0f, 150.0f, 46.0f, 0.55f, 1.5f);
  addNoise(samples, {0, 0.35f, 0.001f, 0.22f, 420.0f, 160.0f, 1.2f, 1.6f}, random);
  addNoise(samples, {0, 0.2f, 0.0005f, 0.12f, 2600.0f, 900.0f, 1.3f, 1.6f}, random);
  const Samples broken = glassBreak(0.6f, random);
  mix(broken, 0.004f, 0.45f, samples);
  const Ring ring{5200.0f, 0.004f, 0.9f, 0.1f};
  const float lowest = random.nextFloat(310.0f, 340.0f);
  addStrike(samples, barModes(lowest, ring, random), {0, 0.35f, 1.5e-4f});
  return samples;
}

Samples door(Random& random) {
  Samples samples(samplesIn(1.25f), 0.0f);
  const Ring latch{5200.0f, 0.012f, 0.25f, 0.1f};
  addStrike(samples, barModes(420.0f, latch, random), {0, 0.7f, 2e-4f});
  addNoise(samples, {0, 0.03f, 0.0004f, 0.02f, 2400.0f, 1600.0f, 1.3f, 1.0f}, random);
  // The leaves slide: rollers on a rail, from slow to fast.
  addNoise(samples, {samplesIn(0.04f), 0.56f, 0.25f, 1.6f, 300.0f, 760.0f, 0.9f, 1.0f}, random);
  addNoise(samples, {samplesIn(0.04f), 0.56f, 0.30f, 1.2f, 1700.0f, 3600.0f, 0.8f, 0.30f}, random);
  // And stop.
  addThump(samples, 0.60f, 140.0f, 68.0f, 0.28f, 0.6f);
  addStrike(samples, barModes(265.0f, latch, random), {samplesIn(0.60f), 0.35f, 4e-4f});
  addNoise(samples, {samplesIn(0.60f), 0.05f, 0.0004f, 0.03f, 1400.0f, 700.0f, 1.3f, 1.0f}, random);
  return samples;
}

Samples swoosh(Random& random) {
  Samples samples(samplesIn(0.3f), 0.0f);
  addNoise(samples, {0, 0.3f, 0.06f, 0.30f, 950.0f, 420.0f, 0.7f, 1.0f}, random);
  addNoise(samples, {0, 0.25f, 0.05f, 0.20f, 2600.0f, 1300.0f, 0.8f, 0.35f}, random);
  return samples;
}

Samples sigh() {
  Samples samples(samplesIn(0.8f), 0.0f);
  double phase = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(kSampleRate);
    const float pitch = pitchOf(64.0f - 4.0f * minOf(t / 0.35f, 1.0f));
    const float level = minOf(t / 0.02f, 1.0f) * exponential(-6.0f * t);
    const auto tone = static_cast<float>(sineOf(phase) + 0.2 * sineOf(2.0 * phase));
    samples[i] = level * tone;
    phase += 2.0 * 3.14159265358979 * static_cast<double>(pitch) / static_cast<double>(kSampleRate);
  }
  return samples;
}

}  // namespace brittle::audio
