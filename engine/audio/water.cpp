// Water that is struck: a slap, the hiss of what is thrown up and falls back, and bubbles. A bubble of radius R rings
// at 3.26 m/s / R and rises in pitch as it closes. Source: Minnaert, On Musical Air-Bubbles and the Sounds of Running
// Water, 1933.
#include "engine/audio/noise.h"
#include "engine/audio/synthesis.h"
#include "engine/math/trig.h"
#include "engine/math/types.h"

namespace brittle::audio {
namespace {

/// One size of splash.
struct Pour {
  float length;      // [s]
  float slap, hiss;  // how loud
  float dark;        // lowest of the slap [Hz]
  int bubbles;
  float smallest, largest;  // radii of bubbles [m]
};
constexpr Pour kPours[] = {{0.30f, 0.15f, 0.10f, 900.0f, 3, 0.0010f, 0.0022f},
                           {0.55f, 0.45f, 0.45f, 520.0f, 9, 0.0012f, 0.0045f},
                           {0.95f, 0.85f, 0.80f, 300.0f, 20, 0.0014f, 0.0090f},
                           {1.50f, 1.20f, 1.00f, 150.0f, 38, 0.0016f, 0.0200f}};

void addBubble(Samples& samples, float at, float radius, float amplitude) {
  const float pitch = 3.26f / radius;
  // It loses its energy in about 12 swings, longer ones a little sooner.
  const float fall = exponential(-pitch / (7.0f * static_cast<float>(kSampleRate)));
  double phase = 0.0;
  float level = amplitude;
  for (std::size_t i = samplesIn(at); i < samples.size() && level * level > 1e-8f * amplitude * amplitude; ++i) {
    samples[i] += level * static_cast<float>(sineOf(phase));
    const float rising = 1.0f + 0.35f * (1.0f - level / amplitude);
    phase += 2.0 * 3.14159265358979 * static_cast<double>(pitch * rising) / static_cast<double>(kSampleRate);
    level *= fall;
  }
}

}  // namespace

Samples splash(int size, Random& random) {
  const Pour& pour = kPours[clampTo(size, 0, 3)];
  Samples samples(samplesIn(pour.length), 0.0f);
  const float tone = random.nextFloat(0.88f, 1.14f);
  addNoise(samples, {0, 0.14f, 0.0015f, 0.10f, 3.2f * pour.dark * tone, pour.dark * tone, 1.1f, 1.2f * pour.slap},
           random);
  addNoise(samples, {0, 0.05f, 0.0008f, 0.035f, 3600.0f, 1800.0f, 1.4f, 0.6f * pour.slap}, random);
  // What was thrown up, and what of it comes down again.
  const float hiss = minOf(2200.0f + 6.0f * pour.dark, 5200.0f);
  addNoise(
      samples,
      {samplesIn(0.01f), 0.8f * pour.length, 0.03f, 0.55f * pour.length, hiss, 0.5f * hiss, 1.2f, 0.50f * pour.hiss},
      random);
  addNoise(samples,
           {samplesIn(0.28f * pour.length), 0.7f * pour.length, 0.20f * pour.length, 0.6f * pour.length, 3000.0f,
            1700.0f, 1.0f, 0.35f * pour.hiss},
           random);
  for (int i = 0; i < pour.bubbles; ++i) {
    const float late = random.nextFloat(0.0f, 1.0f);
    const float share = random.nextFloat(0.0f, 1.0f);
    const float radius = pour.smallest + (pour.largest - pour.smallest) * share * share;
    const float loud = random.nextFloat(0.15f, 0.5f);
    const float side = i % 2 == 0 ? 1.0f : -1.0f;  // together they push the membrane to neither
    addBubble(samples, 0.02f + 0.65f * pour.length * late * late, radius,
              side * loud * (size == 0 ? 1.0f : 0.6f) * (0.25f + share));
  }
  return samples;
}

}  // namespace brittle::audio
