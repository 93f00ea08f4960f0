// game/sim/omission.h - what the rules put off, refuse or take away, beside what a room's world does
// (physics::Omission).
#pragma once

#include <cstdint>

#include "engine/core/tally.h"

namespace brittle::sim {

enum class Omission : std::uint8_t {
  BehindCamera,      // a body was passed and taken out
  Fallen,            // a body fell out of the room
  OutOfSight,        // a piece that nobody could see again was taken out
  DeferredObstacle,  // waits another tick to start: rules::kRoomInstructions
  IdleScript,        // did nothing in a tick: the same
  RemovedObstacle,   // rules::kMaxContactsPerRoom
  RefusedContent,    // things of a level, or of a script, that a room has no place for
  RefusedThrow,      // more in a tick than an input frame may hold
  RefusedSplash,     // rules::kMaxSplashes
  UntoldProblem,     // rules::kMaxProblems
  Count
};
const char* nameOf(Omission omission);

}  // namespace brittle::sim
