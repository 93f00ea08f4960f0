#include "engine/core/profile.h"
#include "engine/physics/obstacle.h"
#include "engine/physics/sweep.h"

namespace brittle::physics {
namespace {

constexpr float kDeepest = 0.5f;  // of the smaller inner radius [-]: at 2 the middles meet, and the far side is nearer

/// How deep the two were in one another when the tick began; negative: that far apart. [m]
float depthOf(const Contact& contact) {
  float depth = -3.0e38f;
  for (int i = 0; i < contact.manifold.count; ++i) depth = maxOf(depth, -contact.manifold.points[i].separation);
  return depth;
}

void setBack(State& state, const Pair& pair, Body& body) {
  const Body& obstacle = state.bodyOf(pair.other);
  float depth = kDeepest * pair.size();
  const float now = pair.separation(body.pose, obstacle.pose);
  if (now >= -depth) return;
  const Transform& before = state.placements[pair.shape.body.index].pose;
  const Transform& obstacleBefore = obstacle.awake ? state.placements[pair.other.body.index].pose : obstacle.pose;
  depth = maxOf(depth, -pair.separation(before, obstacleBefore));
  if (now >= -depth) return;
  geometry::SimplexCache cache;
  const geometry::Separation found = geometry::separation(pair.otherProxy, obstacle.pose, pair.proxy, body.pose, cache);
  const bool sameSide = found.normal.dot(pair.normal) > 0.0f;
  const float push = sameSide ? -depth - found.distance : -depth - now;
  if (push <= 0.0f) return;
  ++state.counters.confined;
  body.center += (sameSide ? found.normal : pair.normal) * push;
  body.placeByCenter();
}

/// Only where the two were close, or met, is it known on which side the body was.
void confine(State& state, BodyHandle handle, const Meeting& meeting) {
  const Contact& contact = state.contacts.at(meeting.contact);
  if (contact.manifold.count == 0 && !contact.met) return;
  const Pair pair = pairOf(state, meeting);
  const float depth = depthOf(pair.contact);
  if (!pair.contact.met) {
    if (depth < -pair.size()) return;
    const Way seen = wayOf(state, handle) - wayOf(state, pair.other.body);
    if (maxOf(depth, 0.0f) - seen.way.dot(pair.normal) + seen.turn <= kDeepest * pair.size()) return;
  }
  setBack(state, pair, state.bodies[handle]);
}

}  // namespace

void confineBodies(State& state) {
  BR_ZONE("confine");
  for (const Heavy& next : state.moveOrder) {
    for (const bool isImmovable : {false, true}) {  // what cannot move has the last word
      forEachMeeting(state, next.body, [&](const Meeting& meeting) {
        if (meeting.isImmovable == isImmovable) confine(state, next.body, meeting);
      });
    }
  }
}

}  // namespace brittle::physics
