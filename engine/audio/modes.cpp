#include "engine/audio/modes.h"

#include "engine/math/trig.h"
#include "engine/math/types.h"

namespace brittle::audio {
namespace {

constexpr double kRate = kSampleRate;
constexpr double kLn1000 = 6.907755278982137;  // 60 dB
constexpr double kPiExact = 3.14159265358979323846;

// Frequency parameters of a completely free square plate with Poisson's ratio 0.3, omega side^2 sqrt(mass per area /
// stiffness). Source: Leissa, Vibration of Plates, 1969, section 4.3.15, in the more exact values that later Ritz
// solutions agree on.
constexpr float kFreePlate[] = {13.47f, 19.60f, 24.27f, 34.80f, 34.80f, 61.09f,
                                61.09f, 63.69f, 69.27f, 77.17f, 105.5f, 117.1f};
constexpr float kFreeBar[] = {1.0f, 2.757f, 5.404f, 8.933f, 13.34f, 18.64f, 24.81f};

/// Share of a mode's amplitude that a contact of this duration excites: flat below 1 / (2 contact), then falling by 12
/// dB per octave.
float excited(float frequency, float contact) {
  const float x = 2.0f * frequency * contact;
  return 1.0f / (1.0f + x * x);
}

Mode modeAt(float frequency, const Ring& ring, Random& random) {
  const float off = random.nextFloat(-ring.spread, ring.spread);
  const float amplitude = random.nextFloat(0.35f, 1.0f);
  const float decay = random.nextFloat(0.7f, 1.2f);
  // A listener hears some modes pushed and some pulled: without it they all add up in the first samples to a spike that
  // is not there.
  const float sign = random.nextBelow(2) == 1 ? 1.0f : -1.0f;
  const float f = frequency * (1.0f + off);
  return {f, minOf(ring.longest, 2.2f / (ring.loss * f)) * decay, sign * amplitude};
}

}  // namespace

void addMode(Samples& samples, std::size_t start, const Mode& mode) {
  const double frequency = static_cast<double>(mode.frequency), decay = static_cast<double>(mode.decay);
  if (!(frequency > 5.0 && frequency < 0.45 * kRate && decay > 0.0) || mode.amplitude == 0.0f) return;
  const double omega = 2.0 * kPiExact * frequency / kRate;
  const double r = exponentialOf(-kLn1000 / (decay * kRate));
  const double a = 2.0 * r * cosineOf(omega), b = -r * r;
  const auto length = static_cast<std::size_t>(decay * kRate * (80.0 / 60.0));
  const std::size_t end = minOf(samples.size(), start + length);
  double before = 0.0, now = static_cast<double>(mode.amplitude) * r * sineOf(omega);
  for (std::size_t i = start + 1; i < end; ++i) {
    samples[i] += static_cast<float>(now);
    const double next = a * now + b * before;
    before = now;
    now = next;
  }
}

void addStrike(Samples& samples, const Modes& modes, const Strike& strike) {
  for (Mode mode : modes) {
    mode.amplitude *= strike.strength * excited(mode.frequency, strike.contact);
    addMode(samples, strike.start, mode);
  }
}

void addBounces(Samples& samples, const Modes& modes, Strike strike, float interval, float restitution, int count) {
  for (int i = 0; i < count && strike.start < samples.size(); ++i) {
    addStrike(samples, modes, strike);
    strike.start += samplesIn(interval);
    strike.strength *= restitution;
    strike.contact *= 1.15f;  // slower contacts last longer
    interval *= restitution;
  }
}

Modes plateModes(float side, float thickness, const Ring& ring, Random& random) {
  // omega = parameter / side^2 sqrt(stiffness / mass per area), and that root is about speed thickness / sqrt(12).
  const float unit = ring.speed * thickness / (3.4641016f * side * side * 2.0f * kPi);
  Modes modes;
  for (const float parameter : kFreePlate) modes.push_back(modeAt(parameter * unit, ring, random));
  return modes;
}

Modes barModes(float lowest, const Ring& ring, Random& random) {
  Modes modes;
  for (const float ratio : kFreeBar) modes.push_back(modeAt(lowest * ratio, ring, random));
  return modes;
}

}  // namespace brittle::audio
