#include "engine/audio/instruments.h"

#include <cmath>
#include <iterator>

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

/// What has no high overtones is kept in fewer samples, so many times fewer: that takes less time and memory by as
/// much. A pad's end below 4 kHz, a bass's below 300 Hz.
constexpr std::size_t kPadStride = 3, kBassStride = 4;
constexpr float kPadRate = static_cast<float>(kSampleRate / kPadStride);  // [1/s]

/// How loud an overtone of a pad is; `late`: how much later than the others it has risen, and how much earlier it
/// falls. [s]
float swell(float seconds, float late) {
  return smooth(seconds / (kPadRise + late)) * smooth((kPadRise + kPadHold + kPadFall - seconds) / (kPadFall + late));
}

/// A sine that starts at zero, four samples at a time, which do not wait for each other:
/// s(i + 4) = 2 cos(4 omega) s(i) - s(i - 4).
struct Sine {
  explicit Sine(double omega) : twice(2.0 * cosineOf(4.0 * omega)) {
    for (int i = 0; i < 4; ++i) {
      before[i] = sineOf((i - 4) * omega);
      now[i] = sineOf(i * omega);
    }
  }
  void advance() {
    for (int i = 0; i < 4; ++i) {
      const double coming = twice * now[i] - before[i];
      before[i] = now[i];
      now[i] = coming;
    }
  }
  double twice, before[4], now[4];
};

/// Adds two sines a little apart, which are one that beats, under a slow envelope. That and the beat are straight for 4
/// ms at a time.
void addSwell(Samples& samples, float frequency, float amplitude, float late) {
  constexpr std::size_t kStraight = 64;
  constexpr double kApart = 0.0012, kTurn = 2.0 * 3.14159265358979;
  const double perSecond = kTurn * static_cast<double>(frequency);
  Sine sine(perSecond / static_cast<double>(kPadRate));
  float level = 0.0f;
  for (std::size_t begin = 0; begin + kStraight <= samples.size(); begin += kStraight) {
    const float seconds = static_cast<float>(begin + kStraight) / kPadRate;
    const double beat = cosineOf(kApart * perSecond * static_cast<double>(seconds));
    const float goal = 2.0f * amplitude * swell(seconds, late) * static_cast<float>(beat);
    const float slope = (goal - level) / static_cast<float>(kStraight);
    for (std::size_t i = 0; i < kStraight; i += 4, sine.advance())
      for (std::size_t k = 0; k < 4; ++k)
        samples[begin + i + k] += (level + slope * static_cast<float>(i + k)) * static_cast<float>(sine.now[k]);
    level = goal;
  }
}

/// Partials as of a bowed glass, each twice and a little apart, so that it moves; the higher ones open up and close
/// again.
Samples pad(float frequency) {
  Samples samples(samplesIn(kPadRise + kPadHold + kPadFall) / kPadStride, 0.0f);
  for (int harmonic = 1; harmonic <= 7; ++harmonic) {
    const auto h = static_cast<float>(harmonic);
    const float amplitude = 1.0f / (h * std::sqrt(h)) * (harmonic % 2 == 0 ? 0.8f : 1.0f);
    addSwell(samples, frequency * h, amplitude, 0.25f * (h - 1.0f));
  }
  return samples;
}

Samples bass(float frequency) {
  constexpr float stride = static_cast<float>(kBassStride);
  Samples samples(samplesIn(3.6f) / kBassStride, 0.0f);
  for (const Mode& mode :
       {Mode{frequency, 3.2f, 1.0f}, Mode{2.0f * frequency, 2.2f, 0.35f}, Mode{3.0f * frequency, 1.4f, 0.12f}})
    addMode(samples, 0, {mode.frequency * stride, mode.decay / stride, mode.amplitude});
  const std::size_t soft = samplesIn(0.06f) / kBassStride;
  for (std::size_t i = 0; i < soft; ++i) samples[i] *= smooth(static_cast<float>(i) / static_cast<float>(soft));
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

/// How an instrument's tones are made.
struct Plan {
  Samples (*play)(float);  // of a frequency [Hz]
  std::array<float, Instruments::kTones> notes;
  std::size_t count;   // of the notes
  std::size_t stride;  // of its samples
};

const Plan& planOf(Instrument instrument) {
  static constexpr Plan plans[] = {
      {pad, {51, 58, 65, 72}, 4, kPadStride}, {bass, {36, 43}, 2, kBassStride}, {mallet, {62, 72, 82}, 3, 1}};
  static_assert(std::size(plans) == static_cast<std::size_t>(Instrument::Count));
  return plans[static_cast<std::size_t>(instrument)];
}

/// Of its tones.
std::size_t nearest(const Plan& plan, float note) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < plan.count; ++i)
    if (std::fabs(plan.notes[i] - note) < std::fabs(plan.notes[best] - note)) best = i;
  return best;
}

}  // namespace

bool Instruments::isMade(Instrument instrument, float note) const {
  return clips_[static_cast<std::size_t>(instrument)][nearest(planOf(instrument), note)] != nullptr;
}

Instruments::Tone Instruments::tone(Instrument instrument, float note) {
  const Plan& plan = planOf(instrument);
  const std::size_t at = nearest(plan, note);
  std::unique_ptr<const Clip>& clip = clips_[static_cast<std::size_t>(instrument)][at];
  if (!clip) {
    BR_ZONE("make a tone");
    clip = std::make_unique<const Clip>(plan.play(pitchOf(plan.notes[at])));
  }
  const double higher = power(2.0, static_cast<double>(note - plan.notes[at]) / 12.0);
  return {clip.get(), static_cast<float>(higher) / static_cast<float>(plan.stride)};
}

std::size_t Instruments::bytes() const {
  std::size_t sum = 0;
  for (const auto& tones : clips_)
    for (const auto& clip : tones) sum += clip ? clip->bytes() : 0;
  return sum;
}

}  // namespace brittle::audio
