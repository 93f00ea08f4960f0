// game/sim/unread.h - what a level tells its scripts and none of them asks for: misspelt, most likely.
#pragma once

#include "game/sim/room_plan.h"

namespace brittle::sim {

/// Reports each parameter that the obstacle's script never asks for, with what it does ask for. Of a template's, which
/// may serve obstacles of other types, and of stones, for which editors note more than is shown here, only those that
/// look like one that is.
void reportUnread(Session& session, const ObstacleDef& obstacle);

/// Likewise each attribute of a room.
void reportUnread(Session& session, const RoomEntry& room);

}  // namespace brittle::sim
