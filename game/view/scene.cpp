#include "game/view/scene.h"

#include <cmath>
#include <utility>

#include "engine/effects/has/air.h"
#include "engine/effects/has/bloom.h"
#include "engine/effects/has/decals.h"
#include "engine/effects/has/lasers.h"
#include "engine/effects/has/shadows.h"
#include "engine/effects/has/smoke.h"
#include "engine/effects/has/splinters.h"
#include "engine/effects/has/water.h"
#include "game/view/air.h"
#include "game/view/decals.h"
#include "game/view/hud.h"
#include "game/view/interpolate.h"
#include "game/view/lamps.h"
#include "game/view/lasers.h"
#include "game/view/look.h"
#include "game/view/particles.h"
#include "game/view/power_ups.h"
#include "game/view/shadows.h"
#include "game/view/smoke.h"
#include "game/view/surroundings.h"
#include "game/view/water.h"

namespace brittle::view {
namespace {

constexpr float kFogBlendTicks = 60.0f;  // from one room's fog to the next one's
constexpr float kRopeRadius = 0.012f;    // [m]
constexpr float kRopeAngle = 0.0022f;    // and at least this much of its distance
constexpr float kMostShake = 0.06f;      // [m], and as much in radians of roll
constexpr float kBloom = 0.55f;
constexpr float kCrashShake = 0.7f;  // of the most, at the moment of a crash

using effects::Effect;

float smooth(float t) {
  return t * t * (3.0f - 2.0f * t);
}

render::Fog mix(const render::Fog& a, const render::Fog& b, float t) {
  render::Fog fog = b;
  fog.bottom = a.bottom + (b.bottom - a.bottom) * t;
  fog.top = a.top + (b.top - a.top) * t;
  return fog;
}

/// Irregular, smooth, in about [-1, 1]; `t` in ticks.
float wobble(float t, float phase) {
  return 0.6f * std::sin(t * 0.83f + phase) + 0.4f * std::sin(t * 1.57f + 2.3f * phase);
}

/// Far ropes are drawn wider and fainter instead: thinner than a pixel they would break into dashes.
render::Beam ropeOf(const sim::RopeView& rope, const render::Camera& camera) {
  const float distance = (0.5f * (rope.from + rope.to) - camera.position).norm();
  const float radius = maxOf(kRopeRadius, distance * kRopeAngle);
  return {rope.from, rope.to, radius, render::packRgba(render::Rgb(0.75f, 0.85f, 0.90f), 0.45f * kRopeRadius / radius)};
}

}  // namespace

Scene::Scene(render::Renderer& renderer, const content::AssetSource* assets)
    : statics_(renderer, assets), materials_(materials()) {
  renderer.setMaterials(materials_);
}

void Scene::tick(const sim::FramePacket& packet) {
  std::swap(before_, now_);
  now_ = packet;
  memory_.tick(packet);
}

void Scene::reset() {
  memory_.clear();
  statics_.clear();
  before_ = now_ = {};
  ++resets_;
}

double Scene::timeAt(float alpha) const {
  return now_.time - static_cast<double>((1.0f - alpha) * now_.timeShare);
}

void Scene::placeCamera(double tick, float aspect) {
  const sim::Camera& from = seen_.camera;
  render::Camera& camera = frame_.camera;
  camera.position = from.position;
  camera.rotation = from.rotation;
  if (from.halfWidthTangent > 0.0f) camera.tanHalfWidth = from.halfWidthTangentIn(aspect);
  if (from.near > 0.0f) camera.nearPlane = from.near;
  if (from.far > camera.nearPlane) camera.farPlane = from.far;
  const float pain = clampTo(seen_.hud.pain, 0.0f, 1.0f);
  const float shake = clampTo(seen_.shake + kCrashShake * pain * pain, 0.0f, 1.0f) * kMostShake;
  if (shake <= 0.0f) return;
  const auto t = static_cast<float>(std::fmod(tick, 36000.0));
  camera.position += camera.rotation * Vec3(shake * wobble(t, 0.0f), shake * wobble(t, 1.7f), 0.0f);
  camera.rotation = camera.rotation * rotationAbout(Vec3::UnitZ(), shake * 0.5f * wobble(t, 4.1f));
}

void Scene::addRooms(const MeshPools& pools) {
  const float farthest = minOf(frame_.fog.end, frame_.camera.farPlane) + kMostShake;
  statics_.show(seen_.rooms, frame_.camera.position.z(), farthest, frame_.statics);
  addLamps();
  for (std::size_t i = 0; i < seen_.rooms.size() && i < render::kMaxGroups; ++i) {
    const sim::RoomView& room = seen_.rooms[i];
    render::MeshGroup& group = frame_.groups[i];
    group.pool = room.slot < pools.size() ? pools[room.slot] : nullptr;
    group.poolId = (resets_ << 32) + room.number + 1;
    if (group.pool == nullptr) continue;
    for (const sim::BodyPose& body : room.bodies) group.bodies.push_back(body.pose);
    if (!room.pickups.empty()) turnPickups(room, timeAt(alpha_), group.bodies);
    for (geometry::MeshSlot slot = 0; slot < group.pool->slotCount(); ++slot) {
      const geometry::MeshInfo& info = group.pool->info(slot);
      // The room's own boxes are seen as baked meshes.
      if (!info.alive || info.material == static_cast<std::uint16_t>(sim::Look::Static)) continue;
      if (info.bodySlot >= room.bodies.size() || room.bodies[info.bodySlot].generation == 0) continue;
      group.meshes.push_back({slot, info.bodySlot, info.material, render::kWhite});
    }
    if constexpr (effects::kHasShadows)
      if (room.effects.has(Effect::Shadows)) addShadows(group, materials_, frame_.sphereShadow, frame_.shadows);
  }
}

/// Lamps shine beyond their outline, in the air about them and in the whole picture.
void Scene::addLamps() {
  if constexpr (effects::kHasBloom) {
    if (!hasLamps(seen_)) return;
    for (const sim::RoomView& room : seen_.rooms) {
      if (!room.effects.has(Effect::Bloom)) continue;
      frame_.bloom = kBloom;
      for (const sim::PlacedSegment& segment : room.segments) addHalos(*segment.look, segment.origin, frame_.glows);
    }
  }
}

/// What scripts light, for a tick.
void Scene::addGlows(double tick) {
  constexpr float radius = 0.35f;  // [m]
  for (const Remembered& r : memory_.events()) {
    const double age = tick - static_cast<double>(r.tick) + 0.5;
    if (r.event.type != sim::EventType::Glow || age < 0.0 || age >= 1.0) continue;
    frame_.glows.push_back({r.pointIn(seen_.originZ), radius, render::packRgba(render::Rgb(1.0f, 0.93f, 0.78f), 0.7f)});
  }
}

/// Of the room that the camera is in; it comes in as its fog does.
void Scene::placeFocus(float entered) {
  if (seen_.rooms.empty() || !seen_.rooms.front().effects.has(Effect::DepthOfField)) return;
  const float* focus = seen_.rooms.front().focus;
  frame_.focus = {focus[0], focus[1], focus[2] * entered};
}

void Scene::addThings() {
  for (const sim::RoomView& room : seen_.rooms) {
    for (const sim::CrumbView& crumb : room.crumbs)
      frame_.crumbs.push_back({crumb.position, crumb.radius, crumb.color});
    for (const sim::RopeView& line : room.ropes) frame_.beams.push_back(ropeOf(line, frame_.camera));
  }
  const auto material = static_cast<std::uint16_t>(sim::Look::Ball);
  for (const sim::BallView& ball : seen_.balls)
    frame_.spheres.push_back({ball.pose.position, ball.radius, ball.pose.rotation, material, tintOf(ball)});
}

std::vector<NamedCount> Scene::omissions() const {
  Tally<Omission> all = bounds_.omissions;
  all.add(Omission::BakedMesh, statics_.dropped());
  std::vector<NamedCount> counts;
  all.list(counts);
  return counts;
}

const render::Frame& Scene::build(float alpha, float aspect, const MeshPools& pools, bool paused,
                                  const Timings* timings) {
  alpha_ = clampTo(alpha, 0.0f, 1.0f);
  interpolate(before_, now_, alpha, seen_);
  const double tick = static_cast<double>(now_.tick) - 1.0 + static_cast<double>(clampTo(alpha, 0.0f, 1.0f));
  frame_.clear();
  bounds_.budget = seenBudget(now_.maxDebris);
  placeCamera(tick, aspect);
  const float entered = memory_.ageOf(sim::EventType::RoomEntered, tick) / kFogBlendTicks;
  frame_.fog = mix(memory_.fogBefore(), fogOf(seen_), smooth(clampTo(entered, 0.0f, 1.0f)));
  if (!seen_.runs(Effect::Fog)) frame_.fog.start = frame_.fog.end = 2.0f * frame_.camera.farPlane;
  placeFocus(smooth(clampTo(entered, 0.0f, 1.0f)));
  frame_.surroundings = surroundingsOf(seen_, bounds_);
  frame_.sphereShadow = seen_.runs(Effect::Shadows) ? shadowStrengthOf(seen_) : 0.0f;
  if (seen_.runs(Effect::Mirror)) frame_.mirrorHeight = mirrorHeightOf(seen_);
  addRooms(pools);
  addThings();
  if constexpr (effects::kHasDecals)
    if (seen_.runs(Effect::Decals)) addDecals(seen_, memory_, tick, frame_);
  if constexpr (effects::kHasAir)
    if (seen_.runs(Effect::Air)) addAir(seen_, tick, frame_);
  if constexpr (effects::kHasWater)
    if (seen_.runs(Effect::Water)) addWaters(seen_, memory_, tick, bounds_, frame_);
  if constexpr (effects::kHasLasers)
    if (seen_.runs(Effect::Lasers)) addLasers(seen_, tick, frame_);
  if constexpr (effects::kHasSplinters)
    if (seen_.runs(Effect::Splinters)) addParticles(seen_, memory_, tick, timeAt(alpha_), bounds_, frame_);
  if constexpr (effects::kHasSmoke)
    if (seen_.runs(Effect::Smoke)) addSmoke(seen_, memory_, tick, bounds_, frame_);
  addGlows(tick);
  addPowerUps(seen_, timeAt(alpha_), frame_);
  keepWithin(frame_, bounds_);
  addHud(seen_, memory_, tick, aspect, frame_, paused);
  if (timings != nullptr) {
    addTimings(*timings, frame_);
    addRunning(seen_, frame_);
    std::vector<NamedCount> counts = seen_.omissions;
    addUp(counts, omissions());
    addUp(counts, timings->heard);
    addOmissions(counts, frame_);
  }
  return frame_;
}

}  // namespace brittle::view
