#include <algorithm>
#include <vector>

#include "engine/physics/state.h"
#include "engine/physics/world.h"

namespace brittle::physics {

namespace {

constexpr float kLongestTick = 1.0f / 20.0f;  // [s]
constexpr float kPushed = 0.05f;              // the most that pushing overlaps apart moves a body in a tick [m]

/// How far a shape may be outside of its box in the tree [m]. The tree is brought up to date when a tick begins; after
/// it bodies have moved with the velocities they have now.
float staleness(const State& state) {
  float stale = 0.0f;
  state.bodies.forEach([&](BodyHandle, const Body& body) {
    if (!body.awake) return;
    stale = maxOf(stale, (body.velocity.norm() + body.angularVelocity.norm() * body.radius) * kLongestTick + kPushed);
  });
  return stale;
}

/// Calls visit for the shapes of `mask` for which `touches` holds and whose boxes are near, in slot order.
template <class Touches>
void forEachNear(const State& state, const Aabb& box, std::uint32_t mask, const std::function<bool(ShapeHandle)>& visit,
                 Touches&& touches) {
  std::vector<ShapeHandle> found;  // the visitor may query again or change the world
  state.tree.query(box.grownBy(staleness(state)), [&](std::uint32_t slot) {
    const Shape& shape = state.shapes.at(slot);
    if ((shape.surface.category & mask) != 0 && touches(proxyOf(shape, state.meshes), state.bodyOf(shape).pose))
      found.push_back(state.shapes.handleAt(slot));
    return true;
  });
  std::sort(found.begin(), found.end(), [](ShapeHandle a, ShapeHandle b) { return a.index < b.index; });
  for (const ShapeHandle shape : found)
    if (state.shapes.contains(shape) && !visit(shape)) return;
}

/// Keeps the nearer hit; of equals the lower slot, whatever the order of the tree.
void keepNearer(RayResult& best, const RayResult& hit) {
  if (hit.fraction < best.fraction || !best.hit ||
      (hit.fraction == best.fraction && hit.shape.index < best.shape.index))
    best = hit;
}

/// The tree may only stop looking beyond the best hit, not at it: an equal one of a lower slot counts.
float cutOff(const RayResult& best) {
  return best.hit ? minOf(1.0f, best.fraction * 1.00001f + 1e-6f) : 1.0f;
}

}  // namespace

RayResult World::castRay(const Vec3& from, const Vec3& to, std::uint32_t mask) const {
  RayResult best;
  const State& s = *state_;
  const auto test = [&](std::uint32_t slot) {
    const Shape& shape = s.shapes.at(slot);
    if ((shape.surface.category & mask) == 0) return 1.0f;
    const geometry::RayHit hit = geometry::castRay(proxyOf(shape, s.meshes), s.bodyOf(shape).pose, from, to);
    if (hit.hit)
      keepNearer(best, {true, s.shapes.handleAt(slot), from + (to - from) * hit.fraction, hit.normal, hit.fraction});
    return cutOff(best);
  };
  s.tree.castRay(from, to, test, staleness(s));
  return best;
}

RayResult World::castSphere(const Vec3& from, const Vec3& to, float radius, std::uint32_t mask) const {
  if (radius <= 0.0f) return castRay(from, to, mask);
  RayResult best;
  const State& s = *state_;
  const geometry::Proxy ball{{}, Vec3::Zero(), radius};
  const geometry::Motion motion{{from, Quat::Identity()}, from, to - from, Vec3::Zero()};
  const float length = (to - from).norm();
  const float target = 1e-3f * minOf(radius, maxOf(length, 1e-3f));
  const auto test = [&](std::uint32_t slot) {
    const Shape& shape = s.shapes.at(slot);
    if ((shape.surface.category & mask) == 0) return 1.0f;
    const Transform& pose = s.bodyOf(shape).pose;
    const geometry::Motion still{pose, pose.position, Vec3::Zero(), Vec3::Zero()};
    const geometry::Impact impact = geometry::timeOfImpact(ball, motion, proxyOf(shape, s.meshes), still, 1.0f, target);
    if (impact.hit) keepNearer(best, {true, s.shapes.handleAt(slot), impact.point, -impact.normal, impact.time});
    return cutOff(best);
  };
  s.tree.castRay(from, to, test, radius + target + staleness(s));
  return best;
}

void World::overlapSphere(const Vec3& center, float radius, std::uint32_t mask,
                          const std::function<bool(ShapeHandle)>& visit) const {
  const geometry::Proxy ball{{}, Vec3::Zero(), radius};
  const Transform pose{center, Quat::Identity()};
  const Aabb box{center - Vec3::Constant(radius), center + Vec3::Constant(radius)};
  forEachNear(*state_, box, mask, visit, [&](const geometry::Proxy& proxy, const Transform& other) {
    return geometry::overlaps(ball, pose, proxy, other, 0.0f);
  });
}

void World::overlapBox(const Aabb& box, std::uint32_t mask, const std::function<bool(ShapeHandle)>& visit) const {
  // Distances need only the corners, so a box is a convex without faces here.
  geometry::Vertex corners[8];
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 3; ++k) corners[i].point[k] = (i >> k & 1) != 0 ? box.high[k] : box.low[k];
  const geometry::Proxy proxy{{corners, {}, {}}, Vec3::Zero(), 0.0f};
  forEachNear(*state_, box, mask, visit, [&](const geometry::Proxy& other, const Transform& pose) {
    return geometry::overlaps(proxy, Transform{}, other, pose, 0.0f);
  });
}

}  // namespace brittle::physics
