// physics/obstacle.h - who does not give way to whom within a tick, and how the two come together: what sweeping and
// confining look at.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics {

/// A body and an obstacle that it may meet.
struct Pair {
  Contact& contact;
  const Shape& shape;
  const Shape& other;
  geometry::Proxy proxy, otherProxy;
  Vec3 normal;  // away from the obstacle, on the side the body is on as the tick begins; zero: not known

  float size() const { return minOf(shape.innerRadius, other.innerRadius); }
  /// How far apart the two are along the normal, at these poses. [m]
  float separation(const Transform& pose, const Transform& otherPose) const;
};

/// How far a body goes, and how far its surface may turn beside that. [m]
struct Way {
  Vec3 way = Vec3::Zero();
  float turn = 0.0f;
};
inline Way operator+(const Way& a, const Way& b) {
  return {a.way + b.way, a.turn + b.turn};
}
/// As seen from something that goes the way `b` itself.
inline Way operator-(const Way& a, const Way& b) {
  return {a.way - b.way, a.turn + b.turn};
}

/// Finds the obstacles of every body among the contacts.
void gatherMeetings(State& state);
Pair pairOf(State& state, const Meeting& meeting);
/// The way a body has gone since its placement.
Way wayOf(const State& state, BodyHandle body);

/// Calls visit(meeting) for every obstacle that a body may meet.
template <class Visit>
void forEachMeeting(const State& state, BodyHandle body, Visit&& visit) {
  for (std::uint32_t i = state.firstMeeting[body.index]; i != kNoMeeting; i = state.meetings[i].next)
    visit(state.meetings[i]);
}

}  // namespace brittle::physics
