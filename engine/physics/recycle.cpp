#include "engine/physics/recycle.h"

#include <algorithm>

#include "engine/core/profile.h"
#include "engine/physics/collide.h"
#include "engine/physics/contact_graph.h"
#include "engine/physics/debris_step.h"
#include "engine/physics/edit.h"

namespace brittle::physics {
namespace {

constexpr float kHitSpeed = 0.5f;  // slower touches make no sound [m/s]

bool isTouching(const Contact& contact, float slop) {
  for (int i = 0; i < contact.manifold.count; ++i)
    if (contact.manifold.points[i].separation <= slop || contact.manifold.points[i].normalImpulse > 0.0f) return true;
  return false;
}

void reportHit(State& state, const Contact& contact) {
  HitEvent hit;
  for (int i = 0; i < contact.manifold.count; ++i) {
    hit.speed = maxOf(hit.speed, contact.approach[i]);
    hit.impulse += contact.manifold.points[i].normalImpulse;
  }
  if (hit.speed < kHitSpeed || hit.impulse <= 0.0f) return;
  hit.a = state.shapes[contact.a].body;
  hit.b = state.shapes[contact.b].body;
  hit.normal = contact.manifold.normal;
  hit.point = state.bodies[hit.a].pose.toWorld(contact.manifold.points[0].localA);
  state.events.hits.push_back(hit);
}

/// What rested on something that slipped away, however slowly, would float.
void wakeAfterLoss(Body& body) {
  if (body.isDynamic() && !body.awake) body.wake();
}

}  // namespace

void finishContacts(State& state) {
  state.contacts.forEach([&](ContactHandle, Contact& contact) {
    if (contact.manifold.count == 0 && !contact.touching) return;
    const Shape& a = state.shapes[contact.a];
    const Shape& b = state.shapes[contact.b];
    if (!state.bodyOf(a).awake && !state.bodyOf(b).awake) return;
    const bool touching = isTouching(contact, contactSlop(a, b));
    if (touching && !contact.touching && !contact.fromCut) reportHit(state, contact);
    if (!touching && contact.touching) {
      wakeAfterLoss(state.bodyOf(a));
      wakeAfterLoss(state.bodyOf(b));
    }
    contact.touching = touching;
  });
}

void recycleBodies(State& state) {
  BR_ZONE("recycle");
  const auto limit = static_cast<std::size_t>(maxOf(state.accuracy.maxBodies, 0));
  if (state.bodies.size() <= limit) return;  // cheap and safe: pieces are some of the bodies
  std::vector<BodyHandle>& pieces = state.touchedBodies;
  pieces.clear();
  state.bodies.forEach([&](BodyHandle handle, const Body& body) {
    if (body.isPiece) pieces.push_back(handle);
  });
  if (pieces.size() <= limit) return;
  std::sort(pieces.begin(), pieces.end(), [&](BodyHandle a, BodyHandle b) {
    const Body& x = state.bodies[a];
    const Body& y = state.bodies[b];
    if (x.awake != y.awake) return !x.awake;
    return x.bornTick != y.bornTick ? x.bornTick < y.bornTick : a < b;
  });
  for (std::size_t i = 0; i + limit < pieces.size(); ++i) {
    const Body body = state.bodies[pieces[i]];
    const Shape& shape = state.shapes[body.firstShape];
    const std::uint32_t color = shape.isSphere() ? 0xffffffffu : state.meshes.view(shape.mesh).vertices[0].color;
    shed(state, body.center, body.velocity, body.mass / maxOf(shape.surface.density, 1e-6f), color);
    dropBody(state, pieces[i]);
    state.counters.omissions.add(Omission::RecycledBody);
  }
}

}  // namespace brittle::physics
