// state_hash/scene.h - ten seconds of a small world with everything in it: panes standing on the floor, one hanging
// from joints, blocks, balls, debris, a shift of the origin. What builds are compared by (tools/cross_hash) and hard
// case B33 plays.
#pragma once

#include <cstdint>

#include "engine/geometry/make.h"
#include "engine/physics/world.h"

namespace brittle::physics {

inline constexpr int kSceneTicks = 600;

class Scene {
 public:
  Scene() : world_(fewBodies()) {
    addBox(BodyType::Static, Vec3(0.0f, -0.5f, 0.0f), Vec3(10.0f, 0.5f, 10.0f), 0.0f);
    for (int i = 0; i < 3; ++i)
      world_.anchor(
          addPane(BodyType::Static, Vec3(0.1f * static_cast<float>(i), 0.75f, -1.5f * static_cast<float>(i))));
    hang(addPane(BodyType::Dynamic, Vec3(1.6f, 2.0f, -1.0f)));
    for (int row = 0; row < 3; ++row)
      for (int i = 0; i < 3; ++i)
        addBox(BodyType::Dynamic,
               Vec3(-2.0f + 0.42f * static_cast<float>(i), 0.2f + 0.4f * static_cast<float>(row), -2.0f),
               Vec3(0.2f, 0.2f, 0.2f), 40.0f);
  }

  void step(int tick) {
    if (tick % 60 == 20)
      throwBall(Vec3(0.3f * static_cast<float>(tick / 60 % 5) - 0.6f, 1.0f, 4.0f), Vec3(0.0f, 1.0f, -22.0f));
    if (tick % 120 == 50) throwBall(Vec3(1.5f, 1.8f, 4.0f), Vec3(0.2f, 0.5f, -14.0f));
    if (tick % 150 == 90) throwBall(Vec3(-1.8f, 0.8f, 4.0f), Vec3(0.0f, 0.0f, -18.0f));
    if (tick == 300) shift(Vec3(0.0f, 0.0f, -2.5f));
    world_.step(1.0f / 60.0f);
  }
  std::uint64_t hash() const { return world_.stateHash(); }

 private:
  /// So few that bodies are recycled, and that an emulated processor is done in minutes.
  static WorldDef fewBodies() {
    WorldDef def;
    def.accuracy.maxBodies = 300;
    return def;
  }

  BodyHandle addBox(BodyType type, const Vec3& center, const Vec3& halfExtents, float strength) {
    BodyDef body;
    body.type = type;
    body.pose.position = center;
    body.breakable.strength = strength;
    body.breakable.material.pattern = fracture::Pattern::Block;
    const BodyHandle handle = world_.createBody(body);
    ShapeDef shape;
    shape.surface.density = 600.0f;
    world_.addConvex(handle, shape, geometry::makeBox<float>(halfExtents));
    return handle;
  }

  BodyHandle addPane(BodyType type, const Vec3& center) {
    BodyDef body;
    body.type = type;
    body.pose.position = center;
    body.breakable.strength = 60.0f;
    const BodyHandle handle = world_.createBody(body);
    ShapeDef shape;
    shape.surface.density = 2500.0f;
    world_.addConvex(handle, shape, geometry::makeBox<float>(Vec3(0.75f, 0.75f, 0.02f)));
    return handle;
  }

  void hang(BodyHandle pane) {
    for (const float side : {-0.6f, 0.6f}) {
      JointDef joint;
      joint.type = side < 0.0f ? JointType::Ball : JointType::Rope;
      joint.a = world_.body(pane).firstShape;
      joint.anchorA = world_.body(pane).pose.position + Vec3(side, 0.7f, 0.0f);
      joint.anchorB = joint.anchorA + Vec3(0.0f, 0.5f, 0.0f);
      world_.createJoint(joint);
    }
  }

  void throwBall(const Vec3& from, const Vec3& velocity) {
    BodyDef body;
    body.pose.position = from - origin_;
    body.velocity = velocity;
    const BodyHandle handle = world_.createBody(body);
    ShapeDef shape;
    shape.surface.density = 7800.0f;
    shape.surface.restitution = 0.3f;
    world_.addSphere(handle, shape, 0.13f);
  }

  void shift(const Vec3& offset) {
    world_.shiftOrigin(offset);
    origin_ += offset;
  }

  World world_;
  Vec3 origin_ = Vec3::Zero();
};

}  // namespace brittle::physics
