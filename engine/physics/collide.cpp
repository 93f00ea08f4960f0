#include "engine/physics/collide.h"

#include "engine/core/profile.h"
#include "engine/effects/has/joints.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/deactivation.h"
#include "engine/physics/point_lanes.h"

namespace brittle::physics {
namespace {

constexpr float kFatMargin = 0.05f;  // boxes in the tree are larger by this [m], so that most bodies do not touch it
constexpr float kLoose = 4.0f;  // boxes larger by so many margins are from faster days: they have too many pairs [-]
constexpr float kSameNormal = 0.98f;  // cosine: 11 degrees [-]
constexpr float kMaxTurn = 0.2f;      // and as much within the tick [rad]
constexpr float kFatRatio = 0.125f;   // or by this part of the shape's extent, if that is less [-]

/// The box over the body's way of the tick.
Aabb sweptBox(const Aabb& box, const Body& body, float dt) {
  const Vec3 way = body.velocity * dt;
  Aabb swept = box;
  swept.include(Aabb{box.low + way, box.high + way});
  const float turn = minOf(body.angularVelocity.norm() * dt, 1.0f) * body.radius;
  return swept.grownBy(turn);
}

/// How much larger the box in the tree is. [m]
float fatOf(const Aabb& box) {
  const Vec3 extent = box.extent();
  return minOf(kFatMargin, kFatRatio * maxOf(extent.x(), maxOf(extent.y(), extent.z())));
}

/// Sees to it that the shape's box in the tree covers its way of the tick.
void cover(State& state, ShapeHandle handle, const Shape& shape, const Body& body, float dt) {
  const Aabb& box = state.shapeBoxes[handle.index];
  const Aabb swept = sweptBox(box, body, dt);
  const float fat = fatOf(box);
  const Aabb& known = state.tree.box(shape.proxy);
  if (known.contains(swept) && swept.grownBy(kLoose * fat).contains(known)) return;
  state.tree.move(shape.proxy, swept.grownBy(fat));
  state.movedShapes.push_back(handle);
}

void updateProxy(State& state, ShapeHandle handle, const Shape& shape, const Body& body, float dt) {
  state.shapeBoxes[handle.index] = geometry::boundsOf(proxyOf(shape, state.meshes), body.pose);
  cover(state, handle, shape, body, dt);
}

bool mayTouch(const State& state, const Shape& a, const Shape& b) {
  if (a.body == b.body || !mayCollide(a.surface, b.surface)) return false;
  const Body& bodyA = state.bodyOf(a);
  const Body& bodyB = state.bodyOf(b);
  if (!bodyA.isDynamic() && !bodyB.isDynamic()) return false;
  if constexpr (effects::kHasJoints)
    if (state.joints.size() > 0 && state.jointedBodies[a.body.index] && state.jointedBodies[b.body.index])
      return !jointForbidsCollision(state, a.body, b.body);
  return true;
}

/// Few bodies hang on joints: only pairs of those are looked up in the list of all joints.
void markJointedBodies(State& state) {
  if (state.joints.size() == 0) return;
  state.jointedBodies.assign(state.bodies.capacity(), false);
  state.joints.forEach([&](JointHandle, const Joint& joint) {
    for (const ShapeHandle handle : {joint.a, joint.b})
      if (const Shape* shape = state.shapes.find(handle)) state.jointedBodies[shape->body.index] = true;
  });
}

/// Marks what a shape has contacts with already: looked up for each pair, that would be a walk along its list each
/// time.
void markKnownPairs(State& state, const Shape& shape, ShapeHandle handle) {
  state.knownPairOf.resize(state.shapes.capacity());
  forEachContact(state, shape, [&](std::uint32_t slot, std::uint32_t side) {
    const Contact& contact = state.contacts.at(slot);
    state.knownPairOf[(side == 0 ? contact.b : contact.a).index] = handle;
    return true;
  });
}

void findPairs(State& state) {
  if (state.movedShapes.empty()) return;
  markJointedBodies(state);
  state.knownPairOf.clear();
  for (const ShapeHandle handle : state.movedShapes) {
    if (!state.shapes.contains(handle)) continue;  // made and removed again between ticks
    const Shape& shape = state.shapes[handle];
    markKnownPairs(state, shape, handle);
    state.tree.query(state.tree.box(shape.proxy), [&](std::uint32_t slot) {
      ++state.counters.pairsTested;
      const bool isKnown = slot == handle.index || state.knownPairOf[slot] == handle;
      if (isKnown || !mayTouch(state, shape, state.shapes.at(slot))) return true;
      return static_cast<bool>(addContact(state, handle, state.shapes.handleAt(slot)));  // full: no use to look on
    });
  }
  state.movedShapes.clear();
}

/// How far the two may come closer within the tick. [m]
float closingWay(const Body& a, const Body& b, float dt) {
  const Vec3 velocityA = a.awake ? a.velocity : Vec3(Vec3::Zero());
  const Vec3 velocityB = b.awake ? b.velocity : Vec3(Vec3::Zero());
  const float turnA = a.awake ? a.angularVelocity.norm() * a.radius : 0.0f;
  const float turnB = b.awake ? b.angularVelocity.norm() * b.radius : 0.0f;
  return ((velocityA - velocityB).norm() + turnA + turnB) * dt;
}

/// Closing speed at each point before the solver first stopped it: what restitution gives back. Within a tick it only
/// grows.
void rememberApproach(const Body& a, const Body& b, Contact& contact) {
  if (contact.manifold.count == 0) return;
  const Wide3<Float4> at = lanesOf(contact.manifold, a.pose, b.pose).middle();
  const Wide3<Float4> velocityA = splat(a.velocity) + cross(splat(a.angularVelocity), at - splat(a.center));
  const Wide3<Float4> velocityB = splat(b.velocity) + cross(splat(b.angularVelocity), at - splat(b.center));
  const Float4 speed = dot(splat(contact.manifold.normal), velocityA - velocityB);
  for (int i = 0; i < contact.manifold.count; ++i) contact.approach[i] = maxOf(contact.approach[i], speed[i]);
}

/// No point is near or closes its gap within the tick: a row for it would never push.
bool isOutOfReach(const Contact& contact, float near, float dt) {
  for (int i = 0; i < contact.manifold.count; ++i)
    if (contact.manifold.points[i].separation <= near + maxOf(contact.approach[i], 0.0f) * dt) return false;
  return true;
}

void updateContact(State& state, Contact& contact, float dt) {
  const Shape& a = state.shapes[contact.a];
  const Shape& b = state.shapes[contact.b];
  const Body& bodyA = state.bodyOf(a);
  const Body& bodyB = state.bodyOf(b);
  const float size = minOf(a.innerRadius, b.innerRadius);
  const float near = minOf(state.accuracy.speculativeMargin, size);
  const float margin = near + closingWay(bodyA, bodyB, dt);
  if (!currentBox(state, a, contact.a.index).grownBy(margin).overlaps(currentBox(state, b, contact.b.index))) {
    contact.manifold.count = 0;
    contact.manifold.computed = false;
    return;
  }
  updateManifold(proxyOf(a, state.meshes), bodyA.pose, a.innerRadius, proxyOf(b, state.meshes), bodyB.pose,
                 b.innerRadius, margin, state.accuracy.manifold, contact.manifold);
  rememberApproach(bodyA, bodyB, contact);
  if (isOutOfReach(contact, near, dt)) {
    contact.manifold.count = 0;
    contact.manifold.computed = false;
  }
}

/// Last tick's impulses start this tick's solve only where the pair stands about as it stood: between a heavy striker
/// and a shard that spins, they would throw the shard faster than the iterations can catch it.
void forgetIfTurned(const State& state, const Vec3& normalBefore, float dt, Contact& contact) {
  Manifold& manifold = contact.manifold;
  const Body& a = state.bodyOf(state.shapes[contact.a]);
  const Body& b = state.bodyOf(state.shapes[contact.b]);
  const float turn = (a.angularVelocity - b.angularVelocity).norm() * dt;
  if (turn < kMaxTurn && manifold.normal.dot(normalBefore) > kSameNormal) return;
  manifold.forgetImpulses();
}

/// Still near enough to stay a pair?
bool isNear(const State& state, const Contact& contact) {
  return state.tree.box(state.shapes[contact.a].proxy).overlaps(state.tree.box(state.shapes[contact.b].proxy));
}

void updateContactAt(State& state, ContactHandle handle, float dt) {
  Contact& contact = state.contacts[handle];
  if (isNear(state, contact))
    updateContact(state, contact, dt);
  else
    removeContact(state, handle);
}

}  // namespace

float contactSlop(const Shape& a, const Shape& b) {
  return clampTo(0.01f * minOf(a.innerRadius, b.innerRadius), 1e-5f, 0.0005f);
}

const Aabb& currentBox(const State& state, const Shape& shape, std::uint32_t slot) {
  return state.bodyOf(shape).awake ? state.shapeBoxes[slot] : state.tree.box(shape.proxy);
}

void insertProxy(State& state, ShapeHandle handle) {
  Shape& shape = state.shapes[handle];
  if (state.shapeBoxes.size() < state.shapes.capacity()) state.shapeBoxes.resize(state.shapes.capacity());
  const Aabb box = geometry::boundsOf(proxyOf(shape, state.meshes), state.bodyOf(shape).pose);
  state.shapeBoxes[handle.index] = box;
  shape.proxy = state.tree.insert(box.grownBy(fatOf(box)), handle.index);
}

void detectCollisions(State& state, float dt) {
  BR_ZONE("collide");
  state.movedShapes.swap(state.newShapes);  // made since the last tick: their pairs are not known yet
  state.newShapes.clear();
  state.shapeBoxes.resize(state.shapes.capacity());
  state.bodies.forEach([&](BodyHandle, const Body& body) {
    if (!body.awake) return;
    forEachShape(state, body, [&](ShapeHandle handle, Shape& shape) { updateProxy(state, handle, shape, body, dt); });
  });
  findPairs(state);
  for (std::uint32_t slot = 0; slot < state.contacts.capacity(); ++slot) {
    if (!state.contacts.isAlive(slot)) continue;
    Contact& contact = state.contacts.at(slot);
    contact.reached = false;
    contact.passable = false;
    contact.waits = false;
    contact.met = false;
    for (float& speed : contact.approach) speed = 0.0f;
    contact.strike = kNoStrike;
    contact.manifold.seeded = false;
    const bool awake = state.bodyOf(state.shapes[contact.a]).awake || state.bodyOf(state.shapes[contact.b]).awake;
    if (!awake) continue;
    const Vec3 normal = contact.manifold.normal;
    updateContactAt(state, state.contacts.handleAt(slot), dt);
    if (state.contacts.isAlive(slot)) forgetIfTurned(state, normal, dt, contact);
  }
}

void detectCollisionsOf(State& state, const std::vector<BodyHandle>& bodies, float dt) {
  BR_ZONE("collide again");
  state.movedShapes.swap(state.newShapes);
  state.newShapes.clear();
  state.shapeBoxes.resize(state.shapes.capacity());
  for (const BodyHandle handle : bodies) {
    const Body& body = state.bodies[handle];
    forEachShape(state, body, [&](ShapeHandle shape, Shape& value) { updateProxy(state, shape, value, body, dt); });
  }
  findPairs(state);
  const std::uint32_t search = ++state.searches;
  for (const BodyHandle handle : bodies) {
    forEachShape(state, state.bodies[handle], [&](ShapeHandle, Shape& shape) {
      forEachContact(state, shape, [&](std::uint32_t slot, std::uint32_t) {
        Contact& contact = state.contacts.at(slot);
        if (contact.manifold.seeded || contact.search == search)
          return true;  // known from the cut, or seen from the other body
        contact.search = search;
        updateContactAt(state, state.contacts.handleAt(slot), dt);
        return true;
      });
    });
  }
}

void findPairsOnTheWay(State& state, float dt) {
  state.bodies.forEach([&](BodyHandle, const Body& body) {
    if (!body.isDynamic() || !body.awake) return;
    forEachShape(state, body, [&](ShapeHandle handle, const Shape& shape) { cover(state, handle, shape, body, dt); });
  });
  findPairs(state);
}

}  // namespace brittle::physics
