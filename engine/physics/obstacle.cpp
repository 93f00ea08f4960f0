#include "engine/physics/obstacle.h"

namespace brittle::physics {
namespace {

constexpr float kObstacleRatio = 5.0f;  // a body this many times as heavy does not give way [-]

bool isObstacle(const State& state, const Body& mover, const Body& other) {
  if (!mover.isDynamic() || !mover.awake) return false;
  if (!other.isDynamic() || !other.awake) return true;
  return state.tick != other.bornTick && other.mass > kObstacleRatio * mover.mass;
}

/// How far the proxy reaches from its pose's position. [m]
float reachAlong(const geometry::Proxy& proxy, const Transform& pose, const Vec3& direction) {
  const Vec3 local = pose.unrotate(direction);
  if (proxy.isSphere()) return local.dot(proxy.center) + proxy.radius;
  float along = -3.0e38f;
  for (const geometry::Vertex& vertex : proxy.convex.vertices) along = maxOf(along, local.dot(vertex.point));
  return along;
}

float turnOf(const Quat& from, const Quat& to) {
  return 2.0f * (to * from.conjugate()).vec().norm();
}

}  // namespace

float Pair::separation(const Transform& pose, const Transform& otherPose) const {
  // The two positions meet before anything is rounded: the same bits wherever the origin lies.
  const float apart = (pose.position - otherPose.position).dot(normal);
  return apart - reachAlong(proxy, pose, -normal) - reachAlong(otherProxy, otherPose, normal);
}

Pair pairOf(State& state, const Meeting& meeting) {
  Contact& contact = state.contacts.at(meeting.contact);
  const Shape& shape = state.shapes[meeting.isA ? contact.a : contact.b];
  const Shape& other = state.shapes[meeting.isA ? contact.b : contact.a];
  const Vec3 towardsB = contact.met                  ? contact.side
                        : contact.manifold.count > 0 ? contact.manifold.normal
                                                     : Vec3(Vec3::Zero());
  return {contact,
          shape,
          other,
          proxyOf(shape, state.meshes),
          proxyOf(other, state.meshes),
          meeting.isA ? Vec3(-towardsB) : towardsB};
}

void gatherMeetings(State& state) {
  state.meetings.clear();
  state.firstMeeting.assign(state.bodies.capacity(), kNoMeeting);
  state.contacts.forEach([&](ContactHandle handle, const Contact& contact) {
    if (contact.passable) return;
    const BodyHandle a = state.shapes[contact.a].body;
    const BodyHandle b = state.shapes[contact.b].body;
    const Body& bodyA = state.bodies[a];
    const Body& bodyB = state.bodies[b];
    const bool stopsA = isObstacle(state, bodyA, bodyB);
    if (!stopsA && !isObstacle(state, bodyB, bodyA)) return;
    std::uint32_t& first = state.firstMeeting[stopsA ? a.index : b.index];
    const Body& obstacle = stopsA ? bodyB : bodyA;
    state.meetings.push_back({handle.index, stopsA, !obstacle.isDynamic() || !obstacle.awake, first});
    first = static_cast<std::uint32_t>(state.meetings.size() - 1);
  });
}

Way wayOf(const State& state, BodyHandle handle) {
  const Body& body = state.bodies[handle];
  if (!body.awake) return {};
  const Placement& start = state.placements[handle.index];
  return {body.center - start.center, minOf(turnOf(start.pose.rotation, body.pose.rotation), 1.0f) * body.radius};
}

}  // namespace brittle::physics
