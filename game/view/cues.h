// view/cues.h - which sound stands for which event. Knows no mixer: a list of cues is all that comes out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/audio/bank.h"
#include "engine/audio/placement.h"
#include "engine/core/random.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

/// One sound to be heard.
struct Cue {
  audio::Sound sound = audio::Sound::OnStone;
  audio::Placement placement;  // in the middle: a signal to the player, wherever it happened
  float gain = 1.0f;           // at the ear
  float pitch = 1.0f;
  float delay = 0.0f;           // [s]
  std::int32_t variation = -1;  // -1: any
};

/// What was heard just now covers what is quieter: a pane's shards touch the floor a hundred times a second, and all of
/// them would be one hiss. Of equally loud hits about one per tick is left.
struct Masking {
  float level = 0.0f;
  std::uint64_t quiet = 0, covered = 0;  // sounds left out so far: beyond the loudest of a tick, and by the level
};

/// What the tick's events sound like. `streakBefore`: crystals in a row before this tick.
std::vector<Cue> cuesOf(const sim::FramePacket& packet, std::int32_t streakBefore, Masking& masking, Random& random);

/// What a script's sound file stands for, by the words in its name; nothing if none is known.
std::optional<audio::Sound> soundNamed(const std::string& path);

}  // namespace brittle::view
