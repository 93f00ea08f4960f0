#include "engine/physics/deactivation.h"

#include "engine/core/profile.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/edit.h"

namespace brittle::physics {
namespace {

constexpr float kRestSpeed = 0.05f;  // [m/s] of the farthest point; chosen by eye: below, motion is not seen
// How long it must be at rest, at 60 Hz. Measured: 400 shards thrown onto a plate then cost 1.4 times what 400 cost
// that fly, against 1.7 times with twice as long. What hangs is slow at the end of each swing as well, and takes
// longer.
constexpr std::uint32_t kStandingTicks = 15;
constexpr std::uint32_t kHangingTicks = 30;

float surfaceSpeed(const Body& body) {
  return body.velocity.norm() + body.angularVelocity.norm() * body.radius;
}

/// Whether a body moves enough to wake what it touches. A lift slower than rest still carries its load off.
bool isMoving(const Body& body) {
  return surfaceSpeed(body) > (body.isDynamic() ? kRestSpeed : 0.0f);
}

/// Standing: touches anything at all. Hanging: by a joint, or weightless.
enum class Support { None, Standing, Hanging };

bool touchesAnything(const State& state, const Body& body) {
  bool touches = false;
  forEachShape(state, body, [&](ShapeHandle, const Shape& shape) {
    forEachContact(state, shape, [&](std::uint32_t slot, std::uint32_t) {
      touches = touches || state.contacts.at(slot).touching;
      return !touches;
    });
  });
  return touches;
}

bool isJointed(const State& state, BodyHandle handle) {
  bool jointed = false;
  state.joints.forEach([&](JointHandle, const Joint& joint) {
    const Shape* a = state.shapes.find(joint.a);
    const Shape* b = state.shapes.find(joint.b);
    jointed = jointed || (a != nullptr && a->body == handle) || (b != nullptr && b->body == handle);
  });
  return jointed;
}

Support supportOf(const State& state, BodyHandle handle) {
  const Body& body = state.bodies[handle];
  if (touchesAnything(state, body)) return Support::Standing;
  const bool isWeightless = state.gravity.isZero() || body.gravityScale == 0.0f;
  return isWeightless || isJointed(state, handle) ? Support::Hanging : Support::None;
}

void putToRest(Body& body) {
  body.awake = false;
  body.velocity.setZero();
  body.angularVelocity.setZero();
}

/// If one of two that hold on to each other moves, the other one wakes.
void wakeByMotion(Body& a, Body& b) {
  if (a.awake == b.awake) return;
  const Body& mover = a.awake ? a : b;
  Body& sleeper = a.awake ? b : a;
  if (sleeper.isDynamic() && isMoving(mover)) sleeper.wake();
}

void wakeTouchedByMotion(State& state) {
  state.contacts.forEach([&](ContactHandle, const Contact& contact) {
    if (contact.touching) wakeByMotion(state.bodyOf(state.shapes[contact.a]), state.bodyOf(state.shapes[contact.b]));
  });
  state.joints.forEach([&](JointHandle, const Joint& joint) {
    const Shape* a = state.shapes.find(joint.a);
    const Shape* b = state.shapes.find(joint.b);
    if (a != nullptr && b != nullptr) wakeByMotion(state.bodyOf(*a), state.bodyOf(*b));
  });
}

}  // namespace

void wakeBody(State& state, BodyHandle handle) {
  Body* body = state.bodies.find(handle);
  if (body != nullptr && body->isDynamic()) body->wake();
}

void wakeTouching(State& state, ShapeHandle first) {
  std::vector<ShapeHandle>& pending = state.wakeQueue;
  pending.clear();
  pending.push_back(first);
  while (!pending.empty()) {
    const ShapeHandle handle = pending.back();
    pending.pop_back();
    forEachContact(state, state.shapes[handle], [&](std::uint32_t slot, std::uint32_t side) {
      const Contact& contact = state.contacts.at(slot);
      const ShapeHandle other = side == 0 ? contact.b : contact.a;
      Body& body = state.bodyOf(state.shapes[other]);
      if (!contact.touching || !body.isDynamic() || body.awake) return true;
      body.wake();
      // Within a tick: its inertia and tight boxes are from whenever it fell asleep, and a restored world has none of
      // them.
      refreshInertia(body);
      forEachShape(state, body, [&](ShapeHandle next, const Shape& shape) {
        state.shapeBoxes[next.index] = geometry::boundsOf(proxyOf(shape, state.meshes), body.pose);
        pending.push_back(next);
      });
      return true;
    });
  }
}

void deactivate(State& state, float dt) {
  BR_ZONE("deactivate");
  wakeTouchedByMotion(state);
  const float perTick = 1.0f / maxOf(dt * 60.0f, 0.01f);
  const auto standingTicks = static_cast<std::uint32_t>(static_cast<float>(kStandingTicks) * perTick);
  const auto hangingTicks = static_cast<std::uint32_t>(static_cast<float>(kHangingTicks) * perTick);
  state.bodies.forEach([&](BodyHandle handle, Body& body) {
    if (!body.isDynamic() || !body.awake) return;
    if (surfaceSpeed(body) > kRestSpeed) {
      body.restTicks = 0;
      return;
    }
    if (++body.restTicks < standingTicks) return;
    const Support support = supportOf(state, handle);
    const bool rests = support == Support::Standing || (support == Support::Hanging && body.restTicks >= hangingTicks);
    if (rests) putToRest(body);
  });
}

}  // namespace brittle::physics
