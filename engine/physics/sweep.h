// physics/sweep.h - continuous collision: bodies go to the end of the tick without passing through what does not give
// way to them, nor through what comes their way. Heavier bodies first, so that whatever stops a body is already where
// it will be.
#pragma once

#include <cstdint>

#include "engine/math/transform.h"
#include "engine/physics/ids.h"

namespace brittle::physics {

struct State;

/// Where a body was before it was moved to the end of the tick.
struct Placement {
  Transform pose;
  Vec3 center = Vec3::Zero();
  float time = 0.0f;  // within the tick [s]: a striker has been moved to its impact already
};

/// A body and something that does not give way to it.
struct Meeting {
  std::uint32_t contact = 0;  // slot
  bool isA = false;           // the body is contact.a's
  bool isImmovable = false;
  std::uint32_t next = 0;  // of the same body, or kNoMeeting
};
inline constexpr std::uint32_t kNoMeeting = 0xffffffff;

/// Bodies in the order in which they move: heavier first, a total order.
struct Heavy {
  float mass = 0.0f;
  BodyHandle body;
  friend bool operator<(const Heavy& a, const Heavy& b) { return a.mass != b.mass ? a.mass > b.mass : a.body < b.body; }
};

/// Once velocities are final: who may meet which obstacle, where all are, and in which order they move.
void beginSweeps(State& state);
/// Moves a dynamic body by its velocity to the end of the tick. Who is fast for its size, seen from an obstacle, stops
/// where it meets it and slides along it with what is left of the tick.
void sweepBody(State& state, BodyHandle body, float dt);
/// After all corrections: on the side it came from, no body is deeper in an obstacle than a part of the thinner one, or
/// than it was.
void confineBodies(State& state);

}  // namespace brittle::physics
