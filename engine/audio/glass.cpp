// Glass. A pane's own tone is gone with its first crack; what is heard is the crack itself, a burst of noise and of
// many tiny fractures, and then shards: free plates of 2 to 15 cm that each ring at 1 to 15 kHz for a tenth of a second
// and knock against each other.
#include "engine/audio/modes.h"
#include "engine/audio/noise.h"
#include "engine/audio/synthesis.h"
#include "engine/math/trig.h"
#include "engine/math/types.h"

namespace brittle::audio {
namespace {

constexpr float kSheet = 0.004f;       // window glass, whatever the level draws [m]
constexpr float kHardContact = 2e-5f;  // glass on glass [s]

/// Free in the air or lying on something, which damps it.
Ring glassRing(bool free) {
  return {5500.0f, free ? 0.0014f : 0.003f, free ? 0.8f : 0.4f, 0.1f};
}

/// A time after which something that happens once per `mean` has happened. [s]
float waitFor(float mean, Random& random) {
  const float u = random.nextFloat();
  return -mean * logarithm(1.0f - u * 0.999f);
}

/// Between the two with as many per octave everywhere.
float perOctave(float low, float high, Random& random) {
  const float u = random.nextFloat();
  return low * exponential(u * logarithm(high / low));
}

Modes shardModes(float side, bool free, Random& random) {
  const float thickness = kSheet * random.nextFloat(0.8f, 1.2f);
  return plateModes(side, thickness, glassRing(free), random);
}

void addShard(Samples& samples, float at, float side, float strength, bool free, Random& random) {
  const Modes modes = shardModes(side, free, random);
  const float interval = random.nextFloat(0.02f, 0.09f);
  const float restitution = random.nextFloat(0.35f, 0.6f);
  const int count = 1 + static_cast<int>(random.nextBelow(free ? 2 : 4));
  addBounces(samples, modes, {samplesIn(at), strength, kHardContact}, interval, restitution, count);
}

/// The blow, before anything gives: the whole thing bends, low and short.
void addBlow(Samples& samples, float size, Random& random) {
  const Ring ring{5500.0f, 0.02f, 0.12f, 0.15f};
  const float lowest = 130.0f / size * random.nextFloat(0.85f, 1.15f);
  addStrike(samples, barModes(lowest, ring, random), {0, 0.7f, 3e-4f});
}

/// Cracks run at 1500 m/s and branch: within a few milliseconds hundreds of tiny fractures, each a click of its own.
void addCracks(Samples& samples, float size, Random& random) {
  addNoise(samples, {0, 0.03f, 0.0004f, 0.02f, 6500.0f, 5000.0f, 1.6f, 2.6f + 2.4f * size}, random);
  addNoise(samples, {0, 0.25f, 0.002f, 0.11f + 0.12f * size, 7500.0f, 4500.0f, 1.2f, 0.5f}, random);
  const int clicks = static_cast<int>(90.0f + 160.0f * size);
  const float mean = 0.010f + 0.03f * size;
  for (int i = 0; i < clicks; ++i) {
    const float at = waitFor(mean, random);
    const float frequency = perOctave(2200.0f, 15000.0f, random);
    const float decay = random.nextFloat(0.004f, 0.03f);
    const float strength = random.nextFloat();
    addMode(samples, samplesIn(at), {frequency, decay, 0.7f * strength * strength});
  }
}

}  // namespace

Samples glassBreak(float size, Random& random) {
  size = clampTo(size, 0.05f, 1.5f);
  Samples samples(samplesIn(0.7f + 0.8f * minOf(size, 1.0f)), 0.0f);
  addBlow(samples, size, random);
  addCracks(samples, size, random);
  const int shards = static_cast<int>(24.0f + 70.0f * size);
  const float mean = 0.10f + 0.13f * size, largest = 0.035f + 0.13f * size;
  for (int i = 0; i < shards; ++i) {
    const float at = 0.002f + waitFor(mean, random);
    const float side = perOctave(0.018f, largest, random);
    const float strength = random.nextFloat(0.1f, 1.0f);
    const float later = exponential(-at / (1.6f * mean));
    addShard(samples, at, side, 0.6f * strength * strength * later, true, random);
  }
  // What is left of a large pane holds pieces as wide as a hand, which ring near 700 Hz as they come down.
  for (int i = 0; i < 2 && size > 0.5f; ++i) {
    const float at = random.nextFloat(0.01f, 0.035f);
    addShard(samples, at, 0.19f * size, 0.16f, true, random);
  }
  return samples;
}

Samples shardRain(Random& random) {
  Samples samples(samplesIn(1.5f), 0.0f);
  for (int i = 0; i < 46; ++i) {
    const float first = random.nextFloat(0.0f, 0.3f);
    const float second = random.nextFloat(0.0f, 0.3f);
    const float late = waitFor(0.16f, random);
    const float side = perOctave(0.018f, 0.09f, random);
    const float strength = random.nextFloat(0.15f, 1.0f);
    addShard(samples, first + second + late, side, strength * strength * exponential(-2.5f * late), false, random);
  }
  return samples;
}

Samples tinkle(float side, Random& random) {
  Samples samples(samplesIn(0.25f + 2.0f * minOf(side, 0.2f)), 0.0f);
  addNoise(samples, {0, 0.01f, 0.0002f, 0.004f, 7000.0f, 7000.0f, 1.5f, 0.5f}, random);
  addShard(samples, 0.0f, side, 1.0f, false, random);
  if (random.nextBelow(2) == 1) addShard(samples, random.nextFloat(0.01f, 0.05f), side * 0.6f, 0.4f, false, random);
  return samples;
}

}  // namespace brittle::audio
