// audio/filter.h - the filters everything here is made with. Sources: Zavalishin, The Art of VA Filter Design, 2012
// (chapter 4) for the state variable filter; the one-pole is the textbook's.
#pragma once

#include "engine/audio/clip.h"
#include "engine/math/trig.h"
#include "engine/math/types.h"

namespace brittle::audio {

inline constexpr float kHighestCutoff = 20000.0f;  // a filter asked for more leaves everything through [Hz]

/// How much of the way to its input a one-pole low-pass goes per sample: 1 from kHighestCutoff on, where it changes
/// nothing.
inline float onePoleStep(float cutoff) {
  if (!(cutoff < kHighestCutoff)) return 1.0f;
  return 1.0f - exponential(-2.0f * kPi * maxOf(cutoff, 1.0f) / static_cast<float>(kSampleRate));
}

/// What a level's low-pass amount of 0 (open) to 1 (shut) means: 20 kHz, falling by a decade per half. [Hz]
inline float cutoffOf(float amount) {
  if (!(amount > 0.0f)) return kHighestCutoff;
  return kHighestCutoff * exponential(-4.6051702f * minOf(amount, 1.0f));  // ln 100
}

struct OnePole {
  float state = 0.0f;
  float low(float in, float step) {
    state = step < 1.0f ? state + step * (in - state) : in;
    return state;
  }
};

/// Two poles, low- and band-pass at once; its cutoff may move from sample to sample. The band's peak is as high as the
/// input.
class StateVariable {
 public:
  struct Out {
    float low, band;
  };
  /// `damping`: 1.41 is flattest, smaller is narrower.
  void tune(float cutoff, float damping) {
    const float g = tangent(kPi * clampTo(cutoff, 10.0f, 0.45f * static_cast<float>(kSampleRate)) /
                            static_cast<float>(kSampleRate));
    damping_ = damping;
    a1_ = 1.0f / (1.0f + g * (g + damping));
    a2_ = g * a1_;
    a3_ = g * a2_;
  }
  Out process(float in) {
    const float v3 = in - low_;
    const float v1 = a1_ * band_ + a2_ * v3;
    const float v2 = low_ + a2_ * band_ + a3_ * v3;
    band_ = 2.0f * v1 - band_;
    low_ = 2.0f * v2 - low_;
    return {v2, damping_ * v1};
  }
  /// Forgets what is too quiet to hear, so that silence behind it becomes exactly silent and no denormal numbers
  /// linger.
  void settle() {
    if (low_ < 1e-9f && low_ > -1e-9f && band_ < 1e-9f && band_ > -1e-9f) low_ = band_ = 0.0f;
  }
  bool isSilent() const { return low_ == 0.0f && band_ == 0.0f; }

 private:
  float damping_ = 1.41f, a1_ = 1.0f, a2_ = 0.0f, a3_ = 0.0f;
  float low_ = 0.0f, band_ = 0.0f;
};

}  // namespace brittle::audio
