// audio/noise.h - noise with a shape: bursts of a crack, the hiss of something that slides or flies past.
#pragma once

#include "engine/audio/clip.h"
#include "engine/core/random.h"

namespace brittle::audio {

/// Band-passed noise that rises and decays. Frequencies glide from the first to the second over the burst.
struct NoiseBurst {
  std::size_t start = 0;               // [samples]
  float length = 0.1f;                 // [s]
  float attack = 0.001f;               // [s]
  float decay = 0.05f;                 // time to fall by 60 dB after the attack [s]
  float from = 3000.0f, to = 3000.0f;  // centre [Hz]
  float damping = 1.0f;                // bandwidth over centre frequency [-]
  float amplitude = 1.0f;
};
void addNoise(Samples& samples, const NoiseBurst& burst, Random& random);

}  // namespace brittle::audio
