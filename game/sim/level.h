// game/sim/level.h - the rooms of a level, as the track walks through them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/sim/room_plan.h"

namespace brittle::sim {

/// levels/NAME.xml: at least one room, or an error. Smaller faults are reported to the session.
Result<std::vector<RoomEntry>> loadLevel(Session& session, const std::string& name);

/// Reads every file the rooms will need, so that what is wrong with them is known, and the content's hash complete,
/// before the first tick.
void readAhead(Session& session, const std::vector<RoomEntry>& entries);

/// The seed of the `number`-th room of a game: of its own, unless the level file says which (attribute `seed`). In
/// training always the same.
std::uint64_t roomSeed(const Session& session, const RoomEntry& entry, std::uint64_t number);

}  // namespace brittle::sim
