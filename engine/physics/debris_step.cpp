#include "engine/physics/debris_step.h"

#include <algorithm>
#include <cmath>

#include "engine/core/profile.h"

namespace brittle::physics {
namespace {

constexpr float kBounce = 0.3f;           // part of the normal speed a crumb keeps [-]; by eye
constexpr float kSlide = 0.6f;            // part of the tangential speed it keeps at a bounce [-]; by eye
constexpr float kCrumbRestSpeed = 0.15f;  // [m/s]

/// The radius of a cube of that volume, edge / 2. [m]
float radiusOf(float volume) {
  // Halley's iteration for the cube root: no library call, the same bits everywhere.
  float root = 0.01f;
  for (int i = 0; i < 40; ++i) {
    const float cube = root * root * root;
    root = root * (cube + 2.0f * volume) / (2.0f * cube + volume);
  }
  return 0.5f * root;
}

/// The first static face on the way; crumbs see nothing else.
geometry::RayHit castAtStatics(const State& state, const Vec3& from, const Vec3& to) {
  geometry::RayHit nearest;
  state.tree.castRay(from, to, [&](std::uint32_t slot) {
    const Shape& shape = state.shapes.at(slot);
    const Body& body = state.bodyOf(shape);
    if (body.type != BodyType::Static) return 1.0f;
    const geometry::RayHit hit = geometry::castRay(proxyOf(shape, state.meshes), body.pose, from, to);
    if (hit.hit && hit.fraction < nearest.fraction) nearest = hit;
    return nearest.hit ? nearest.fraction : 1.0f;
  });
  return nearest;
}

void stepCrumb(const State& state, float dt, Crumb& crumb) {
  crumb.velocity += state.gravity * dt;
  const Vec3 way = crumb.velocity * dt;
  const Vec3 direction = normalizedOr(way, Vec3::UnitY());
  const geometry::RayHit hit = castAtStatics(state, crumb.position, crumb.position + way + direction * crumb.radius);
  if (!hit.hit) {
    crumb.position += way;
    return;
  }
  const float length = way.norm() + crumb.radius;
  crumb.position += direction * maxOf(hit.fraction * length - crumb.radius, 0.0f);
  const float along = crumb.velocity.dot(hit.normal);
  const Vec3 normalPart = hit.normal * along;
  crumb.velocity = (crumb.velocity - normalPart) * kSlide - normalPart * kBounce;
  crumb.resting = crumb.velocity.norm() < kCrumbRestSpeed && hit.normal.dot(state.gravity) < 0.0f;
}

}  // namespace

void addCrumb(State& state, const Vec3& position, const Vec3& velocity, float volume, std::uint32_t color) {
  Debris& debris = state.debris;
  const auto limit = static_cast<std::size_t>(maxOf(state.accuracy.maxDebris, 0));
  const Crumb crumb{position, velocity, radiusOf(volume), volume, color, state.tick, false};
  if (debris.crumbs.size() < limit) {
    debris.crumbs.push_back(crumb);
    return;
  }
  if (limit == 0) return noteRecycled(state, volume);
  debris.oldest = debris.oldest % static_cast<std::uint32_t>(limit);
  noteRecycled(state, debris.crumbs[debris.oldest].volume);
  debris.crumbs[debris.oldest] = crumb;
  debris.oldest = (debris.oldest + 1) % static_cast<std::uint32_t>(limit);
}

void removeCrumbs(State& state, const std::function<bool(const Crumb&)>& isGone) {
  Debris& debris = state.debris;
  const auto first = std::find_if(debris.crumbs.begin(), debris.crumbs.end(), isGone);
  if (first == debris.crumbs.end()) return;
  // In order of age, as in a ring that is not full yet.
  std::rotate(debris.crumbs.begin(), debris.crumbs.begin() + debris.oldest, debris.crumbs.end());
  debris.oldest = 0;
  std::erase_if(debris.crumbs, [&](const Crumb& crumb) {
    if (!isGone(crumb)) return false;
    debris.recycledVolume += crumb.volume;
    state.counters.omissions.add(Omission::RemovedCrumb);
    return true;
  });
}

void stepDebris(State& state, float dt) {
  if (state.debris.crumbs.empty()) return;
  BR_ZONE("debris");
  for (Crumb& crumb : state.debris.crumbs)
    if (!crumb.resting) stepCrumb(state, dt, crumb);
}

}  // namespace brittle::physics
