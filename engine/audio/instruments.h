// audio/instruments.h - what music is played on: a slow pad, a soft bass, a mallet. Each has a few tones, computed when
// they are first asked for, and plays other pitches by their rate.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "engine/audio/clip.h"

namespace brittle::audio {

enum class Instrument : std::uint8_t { Pad, Bass, Mallet, Count };

inline constexpr float kPadRise = 1.3f, kPadHold = 2.6f, kPadFall = 2.4f;  // [s]

class Instruments {
 public:
  static constexpr std::size_t kTones = 4;  // that an instrument has at most

  /// Whether `tone` has nothing to compute. `note`: MIDI number; 69 is A4 = 440 Hz.
  bool isMade(Instrument instrument, float note) const;

  /// A clip, and the pitch to play it at. The clip stays where it is.
  struct Tone {
    const Clip* clip = nullptr;
    float pitch = 1.0f;
  };
  /// The one made nearest to a note; the first time it takes a millisecond or two. From the game's thread; the clip
  /// itself may be read by any.
  Tone tone(Instrument instrument, float note);
  std::size_t bytes() const;

 private:
  std::array<std::array<std::unique_ptr<const Clip>, kTones>, static_cast<std::size_t>(Instrument::Count)> clips_;
};

}  // namespace brittle::audio
