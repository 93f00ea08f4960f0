// What a heavy steel ball sounds like is what it hits: 72 kg of steel ring at 10 kHz and higher, hardly audible, while
// concrete thuds, a sheet of metal clangs and wood gives a short hollow knock.
#include "engine/audio/modes.h"
#include "engine/audio/noise.h"
#include "engine/audio/synthesis.h"
#include "engine/math/types.h"

namespace brittle::audio {
namespace {

/// The push into the ground: a tone that falls within two periods.
void addThud(Samples& samples, float frequency, float decay, float amplitude, Random& random) {
  const float off = random.nextFloat(0.9f, 1.1f);
  addMode(samples, 0, {frequency * off, decay, amplitude});
  addMode(samples, 0, {frequency * off * 1.62f, decay * 0.6f, amplitude * 0.6f});
  addMode(samples, 0, {frequency * off * 2.71f, decay * 0.35f, amplitude * 0.4f});
}

/// The ball's own lowest modes, faint.
void addBallRing(Samples& samples, float amplitude, Random& random) {
  for (const float frequency : {4100.0f, 6150.0f, 8900.0f}) {
    const float off = random.nextFloat(0.97f, 1.03f);
    const float decay = random.nextFloat(0.12f, 0.28f);
    addMode(samples, 0, {frequency * off, decay, amplitude * 2500.0f / frequency});
  }
}

Samples onStone(Random& random) {
  Samples samples(samplesIn(0.4f), 0.0f);
  addThud(samples, 105.0f, 0.14f, 0.45f, random);
  const Ring ring{3500.0f, 0.06f, 0.1f, 0.2f};
  const float lowest = random.nextFloat(260.0f, 330.0f);
  addStrike(samples, barModes(lowest, ring, random), {0, 0.7f, 2.5e-4f});
  addNoise(samples, {0, 0.03f, 0.0003f, 0.018f, 2600.0f, 1500.0f, 1.4f, 1.3f}, random);
  addNoise(samples, {0, 0.16f, 0.001f, 0.10f, 900.0f, 500.0f, 1.2f, 0.6f}, random);
  addBallRing(samples, 0.10f, random);
  return samples;
}

/// A slab that stands free gives more than the ground: higher, hollower, and it shakes a little longer.
Samples onWall(Random& random) {
  Samples samples(samplesIn(0.5f), 0.0f);
  const Ring ring{3500.0f, 0.025f, 0.2f, 0.15f};
  addThud(samples, 175.0f, 0.17f, 0.4f, random);
  const float lowest = random.nextFloat(430.0f, 520.0f);
  addStrike(samples, barModes(lowest, ring, random), {0, 0.8f, 1.5e-4f});
  addNoise(samples, {0, 0.03f, 0.0003f, 0.016f, 3600.0f, 2200.0f, 1.4f, 1.2f}, random);
  addNoise(samples, {0, 0.12f, 0.001f, 0.08f, 1300.0f, 800.0f, 1.2f, 0.4f}, random);
  addBallRing(samples, 0.12f, random);
  return samples;
}

Samples onMetal(Random& random) {
  Samples samples(samplesIn(1.4f), 0.0f);
  const Ring ring{5200.0f, 0.002f, 1.0f, 0.12f};
  addThud(samples, 130.0f, 0.12f, 0.3f, random);
  addNoise(samples, {0, 0.02f, 0.0002f, 0.010f, 4200.0f, 3000.0f, 1.4f, 0.6f}, random);
  const float side = random.nextFloat(0.42f, 0.5f);
  addStrike(samples, plateModes(side, 0.02f, ring, random), {0, 0.45f, 9e-5f});
  const float lowest = random.nextFloat(760.0f, 900.0f);
  addStrike(samples, barModes(lowest, ring, random), {0, 0.65f, 6e-5f});
  return samples;
}

Samples onWood(Random& random) {
  Samples samples(samplesIn(0.35f), 0.0f);
  const Ring ring{4000.0f, 0.035f, 0.12f, 0.15f};
  addThud(samples, 140.0f, 0.09f, 0.4f, random);
  addNoise(samples, {0, 0.015f, 0.0003f, 0.012f, 1700.0f, 1000.0f, 1.4f, 0.9f}, random);
  const float lowest = random.nextFloat(280.0f, 340.0f);
  addStrike(samples, barModes(lowest, ring, random), {0, 0.8f, 2e-4f});
  return samples;
}

/// Glass that holds, or a whole block of it on the floor: a clink with a body.
Samples onGlass(Random& random) {
  Samples samples(samplesIn(0.7f), 0.0f);
  const Ring ring{5500.0f, 0.0045f, 0.45f, 0.08f};
  addThud(samples, 210.0f, 0.06f, 0.3f, random);
  addNoise(samples, {0, 0.01f, 0.0002f, 0.006f, 5500.0f, 4500.0f, 1.4f, 0.5f}, random);
  const float side = random.nextFloat(0.115f, 0.14f);
  addStrike(samples, plateModes(side, 0.006f, ring, random), {0, 0.6f, 6e-5f});
  return samples;
}

Samples onSteel(Random& random) {
  Samples samples(samplesIn(0.5f), 0.0f);
  addNoise(samples, {0, 0.008f, 0.0002f, 0.005f, 5200.0f, 4200.0f, 1.3f, 0.8f}, random);
  addThud(samples, 240.0f, 0.03f, 0.3f, random);
  addBallRing(samples, 1.4f, random);
  addBallRing(samples, 1.0f, random);  // two balls
  return samples;
}

}  // namespace

Samples knock(Struck struck, Random& random) {
  switch (struck) {
    case Struck::Wall:
      return onWall(random);
    case Struck::Metal:
      return onMetal(random);
    case Struck::Wood:
      return onWood(random);
    case Struck::Glass:
      return onGlass(random);
    case Struck::Steel:
      return onSteel(random);
    case Struck::Stone:
      break;
  }
  return onStone(random);
}

}  // namespace brittle::audio
