// audio/instruments.h - what music is played on: a slow pad, a soft bass, a mallet. Each tone is computed once at a few
// pitches and played at others by its rate. Made only when some room has music.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/audio/clip.h"

namespace brittle::audio {

enum class Instrument : std::uint8_t { Pad, Bass, Mallet, Count };

inline constexpr float kPadRise = 1.3f, kPadHold = 2.6f, kPadFall = 2.4f;  // [s]

class Instruments {
 public:
  Instruments();

  /// The clip made nearest to a note, and the pitch to play it at.
  struct Tone {
    const Clip* clip = nullptr;
    float pitch = 1.0f;
  };
  /// `note`: MIDI number; 69 is A4 = 440 Hz.
  Tone tone(Instrument instrument, float note) const;
  std::size_t bytes() const;

 private:
  struct Made {
    float note;
    Clip clip;
  };
  std::array<std::vector<Made>, static_cast<std::size_t>(Instrument::Count)> made_;
};

}  // namespace brittle::audio
