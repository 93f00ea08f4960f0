// audio/modes.h - modal synthesis: what is struck rings as a sum of decaying sines. The frequencies come from the shape
// and size of the thing, the decays from its material, and the strike's hardness says how far up they are excited.
// Source: Fletcher and Rossing, The Physics of Musical Instruments, 1998 (bars: chapter 2, plates: chapter 3).
#pragma once

#include <vector>

#include "engine/audio/clip.h"
#include "engine/core/random.h"

namespace brittle::audio {

struct Mode {
  float frequency = 0.0f;  // [Hz]
  float decay = 0.0f;      // time to fall by 60 dB [s]
  float amplitude = 0.0f;  // of the sine, at its start
};
using Modes = std::vector<Mode>;

/// Adds a sine that starts at zero at `start` and decays; it ends 80 dB down or with the samples. Nothing above 0.45 of
/// the sample rate.
void addMode(Samples& samples, std::size_t start, const Mode& mode);

struct Strike {
  std::size_t start = 0;  // [samples]
  float strength = 1.0f;
  float contact = 5e-5f;  // time of contact [s]: modes above about 1 / (2 contact) are hardly excited
};
void addStrike(Samples& samples, const Modes& modes, const Strike& strike);

/// The same thing falling, hopping and coming to rest: strikes that get weaker and follow closer and closer.
void addBounces(Samples& samples, const Modes& modes, Strike strike, float interval, float restitution, int count);

/// What a thing is made of, as far as it is heard.
struct Ring {
  float speed = 5500.0f;  // of bending: longitudinal waves in the material [m/s]; glass 5500, steel 5200
  float loss = 0.003f;    // share of energy lost per radian: decays take 2.2 / (loss frequency) [s]
  float longest = 1.0f;   // and no longer than this [s]
  float spread = 0.08f;   // irregularity: each frequency is off by up to this share
};

/// Bending modes of a free plate, about square. [m] Few modes of small plates are below 20 kHz.
Modes plateModes(float side, float thickness, const Ring& ring, Random& random);
/// Bending modes of a free bar whose lowest has this frequency. [Hz]
Modes barModes(float lowest, const Ring& ring, Random& random);

}  // namespace brittle::audio
