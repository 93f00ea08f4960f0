// view/music.h - the music of a room, composed from its name: slow chords, a bass and a mallet, 16 bars at 120 beats a
// minute, as long as a room lasts. A function of name and tick, so it is in time with what obstacles do on the beat,
// and any tick can be asked for alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/audio/instruments.h"

namespace brittle::view {

inline constexpr std::int32_t kStepTicks = 15;      // an eighth note; beats are 30 ticks
inline constexpr std::int32_t kStepsPerChord = 16;  // two bars
inline constexpr std::int32_t kChords = 8;
inline constexpr std::int32_t kMusicTicks = kStepTicks * kStepsPerChord * kChords;  // then it begins again: 32 s

struct MusicNote {
  audio::Instrument instrument = audio::Instrument::Pad;
  float note = 60.0f;  // MIDI number
  float gain = 0.0f;
  float side = 0.0f;  // -1 left to 1 right
};

/// Whether a room with this name of music has any.
bool hasMusic(const std::string& name);

/// What begins at this tick of the room. All of it is in C major, as the notes that crystals ring: both go together.
std::vector<MusicNote> notesAt(const std::string& name, std::int32_t tick);

}  // namespace brittle::view
