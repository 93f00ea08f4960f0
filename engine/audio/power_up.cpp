// What a player hears of power-ups: one is taken, one begins, one has run out.
#include "engine/audio/modes.h"
#include "engine/audio/noise.h"
#include "engine/audio/synthesis.h"
#include "engine/math/types.h"

namespace brittle::audio {
namespace {

/// A thin glass tube, struck.
void addTube(Samples& samples, float at, float note, float strength) {
  const float pitch = pitchOf(note);
  addMode(samples, samplesIn(at), {pitch, 0.55f, strength});
  addMode(samples, samplesIn(at), {2.76f * pitch, 0.22f, 0.3f * strength});
  addMode(samples, samplesIn(at), {5.4f * pitch, 0.08f, 0.15f * strength});
}

}  // namespace

Samples powerUpTaken() {
  Samples samples(samplesIn(1.0f), 0.0f);
  constexpr float kNotes[] = {79.0f, 84.0f, 86.0f, 91.0f};  // G5 C6 D6 G6: open, and at home among the crystals' notes
  float at = 0.0f;
  for (const float note : kNotes) {
    addTube(samples, at, note, 0.5f + 0.5f * at / 0.165f);
    at += 0.055f;
  }
  return samples;
}

Samples powerUpBegins(Random& random) {
  Samples samples(samplesIn(0.9f), 0.0f);
  addNoise(samples, {0, 0.45f, 0.25f, 0.35f, 500.0f, 3600.0f, 0.6f, 0.8f}, random);
  for (const float note : {60.0f, 67.0f, 72.0f, 76.0f}) addMode(samples, samplesIn(0.2f), {pitchOf(note), 0.7f, 0.22f});
  return samples;
}

Samples powerUpEnds(Random& random) {
  Samples samples(samplesIn(0.7f), 0.0f);
  addNoise(samples, {0, 0.4f, 0.02f, 0.4f, 2200.0f, 350.0f, 0.6f, 0.6f}, random);
  for (const float note : {67.0f, 60.0f}) addMode(samples, samplesIn(0.0f), {pitchOf(note), 0.5f, 0.25f});
  return samples;
}

}  // namespace brittle::audio
