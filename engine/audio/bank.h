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
  SplashDrip,  // from here on computed when first asked for; into water: by the size and speed of what falls in
  SplashSmall,
  SplashMedium,
  SplashLarge,
  LaserHum,  // to be overlapped by half: sounds on and on
  LaserHit,
  LaserDischarge,
  PowerUpTaken,
  PowerUpBegins,
  PowerUpEnds,
  BlastSmall,  // the module of explosions
  BlastMedium,
  BlastLarge,
  TimeSlows,  // the module of slow motion
  TimeReturns,
  Count
};

/// Whether only some rooms have it: computed when it is first asked for.
inline bool isLate(Sound sound) {
  return sound > Sound::Throw;
}

inline constexpr std::uint32_t kNotes = 12;
/// MIDI numbers of the notes: a pentatonic scale on C from C5 on, so that any two sound well together.
inline constexpr std::array<float, kNotes> kNoteNumbers = {72, 74, 76, 79, 81, 84, 86, 88, 91, 93, 96, 98};

const char* nameOf(Sound sound);

class Bank {
 public:
  /// Computes what every game has; takes about a fifth of a second. The same samples on every machine.
  Bank();
  std::uint32_t variations(Sound sound) const { return static_cast<std::uint32_t>(clipsOf(sound).size()); }
  /// `variation` counts on from the beginning when there are not so many. From the game's thread; the clip itself may
  /// be read by any.
  const Clip& clip(Sound sound, std::uint32_t variation) const {
    return clipsOf(sound)[variation % clipsOf(sound).size()];
  }
  /// Computes a late sound ahead of its time.
  void prepare(Sound sound) const { clipsOf(sound); }
  std::size_t bytes() const;

 private:
  using Clips = std::vector<Clip>;
  const Clips& clipsOf(Sound sound) const;
  mutable std::array<Clips, static_cast<std::size_t>(Sound::Count)> clips_;  // late ones: empty until asked for
};

}  // namespace brittle::audio
