// audio/bank.h - every sound there is, with its variations, rendered once at load. Who plays a sound picks the
// variation.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/audio/clip.h"

namespace brittle::audio {

enum class Sound : std::uint8_t {
  GlassSmall,  // breaks: below 0.25 m, below 0.5 m, larger (cube root of the volume)
  GlassMedium,
  GlassLarge,
  ShardRain,    // what comes down afterwards
  TinkleSmall,  // one shard lands
  TinkleMedium,
  TinkleLarge,
  OnStone,  // something heavy meets something that holds
  OnWall,
  OnMetal,
  OnWood,
  OnGlass,
  OnSteel,
  Note,  // variation: which of the kNotes, rising
  Missed,
  Door,
  Crash,
  Throw,
  PowerUpTaken,  // from here on: of power-ups, see SoundSet
  PowerUpBegins,
  PowerUpEnds,
  BlastSmall,  // the module of explosions
  BlastMedium,
  BlastLarge,
  TimeSlows,  // the module of slow motion
  TimeReturns,
  Count
};

/// Which sounds are computed.
enum class SoundSet : std::uint8_t { All, Common, PowerUps };

inline bool isOfPowerUps(Sound sound) {
  return sound >= Sound::PowerUpTaken;
}

inline constexpr std::uint32_t kNotes = 12;
/// MIDI numbers of the notes: a pentatonic scale on C from C5 on, so that any two sound well together.
inline constexpr std::array<float, kNotes> kNoteNumbers = {72, 74, 76, 79, 81, 84, 86, 88, 91, 93, 96, 98};

const char* nameOf(Sound sound);

class Bank {
 public:
  /// Computes them; all of them take about a quarter of a second. The same samples on every machine. Sounds of modules
  /// that are not compiled in have no variations.
  explicit Bank(SoundSet set = SoundSet::All);
  std::uint32_t variations(Sound sound) const { return static_cast<std::uint32_t>(clipsOf(sound).size()); }
  /// `variation` counts on from the beginning when there are not so many. Only of a sound that has any.
  const Clip& clip(Sound sound, std::uint32_t variation) const {
    return clipsOf(sound)[variation % clipsOf(sound).size()];
  }
  std::size_t bytes() const;

 private:
  const std::vector<Clip>& clipsOf(Sound sound) const { return clips_[static_cast<std::size_t>(sound)]; }
  std::array<std::vector<Clip>, static_cast<std::size_t>(Sound::Count)> clips_;
};

}  // namespace brittle::audio
