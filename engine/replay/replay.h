// replay/replay.h - a game as data: where it started, what the player did in each tick, the state's hash after each
// tick, and snapshots to seek by. Does not know what a level, a setting or a snapshot holds: those bytes belong to who
// recorded them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/replay/input_frame.h"

namespace brittle::replay {

/// Four hours: a longer game is recorded no further, a longer file is refused [ticks].
inline constexpr std::uint32_t kMaxTicks = 4 * 60 * 60 * 60;

/// A longer snapshot is not recorded, and refused in a file [bytes]. Chosen: eleven times the largest of the shipped
/// replays, 1.5 MB.
inline constexpr std::size_t kLongestSnapshot = std::size_t{16} << 20;

/// What a game needs to start again in the same state.
struct Start {
  std::uint32_t simulationVersion = 0;  // raised by every change that changes results
  std::uint64_t contentHash = 0;        // of the files the game was loaded from
  std::uint64_t seed = 0;
  std::uint32_t mode = 0;               // the game's own numbering
  std::string level;                    // its name, as given on the command line
  std::vector<unsigned char> settings;  // accuracy and physical switches, as their owner serialises them
  friend bool operator==(const Start&, const Start&) = default;
};

/// The state after the first `tick` ticks, compressed; bytes as the simulation saved them.
struct Snapshot {
  std::uint32_t tick = 0;
  std::uint32_t size = 0;  // [bytes] before compression
  std::vector<unsigned char> block;
  friend bool operator==(const Snapshot&, const Snapshot&) = default;

  /// Nothing if the block is damaged.
  std::optional<std::vector<unsigned char>> bytes() const;
};

struct Replay {
  Start start;
  std::vector<InputFrame> frames;     // one per tick
  std::vector<std::uint64_t> hashes;  // the state after each tick; as many as frames
  std::vector<Snapshot> snapshots;    // in order of tick, each tick in [1, ticks()]
  friend bool operator==(const Replay&, const Replay&) = default;

  std::uint32_t ticks() const { return static_cast<std::uint32_t>(frames.size()); }
  /// The last snapshot at or before `tick`; null if the game has to start from its beginning.
  const Snapshot* snapshotBefore(std::uint32_t tick) const;
};

}  // namespace brittle::replay
