// physics/body.h - a rigid body: a compound of convex shapes that move as one. Pieces of a broken body keep its local
// frame, so a body stores its centre of mass as an offset. The engine is shape-centric: who needs a body asks a shape
// for it.
#pragma once

#include <cstdint>

#include "engine/core/archive.h"
#include "engine/fracture/material.h"
#include "engine/math/transform.h"
#include "engine/physics/ids.h"

namespace brittle::physics {

enum class BodyType : std::uint8_t {
  Static,  // never moves; a breakable static body loses what is no longer anchored
  Dynamic,
  Animated,  // moves as it is told, pushes and is not pushed
};

/// What a breakable body is made of. strength is J: what it takes from one striker within 1/60 s before it breaks [N
/// s].
struct Breakable {
  float strength = 0.0f;  // [N s]; 0: unbreakable
  fracture::FractureMaterial material;
};

struct BodyDef {
  BodyType type = BodyType::Dynamic;
  Transform pose;
  Vec3 velocity = Vec3::Zero();         // of the centre of mass [m/s]
  Vec3 angularVelocity = Vec3::Zero();  // [rad/s]
  float gravityScale = 1.0f;            // [-]
  Breakable breakable;
  std::uint32_t assembly = 0;  // pieces inherit it: "all that became of this thing"; 0: a new number
  std::uint32_t userData = 0;  // the game's; pieces inherit it
  bool awake = true;
};

struct Body {
  BodyType type = BodyType::Static;
  bool awake = false;
  bool breakable = false;
  bool isPiece = false;                 // came off something that broke
  Transform pose;                       // of the local frame
  Vec3 localCenter = Vec3::Zero();      // centre of mass in the local frame [m]
  Vec3 center = Vec3::Zero();           // and in the world; pose.toWorld(localCenter) up to rounding
  Vec3 velocity = Vec3::Zero();         // of the centre [m/s]
  Vec3 angularVelocity = Vec3::Zero();  // [rad/s]
  float invMass = 0.0f;                 // [1/kg]; 0 unless Dynamic
  Mat3 localInertia = Mat3::Zero();     // about the centre, local axes [kg m2]
  Mat3 localInvInertia = Mat3::Zero();  // [1/(kg m2)]
  Mat3 invInertia = Mat3::Zero();       // world axes, refreshed every tick; zero unless Dynamic
  float mass = 0.0f;                    // [kg]; also of static bodies that may break
  float radius = 0.0f;                  // bounding radius about the centre [m]
  float innerRadius = 0.0f;             // half the thinnest extent of its thinnest shape [m]
  float gravityScale = 1.0f;
  ShapeHandle firstShape;  // list through Shape::next
  std::uint32_t shapeCount = 0;
  Breakable breaking;
  std::uint64_t seed = 0;  // of its next breaking
  std::uint32_t assembly = 0;
  std::uint32_t userData = 0;
  std::int32_t bornTick = 0;        // may be before the world's first tick
  std::uint32_t restTicks = 0;      // ticks it has been slow enough to be put to rest
  std::int32_t brokenTick = -1000;  // last tick it broke in: what is left does not break again in that tick
  BodyHandle striker;         // a piece: who broke it loose; what it passes on soon after counts in that one's budget
  float timeUsed = 0.0f;      // of this tick: already moved to where it struck [s]; 0 between ticks
  bool waitsAtGlass = false;  // this tick: what it struck breaks in the next one, it goes no further
  // Animated: where it goes this tick; velocities are derived from it.
  bool hasTarget = false;
  Transform target;

  bool isDynamic() const { return type == BodyType::Dynamic; }
  /// Velocity of the world point `point` of this body. [m/s]
  Vec3 velocityAt(const Vec3& point) const { return velocity + angularVelocity.cross(point - center); }
  void placeByCenter() { pose.position = center - pose.rotate(localCenter); }
  void placeByPose() { center = pose.toWorld(localCenter); }
  void wake() {
    awake = true;
    restTicks = 0;
  }

  template <class Archive>
  void serialize(Archive& a) {
    a(type);
    a(awake);
    a(breakable);
    a(isPiece);
    a(pose.position);
    a(pose.rotation);
    a(localCenter);
    a(center);
    a(velocity);
    a(angularVelocity);
    a(invMass);
    a(localInertia);
    a(localInvInertia);
    a(mass);
    a(radius);
    a(innerRadius);
    a(gravityScale);
    a(firstShape);
    a(shapeCount);
    a(breaking.strength);
    a(breaking.material.pattern);
    a(breaking.material.carveRadius);
    a(breaking.material.density);
    a(breaking.material.dieSize);
    a(breaking.material.minVolume);
    a(seed);
    a(assembly);
    a(userData);
    a(bornTick);
    a(brokenTick);
    a(striker);
    a(restTicks);
    a(hasTarget);
    a(target.position);
    a(target.rotation);
  }
};

}  // namespace brittle::physics
