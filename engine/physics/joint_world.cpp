// World's part about joints: definitions checked, anchors brought into the frames of their bodies.
#include <cmath>

#include "engine/core/assert.h"
#include "engine/physics/joint_move.h"
#include "engine/physics/state.h"
#include "engine/physics/world.h"

namespace brittle::physics {

namespace {

bool isUnit(float squaredNorm) {
  return squaredNorm > 0.999f && squaredNorm < 1.001f;
}

/// The first rule a definition breaks, or null.
const char* findError(const State& state, const JointDef& def) {
  if (!state.shapes.contains(def.a)) return "JointDef::a is an existing shape";
  if (def.b && !state.shapes.contains(def.b)) return "JointDef::b is null or an existing shape";
  if (def.b && state.shapes[def.a].body == state.shapes[def.b].body) return "a joint connects two bodies";
  if (!isFinite(def.anchorA) || !isFinite(def.anchorB)) return "JointDef anchors are finite";
  if (!isFinite(def.axis) || !isUnit(def.axis.squaredNorm())) return "JointDef::axis is a unit vector";
  if (!isFinite(def.length)) return "JointDef::length is finite";
  if (!isFinite(def.lower) || !isFinite(def.upper) || def.lower > def.upper)
    return "JointDef limits are finite and in order";
  if (def.type == JointType::Hinge && def.limited && (def.lower < -kPi || def.upper > kPi))
    return "hinge limits are within -pi and pi";
  const bool hasCoordinate = def.type == JointType::Hinge || def.type == JointType::Slider;
  if ((def.limited || def.motor) && !hasCoordinate) return "only hinges and sliders have limits and motors";
  if (!isFinite(def.motorSpeed) || !isFinite(def.motorLimit) || def.motorLimit < 0.0f)
    return "JointDef motor speed is finite, its limit finite and not negative";
  return nullptr;
}

bool isRight(const char* error) {
  if (error) assertFailed(error, __FILE__, __LINE__);
  return !error;
}

/// Of the shapes of the body of `given`, the one that holds the anchor (ties: `given`, then list order), and how far it
/// is off.
ShapeHandle findHolder(const State& state, ShapeHandle given, const Vec3& anchorLocal, float& gap) {
  ShapeHandle holder = given;
  gap = anchorDistance(state, state.shapes[given], anchorLocal);
  for (ShapeHandle h = state.bodyOf(state.shapes[given]).firstShape; h && gap > 0.0f; h = state.shapes[h].next) {
    const float distance = anchorDistance(state, state.shapes[h], anchorLocal);
    if (distance < gap) {
      holder = h;
      gap = distance;
    }
  }
  return holder;
}

Joint makeJoint(const State& state, const JointDef& def) {
  Joint joint;
  const Transform poseA = state.bodyOf(state.shapes[def.a]).pose;
  const Transform poseB = def.b ? state.bodyOf(state.shapes[def.b]).pose : Transform{};
  const Vec3& anchorB = def.type == JointType::Rope ? def.anchorB : def.anchorA;
  joint.type = def.type;
  joint.localAnchorA = poseA.toLocal(def.anchorA);
  joint.localAnchorB = poseB.toLocal(anchorB);
  joint.localAxisA = poseA.unrotate(def.axis.normalized());
  joint.localAxisB = poseB.unrotate(def.axis.normalized());
  joint.referenceRotation = poseA.rotation.conjugate() * poseB.rotation;
  joint.length = def.length < 0.0f ? (def.anchorA - anchorB).norm() : def.length;
  joint.limited = def.limited;
  joint.lower = def.lower;
  joint.upper = def.upper;
  joint.motor = def.motor;
  joint.motorSpeed = def.motorSpeed;
  joint.motorLimit = def.motorLimit;
  joint.collideConnected = def.collideConnected;
  joint.a = findHolder(state, def.a, joint.localAnchorA, joint.gapA);
  if (def.b) joint.b = findHolder(state, def.b, joint.localAnchorB, joint.gapB);
  return joint;
}

void wakeBoth(World& world, const Joint& joint) {
  for (const ShapeHandle shape : {joint.a, joint.b})
    if (world.isAlive(shape)) world.wake(world.bodyOf(shape));
}

}  // namespace

JointHandle World::createJoint(const JointDef& def) {
  if (!isRight(findError(*state_, def))) return {};
  const JointHandle handle = state_->joints.insert(makeJoint(*state_, def));
  wakeBoth(*this, state_->joints[handle]);
  return handle;
}

void World::destroyJoint(JointHandle joint) {
  BR_ASSERT(state_->joints.contains(joint));
  if (!state_->joints.contains(joint)) return;
  wakeBoth(*this, state_->joints[joint]);
  state_->joints.erase(joint);
}

void World::setMotor(JointHandle handle, bool on, float speed, float limit) {
  Joint* joint = state_->joints.find(handle);
  BR_ASSERT(joint && (joint->type == JointType::Hinge || joint->type == JointType::Slider));
  BR_ASSERT(isFinite(speed) && isFinite(limit) && limit >= 0.0f);
  if (!joint || !isFinite(speed) || !isFinite(limit)) return;
  if (joint->motor == on && joint->motorSpeed == speed && joint->motorLimit == limit) return;
  joint->motor = on;
  joint->motorSpeed = speed;
  joint->motorLimit = limit;
  wakeBoth(*this, *joint);
}

bool World::isAlive(JointHandle joint) const {
  return state_->joints.contains(joint);
}

const Joint& World::joint(JointHandle handle) const {
  return state_->joints[handle];
}

}  // namespace brittle::physics
