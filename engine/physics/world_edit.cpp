// Making, unmaking and changing: World's door, where definitions are checked.
#include "engine/effects/has/debris.h"
#include "engine/effects/has/fracture.h"
#include "engine/effects/has/joints.h"
#include "engine/geometry/split.h"
#include "engine/physics/anchor.h"
#include "engine/physics/breakage.h"
#include "engine/physics/collide.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/debris_step.h"
#include "engine/physics/deactivation.h"
#include "engine/physics/edit.h"
#include "engine/physics/world.h"

namespace brittle::physics {
namespace {

constexpr float kFarthest = 1e5f;  // [m] from the origin: beyond, single precision is no use

bool isPlace(const Vec3& v) {
  return isFinite(v) && v.cwiseAbs().maxCoeff() <= kFarthest;
}
bool isRotation(const Quat& q) {
  return isFinite(q) && q.norm() > 0.9f && q.norm() < 1.1f;
}

void checkSurface(const Surface& surface) {
  BR_ASSERT(isFinite(surface.density) && surface.density > 0.0f);
  BR_ASSERT(isFinite(surface.friction) && surface.friction >= 0.0f);
  BR_ASSERT(surface.restitution >= 0.0f && surface.restitution <= 1.0f);
}

Shape shapeFrom(const ShapeDef& def) {
  checkSurface(def.surface);
  Shape shape;
  shape.surface = def.surface;
  shape.anchored = def.anchored;
  shape.drawMaterial = def.drawMaterial;
  shape.drawFlags = def.drawFlags;
  shape.userData = def.userData;
  return shape;
}

}  // namespace

BodyHandle World::createBody(const BodyDef& def) {
  BR_ASSERT(isPlace(def.pose.position) && isRotation(def.pose.rotation));
  BR_ASSERT(isFinite(def.velocity) && isFinite(def.angularVelocity) && isFinite(def.gravityScale));
  BR_ASSERT(isFinite(def.breakable.strength) && def.breakable.strength >= 0.0f);
  Body body;
  body.type = def.type;
  body.awake = def.type == BodyType::Animated || (def.type == BodyType::Dynamic && def.awake);
  body.pose = {def.pose.position, def.pose.rotation.normalized()};
  body.center = body.pose.position;
  body.velocity = def.type == BodyType::Static ? Vec3(Vec3::Zero()) : def.velocity;
  body.angularVelocity = def.type == BodyType::Static ? Vec3(Vec3::Zero()) : def.angularVelocity;
  body.gravityScale = def.gravityScale;
  body.breakable = effects::kHasFracture && def.breakable.strength > 0.0f;
  body.breaking = def.breakable;
  body.assembly = def.assembly != 0 ? def.assembly : state_->nextAssembly++;
  body.userData = def.userData;
  body.bornTick = state_->tick - 1;
  body.seed = mixSeed(state_->seed, state_->nextSerial++);
  return makeBody(*state_, body);
}

ShapeHandle World::addConvex(BodyHandle body, const ShapeDef& def, const geometry::ConvexView& convex) {
  BR_ASSERT(geometry::findTopologyError(convex) == nullptr);
  State& state = *state_;
  const Vec3 velocity = state.bodies[body].velocity;
  const ShapeHandle handle = makeConvex(state, body, shapeFrom(def), convex, geometry::massOf(convex));
  updateMass(state, body);
  state.bodies[body].velocity = velocity;  // a definition's velocity is that of the finished body's centre
  return handle;
}

ShapeHandle World::addSphere(BodyHandle body, const ShapeDef& def, float radius, const Vec3& center) {
  BR_ASSERT(isFinite(radius) && radius > 0.0f && isPlace(center));
  State& state = *state_;
  const Vec3 velocity = state.bodies[body].velocity;
  Shape shape = shapeFrom(def);
  shape.radius = radius;
  shape.innerRadius = radius;
  shape.center = center;
  shape.massProperties = geometry::massOfSphere(radius, center);
  const ShapeHandle handle = makeSphere(state, body, shape);
  updateMass(state, body);
  state.bodies[body].velocity = velocity;
  return handle;
}

/// Before a shape goes: its joints go with it.
static void leaveJoints(State& state, ShapeHandle shape) {
  if constexpr (effects::kHasJoints) moveJoints(state, shape, nullptr, 0, 0.0f);
}

void World::removeShape(ShapeHandle shape) {
  const BodyHandle body = state_->shapes[shape].body;
  leaveJoints(*state_, shape);
  dropShape(*state_, shape);
  updateMass(*state_, body);
}

void World::destroyBody(BodyHandle body) {
  forEachShape(*state_, state_->bodies[body], [&](ShapeHandle shape, const Shape&) { leaveJoints(*state_, shape); });
  dropBody(*state_, body);
}

std::uint32_t World::anchor(BodyHandle body) {
  return findAnchors(*state_, body);
}

void World::animate(std::uint32_t assembly, const Transform& target) {
  BR_ASSERT(isPlace(target.position) && isRotation(target.rotation));
  state_->bodies.forEach([&](BodyHandle, Body& body) {
    if (body.assembly != assembly || body.type != BodyType::Animated) return;
    body.target = {target.position, target.rotation.normalized()};
    body.hasTarget = true;
  });
}

void World::setVelocity(BodyHandle handle, const Vec3& velocity, const Vec3& angularVelocity) {
  Body& body = state_->bodies[handle];
  if (body.type == BodyType::Static) return;
  body.velocity = velocity;
  body.angularVelocity = angularVelocity;
  wakeBody(*state_, handle);
}

void World::drag(BodyHandle handle, const Vec3& velocity, const Vec3& angularVelocity) {
  Body& body = state_->bodies[handle];
  BR_ASSERT(body.isDynamic() && body.awake && isFinite(velocity) && isFinite(angularVelocity));
  body.velocity = velocity;
  body.angularVelocity = angularVelocity;
}

void World::setPose(BodyHandle handle, const Transform& pose) {
  BR_ASSERT(isPlace(pose.position) && isRotation(pose.rotation));
  State& state = *state_;
  Body& body = state.bodies[handle];
  body.pose = {pose.position, pose.rotation.normalized()};
  body.placeByPose();
  refreshInertia(body);
  wakeBody(state, handle);
  forEachShape(state, body, [&](ShapeHandle shape, Shape& value) {
    removeContactsOf(state, shape);
    state.tree.remove(value.proxy);
    insertProxy(state, shape);
    state.newShapes.push_back(shape);
  });
}

void World::setBreakable(BodyHandle handle, const Breakable& breakable) {
  BR_ASSERT(isFinite(breakable.strength) && breakable.strength >= 0.0f);
  State& state = *state_;
  Body& body = state.bodies[handle];
  if (body.breaking.strength != breakable.strength) {
    // Who has spent a part of the old strength has spent the same part of the new one, or a load that rests on a body
    // that is made weaker would have paid already and pass; and what sleeps on it must find out.
    const float ratio = body.breaking.strength > 0.0f ? breakable.strength / body.breaking.strength : 0.0f;
    for (Budget& budget : state.budgets)
      if (budget.struck == handle) budget.spent *= ratio;
    wakeBody(state, handle);
    forEachShape(state, body, [&](ShapeHandle shape, const Shape&) { wakeTouching(state, shape); });
  }
  body.breaking = breakable;
  body.breakable = effects::kHasFracture && breakable.strength > 0.0f;
}

void World::setAccuracy(const Accuracy& accuracy) {
  BR_ASSERT(isWithinRange(accuracy));
  state_->accuracy = accuracy;
}

void World::applyImpulse(BodyHandle handle, const Vec3& impulse, const Vec3& point) {
  Body& body = state_->bodies[handle];
  if (!body.isDynamic()) return;
  wakeBody(*state_, handle);
  body.velocity += impulse * body.invMass;
  body.angularVelocity += body.invInertia * (point - body.center).cross(impulse);
}

void World::wake(BodyHandle body) {
  wakeBody(*state_, body);
}

void World::removeCrumbs(const std::function<bool(const Crumb&)>& isGone) {
  if constexpr (effects::kHasDebris) physics::removeCrumbs(*state_, isGone);
}

void World::breakBody(BodyHandle handle, const Vec3& point, const Vec3& direction, float speed, float radius) {
  const Body& body = state_->bodies[handle];
  const fracture::Impact impact{body.pose.toLocal(point), body.pose.unrotate(normalizedOr(direction, -Vec3::UnitZ())),
                                speed, radius};
  if constexpr (effects::kHasFracture) physics::breakBody(*state_, handle, &impact, 1, {});
}

}  // namespace brittle::physics
