// Who must be awake for joints to act, and joints after a shift of the origin.
#include "engine/physics/state.h"

namespace brittle::physics {
namespace {

bool isMoving(const Body* body) {
  if (!body || body->type == BodyType::Static) return false;
  if (body->isDynamic()) return body->awake && body->restTicks == 0;
  return body->velocity != Vec3::Zero() || body->angularVelocity != Vec3::Zero();
}

void wakeIfAsleep(Body* body) {
  if (body && body->isDynamic() && !body->awake) body->wake();
}

}  // namespace

void wakeByJoints(State& state) {
  state.joints.forEach([&](JointHandle, const Joint& joint) {
    const Shape* shapeA = state.shapes.find(joint.a);
    const Shape* shapeB = state.shapes.find(joint.b);
    if (!shapeA || (joint.b && !shapeB)) return;
    Body* a = state.bodies.find(shapeA->body);
    Body* b = shapeB ? state.bodies.find(shapeB->body) : nullptr;
    const bool turning = joint.motor && joint.motorSpeed != 0.0f;
    const bool wakesA = isMoving(b) || turning;
    const bool wakesB = isMoving(a) || turning;
    if (wakesA) wakeIfAsleep(a);
    if (wakesB) wakeIfAsleep(b);
  });
}

void shiftJoints(State& state, const Vec3& offset) {
  state.joints.forEach([&](JointHandle, Joint& joint) {
    if (!joint.b) joint.localAnchorB -= offset;
  });
}

}  // namespace brittle::physics
