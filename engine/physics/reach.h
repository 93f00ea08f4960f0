// physics/reach.h - what a pass of the solver takes in. The first pass of a tick solves every contact; a later one only
// those within a few contact steps of the bodies whose contacts a breaking or an advance has changed. The others keep
// the impulses they have. Knows no rows and no strikes.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/physics/ids.h"

namespace brittle::physics {

struct State;

struct Reach {
  std::vector<std::uint32_t> contacts;  // slots of those with points, ascending
  std::vector<std::uint8_t> isInside;   // by body slot: all its contacts are taken in
  std::vector<BodyHandle> front, next;  // scratch: bodies at one number of steps

  /// A contact is taken in if one of its bodies is inside.
  bool takesIn(BodyHandle a, BodyHandle b) const { return isInside[a.index] != 0 || isInside[b.index] != 0; }
};

/// Every contact that has points.
void reachAll(const State& state, Reach& reach);
/// Contacts within `steps` of `changed`, passing through what moves: contacts and joints lead on, a body that does not
/// move is an end.
void reachFrom(const State& state, const std::vector<BodyHandle>& changed, int steps, Reach& reach);

}  // namespace brittle::physics
