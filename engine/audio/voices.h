// audio/voices.h - the sounds that play now: a fixed number, mixed with their own gain, place, pitch and low-pass. When
// all are taken, the quietest gives way. Used by the mixer, inside the audio callback: nothing here allocates.
#pragma once

#include <array>
#include <cstdint>

#include "engine/audio/block.h"
#include "engine/audio/clip.h"
#include "engine/audio/filter.h"

namespace brittle::audio {

inline constexpr std::size_t kVoices = 64;

struct VoiceDef {
  const Clip* clip = nullptr;
  float left = 1.0f, right = 1.0f;  // gains [-]
  float send = 0.0f;                // share of it that the room hears [-]
  float pitch = 1.0f;               // 2: an octave up; from 1/16 to 16
  float cutoff = kHighestCutoff;    // of a low-pass [Hz]
  std::uint32_t delay = 0;          // until it begins [samples]
  float worth = 1.0f;               // times its loudness when voices are short: above 1 it is kept longer
};

class Voices {
 public:
  /// False if every voice is louder than this one will ever be.
  bool play(const VoiceDef& def);
  /// Adds one block to `dry` and, unless it is null, the room's share to `send`. `rate`: of all pitches, 1 as they are.
  void render(float rate, Block& dry, Block* send);
  void stop();
  std::uint32_t active() const;
  /// Sounds that were not played, and those that were ended, because every voice was taken: so far.
  std::uint32_t refused() const { return refused_; }
  std::uint32_t ended() const { return ended_; }

 private:
  struct Voice {
    VoiceDef def;
    std::uint64_t position = 0;  // [2^-32 samples]
    float step = 1.0f;           // of the low-pass
    OnePole lowPass;
    bool plays() const { return def.clip != nullptr; }
    /// The loudest it will still be, times its worth.
    float loudness() const;
    void render(std::uint64_t stride, Block& dry, Block* send);
  };
  std::array<Voice, kVoices> voices_;
  std::uint32_t refused_ = 0, ended_ = 0;
};

}  // namespace brittle::audio
