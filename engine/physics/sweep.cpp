#include "engine/physics/sweep.h"

#include <algorithm>

#include "engine/physics/collide.h"
#include "engine/physics/obstacle.h"

namespace brittle::physics {
namespace {

constexpr float kFastRatio = 0.5f;   // of its inner radius: who moves further, seen from an obstacle, is swept [-]
constexpr int kMaxSlides = 6;        // surfaces a fast body may slide along within a tick
constexpr float kSweepDepth = 0.1f;  // of the smaller inner radius: a way that ends no deeper needs no sweep [-]

void moveBody(Body& body, float time) {
  body.center += body.velocity * time;
  body.pose.rotation = integrateRotation(body.pose.rotation, body.angularVelocity, time);
  body.placeByCenter();
}

/// How a body that has been moved already went from `time` on to the end of the tick.
geometry::Motion motionFrom(const State& state, BodyHandle handle, float time, float dt) {
  const Body& body = state.bodies[handle];
  const Placement& start = state.placements[handle.index];
  const float duration = dt - start.time;
  if (!body.awake || duration <= 0.0f) return {body.pose, body.center, Vec3::Zero(), Vec3::Zero()};
  geometry::Motion motion{start.pose, start.center, (body.center - start.center) / duration,
                          rotationBetween(start.pose.rotation, body.pose.rotation) / duration};
  const float gone = maxOf(time - start.time, 0.0f);
  motion.pose = geometry::poseAt(motion, gone);
  motion.center += motion.velocity * gone;
  return motion;
}

Way wayAhead(const Body& body, float time) {
  return {body.velocity * time, minOf(body.angularVelocity.norm() * time, 1.0f) * body.radius};
}

/// Whether a body could get through an obstacle within the tick.
bool isFast(const State& state, BodyHandle handle, float time) {
  const Body& body = state.bodies[handle];
  const Way ahead = wayAhead(body, time);
  bool fast = false;
  forEachMeeting(state, handle, [&](const Meeting& meeting) {
    const Contact& contact = state.contacts.at(meeting.contact);
    const Way seen = ahead - wayOf(state, state.shapes[meeting.isA ? contact.b : contact.a].body);
    fast = fast || seen.way.norm() + seen.turn > kFastRatio * body.innerRadius;
  });
  return fast;
}

/// Whether the boxes of the two meet on the way.
bool mayMeet(const State& state, const Meeting& meeting, const Pair& pair, const Way& ahead) {
  const ShapeHandle shape = meeting.isA ? pair.contact.a : pair.contact.b;
  const ShapeHandle other = meeting.isA ? pair.contact.b : pair.contact.a;
  const Way seen = ahead - wayOf(state, pair.other.body);
  Aabb swept = state.shapeBoxes[shape.index];
  swept.include(Aabb{swept.low + seen.way, swept.high + seen.way});
  return swept.grownBy(seen.turn).overlaps(currentBox(state, pair.other, other.index));
}

struct Stop {
  bool hit = false;
  float time = 0.0f;
  Vec3 normal = Vec3::UnitY();  // away from the obstacle
  Vec3 obstacleVelocity = Vec3::Zero();
  const Meeting* meeting = nullptr;
};

/// Whether a way ends, as it begins, on the near side of the obstacle: then it does not lead through.
bool staysOutside(const State& state, const Pair& pair, const Transform& begin, const Transform& end,
                  const Transform& otherBegin) {
  const float allowed = -kSweepDepth * pair.size();
  return pair.separation(end, state.bodyOf(pair.other).pose) >= allowed &&
         pair.separation(begin, otherBegin) >= allowed;
}

Stop firstObstacle(State& state, BodyHandle handle, const Body& body, float from, float dt) {
  Stop stop;
  stop.time = dt - from;
  const geometry::Motion motion{body.pose, body.center, body.velocity, body.angularVelocity};
  const Transform end = geometry::poseAt(motion, dt - from);
  const Way ahead = wayOf(state, handle) + wayAhead(body, dt - from);
  forEachMeeting(state, handle, [&](const Meeting& meeting) {
    const Pair pair = pairOf(state, meeting);
    const geometry::Motion other = motionFrom(state, pair.other.body, from, dt);
    if (pair.normal.isZero() ? !mayMeet(state, meeting, pair, ahead)
                             : staysOutside(state, pair, body.pose, end, other.pose))
      return;
    ++state.counters.sweeps;
    const geometry::Impact impact = geometry::timeOfImpact(pair.proxy, motion, pair.otherProxy, other, dt - from,
                                                           contactSlop(pair.shape, pair.other));
    // A pair that touches already is the solver's: stopped at time 0 it would stay where it is while its velocity
    // grows.
    if (!impact.hit || impact.time <= 0.0f || impact.time >= stop.time) return;
    stop = {true, impact.time, Vec3(-impact.normal),
            other.velocity + other.angularVelocity.cross(impact.point - other.center), &meeting};
  });
  return stop;
}

/// Moves to the first obstacle, then along it with what is left of the time. Velocity is left alone: the next tick's
/// contact deals with it.
void moveSwept(State& state, BodyHandle handle, Body& body, float from, float dt) {
  const Vec3 velocity = body.velocity;
  const Vec3 spin = body.angularVelocity;
  for (int i = 0; i < kMaxSlides && from < dt; ++i) {
    const Stop stop = firstObstacle(state, handle, body, from, dt);
    moveBody(body, stop.time);
    if (!stop.hit) break;
    from += stop.time;
    Contact& contact = state.contacts.at(stop.meeting->contact);
    contact.met = true;
    contact.side = stop.meeting->isA ? Vec3(-stop.normal) : stop.normal;
    body.velocity -= stop.normal * minOf((body.velocity - stop.obstacleVelocity).dot(stop.normal), 0.0f);
    body.angularVelocity.setZero();
  }
  body.velocity = velocity;
  body.angularVelocity = spin;
}

}  // namespace

void beginSweeps(State& state) {
  gatherMeetings(state);
  state.placements.resize(state.bodies.capacity());
  state.moveOrder.clear();
  state.bodies.forEach([&](BodyHandle handle, const Body& body) {
    if (!body.awake) return;
    state.placements[handle.index] = {body.pose, body.center, body.timeUsed};
    if (body.isDynamic()) state.moveOrder.push_back({body.mass, handle});
  });
  std::sort(state.moveOrder.begin(), state.moveOrder.end());
}

void sweepBody(State& state, BodyHandle handle, float dt) {
  Body& body = state.bodies[handle];
  const float from = body.timeUsed;
  body.timeUsed = 0.0f;
  if (from >= dt) return;
  if (isFast(state, handle, dt - from)) {
    ++state.counters.swept;
    moveSwept(state, handle, body, from, dt);
  } else {
    moveBody(body, dt - from);
  }
}

}  // namespace brittle::physics
