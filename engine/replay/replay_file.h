// replay/replay_file.h - replays as .brt files: magic, format version, simulation version, length, the replay,
// checksum. A file that is not exactly what was written is refused with one line; a replay of another version names
// both versions.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/replay/replay.h"

namespace brittle::replay {

/// Raised when the layout of the file changes.
inline constexpr std::uint32_t kFormatVersion = 1;

std::vector<unsigned char> encode(const Replay& replay);

/// `name` is used in the message. Refuses a replay whose simulation version is not `simulationVersion`.
Result<Replay> decode(std::span<const unsigned char> bytes, const std::string& name, std::uint32_t simulationVersion);

/// As core/file writes: never half a replay.
Status save(const Replay& replay, const std::string& path);
Result<Replay> load(const std::string& path, std::uint32_t simulationVersion);

}  // namespace brittle::replay
