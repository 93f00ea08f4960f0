// brittle/try_rooms.h - the rooms of a checked folder's levels, tried as the game plays them, for what reading their
// files cannot find.
#pragma once

#include "engine/core/result.h"
#include "game/content/check.h"
#include "game/sim/dry_run.h"

namespace brittle::program {

/// In all playable levels of the report; problems name files as the report does, and none repeats what it says.
Result<sim::DryRun> tryRooms(const content::CheckReport& report);

}  // namespace brittle::program
