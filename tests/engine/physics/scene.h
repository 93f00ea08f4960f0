// Builders that make a physics test a few lines: floors, boxes, balls, panes, and sums over a world.
#pragma once

#include "engine/geometry/make.h"
#include "engine/physics/world.h"

namespace brittle::physics {

inline constexpr float kTick = 1.0f / 60.0f;

inline ShapeDef shapeDef(float density = 1000.0f, float friction = 0.5f, float restitution = 0.0f) {
  ShapeDef def;
  def.surface.density = density;
  def.surface.friction = friction;
  def.surface.restitution = restitution;
  return def;
}

inline BodyDef bodyAt(const Vec3& position, BodyType type = BodyType::Dynamic) {
  BodyDef def;
  def.type = type;
  def.pose.position = position;
  return def;
}

inline BodyHandle addBox(World& world, BodyDef def, const Vec3& halfExtents, const ShapeDef& shape = shapeDef()) {
  const BodyHandle body = world.createBody(def);
  world.addConvex(body, shape, geometry::makeBox<float>(halfExtents).view());
  return body;
}

/// Nothing in it is ever put to rest.
inline WorldDef alwaysAwake() {
  WorldDef def;
  def.accuracy.deactivation = false;
  return def;
}

/// A static box whose top is at y = 0.
inline BodyHandle addFloor(World& world, float halfWidth = 20.0f) {
  return addBox(world, bodyAt(Vec3(0.0f, -0.5f, 0.0f), BodyType::Static), Vec3(halfWidth, 0.5f, halfWidth));
}

/// A ball of the given mass [kg], flying.
inline BodyHandle addBall(World& world, const Vec3& position, const Vec3& velocity, float radius, float mass,
                          float restitution = 0.0f) {
  BodyDef def = bodyAt(position);
  def.velocity = velocity;
  const BodyHandle body = world.createBody(def);
  const float volume = 4.0f / 3.0f * kPi * radius * radius * radius;
  world.addSphere(body, shapeDef(mass / volume, 0.5f, restitution), radius);
  return body;
}

/// A static pane in the XY plane, anchored everywhere at its rim by design of the test: it holds as a whole.
inline BodyHandle addPane(World& world, const Vec3& center, const Vec3& halfExtents, float strength,
                          float density = 2500.0f) {
  BodyDef def = bodyAt(center, BodyType::Static);
  def.breakable.strength = strength;
  ShapeDef shape = shapeDef(density);
  shape.anchored = true;
  return addBox(world, def, halfExtents, shape);
}

/// Sums over dynamic bodies.
struct Totals {
  Vec3d momentum = Vec3d::Zero();         // [kg m/s]
  Vec3d angularMomentum = Vec3d::Zero();  // about the origin
  double kineticEnergy = 0.0;             // [J]
  double mass = 0.0;
};

inline Totals totalsOf(const World& world) {
  Totals totals;
  world.forEachBody([&](BodyHandle, const Body& body) {
    if (!body.isDynamic()) return;
    const Vec3d v = body.velocity.cast<double>();
    const Mat3d rotation = body.pose.rotation.cast<double>().toRotationMatrix();
    const Mat3d inertia = rotation * body.localInertia.cast<double>() * rotation.transpose();
    const Vec3d w = body.angularVelocity.cast<double>();
    const Vec3d spin = inertia * w;
    totals.momentum += v * static_cast<double>(body.mass);
    totals.angularMomentum += body.center.cast<double>().cross(v) * static_cast<double>(body.mass) + spin;
    totals.kineticEnergy += 0.5 * static_cast<double>(body.mass) * v.squaredNorm() + 0.5 * w.dot(spin);
    totals.mass += static_cast<double>(body.mass);
  });
  return totals;
}

}  // namespace brittle::physics
