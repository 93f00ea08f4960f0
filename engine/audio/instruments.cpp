#include "engine/audio/instruments.h"

#include <cmath>

#include "engine/audio/modes.h"
#include "engine/audio/synthesis.h"
#include "engine/core/profile.h"
#include "engine/math/trig.h"
#include "engine/math/types.h"

namespace brittle::audio {
namespace {

/// From 0 to 1 without a corner.
float smooth(float t) {
  t = clampTo(t, 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// Adds a sine under a slow envelope; `late`: how much later than the others it has risen, and how much earlier it
/// falls. [s]
void addSwell(Samples& samples, float frequency, float amplitude, float late) {
  const double omega = 2.0 * 3.14159265358979 * static_cast<double>(frequency) / static_cast<double>(kSampleRate);
  const double a = 2.0 * cosineOf(omega);
  double before = 0.0, now = sineOf(omega);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(kSampleRate);
    const float rise = smooth(t / (kPadRise + late)),
                fall = smooth((kPadRise + kPadHold + kPadFall - t) / (kPadFall + late));
    samples[i] += amplitude * rise * fall * static_cast<float>(now);
    const double next = a * now - before;
    before = now;
    now = next;
  }
}

/// Partials as of a bowed glass, each twice and a little apart, so that it moves; the higher ones open up and close
/// again.
Samples pad(float frequency) {
  Samples samples(samplesIn(kPadRise + kPadHold + kPadFall), 0.0f);
  for (int harmonic = 1; harmonic <= 7; ++harmonic) {
    const auto h = static_cast<float>(harmonic);
    const float amplitude = 1.0f / (h * std::sqrt(h)) * (harmonic % 2 == 0 ? 0.8f : 1.0f);
    for (const float side : {-1.0f, 1.0f})
      addSwell(samples, frequency * h * (1.0f + side * 0.0012f), amplitude, 0.25f * (h - 1.0f));
  }
  return samples;
}

Samples bass(float frequency) {
  Samples samples(samplesIn(3.6f), 0.0f);
  for (const Mode& mode :
       {Mode{frequency, 3.2f, 1.0f}, Mode{2.0f * frequency, 2.2f, 0.35f}, Mode{3.0f * frequency, 1.4f, 0.12f}})
    addMode(samples, 0, mode);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] *= smooth(static_cast<float>(i) / (0.06f * static_cast<float>(kSampleRate)));
  return samples;
}

/// A marimba's bar is cut so that its second mode is at 4, its third near 10 times the first.
Samples mallet(float frequency) {
  Samples samples(samplesIn(1.4f), 0.0f);
  const float held = clampTo(1.3f * std::sqrt(260.0f / frequency), 0.4f, 1.6f);
  for (const Mode& mode : {Mode{frequency, held, 1.0f}, Mode{4.0f * frequency, 0.3f * held, 0.22f},
                           Mode{9.9f * frequency, 0.08f * held, 0.1f}})
    addMode(samples, 0, mode);
  return samples;
}

}  // namespace

Instruments::Instruments() {
  BR_ZONE("instruments");
  const auto make = [&](Instrument instrument, std::initializer_list<float> notes, Samples (*play)(float)) {
    for (const float note : notes)
      made_[static_cast<std::size_t>(instrument)].push_back({note, Clip(play(pitchOf(note)))});
  };
  make(Instrument::Pad, {51, 58, 65, 72}, pad);
  make(Instrument::Bass, {36, 43}, bass);
  make(Instrument::Mallet, {62, 72, 82}, mallet);
}

Instruments::Tone Instruments::tone(Instrument instrument, float note) const {
  const Made* nearest = nullptr;
  for (const Made& made : made_[static_cast<std::size_t>(instrument)])
    if (nearest == nullptr || std::fabs(made.note - note) < std::fabs(nearest->note - note)) nearest = &made;
  return {&nearest->clip, static_cast<float>(power(2.0, static_cast<double>(note - nearest->note) / 12.0))};
}

std::size_t Instruments::bytes() const {
  std::size_t sum = 0;
  for (const std::vector<Made>& all : made_)
    for (const Made& made : all) sum += made.clip.bytes();
  return sum;
}

}  // namespace brittle::audio
