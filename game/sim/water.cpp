#include "game/sim/water.h"

#include <cmath>

#include "engine/core/profile.h"
#include "engine/math/trig.h"
#include "game/sim/ball.h"
#include "game/sim/constants.h"
#include "game/sim/room.h"

namespace brittle::sim {
namespace {

constexpr float kBeside = 1.0f;  // what may come over the water within a tick, from beside it [m]

/// Whether a place is over or under the surface, or within `margin` [m] of that.
bool isOver(const PlannedWater& water, float shift, const Vec3& place, float margin) {
  const Vec3 d = place - water.center - Vec3(0.0f, 0.0f, shift);
  return std::fabs(d.x()) <= water.halfExtents.x() + margin && std::fabs(d.z()) <= water.halfExtents.y() + margin;
}

float volumeOf(const physics::World& world, const physics::Body& body) {
  float volume = 0.0f;
  for (physics::ShapeHandle s = body.firstShape; s; s = world.shape(s).next)
    volume += world.shape(s).massProperties.volume;
  return volume;
}

bool isBall(const physics::Body& body) {
  return (body.userData & kBallBit) != 0;
}

}  // namespace

float sunkShare(float height, float radius) {
  const float depth = clampTo(0.5f - 0.5f * height / maxOf(radius, 1e-6f), 0.0f, 1.0f);
  return depth * depth * (3.0f - 2.0f * depth);  // a cap's share of its ball
}

void Waters::find(const physics::World& world, std::span<const PlannedWater> waters, float shift) {
  swimmers_.clear();
  world.forEachBody([&](physics::BodyHandle handle, const physics::Body& body) {
    if (!body.isDynamic() || !body.awake) return;
    for (const PlannedWater& water : waters) {
      if (!isOver(water, shift, body.center, kBeside)) continue;
      const double volume = static_cast<double>(maxOf(volumeOf(world, body), 1e-9f));
      const auto size = static_cast<float>(power(volume, 1.0 / 3.0));
      const float radius = 0.62035049f * size;  // (3 / (4 pi))^(1/3)
      swimmers_.push_back({handle, radius, size, body.center.y() - radius, body.velocity});
      return;
    }
  });
}

void Waters::slow(physics::World& world, const Swimmer& swimmer, float share, float gravity, float seconds) const {
  const physics::Body& body = world.body(swimmer.body);
  const bool ball = isBall(body);
  const float volume = swimmer.size * swimmer.size * swimmer.size;
  const float pushedAside = (ball ? rules::kWaterDensity : rules::kFormatWaterDensity) * share;  // [kg/m3]
  const float area = kPi * swimmer.radius * swimmer.radius;
  const float lift = rules::kGravity * gravity * pushedAside * volume * body.invMass;
  const float c = 0.5f * pushedAside * (ball ? rules::kBallDrag : rules::kBodyDrag) * area * body.invMass;
  Vec3 velocity = body.velocity + Vec3(0.0f, lift * seconds, 0.0f);
  velocity /= 1.0f + c * velocity.norm() * seconds;
  const Vec3 spin = body.angularVelocity / (1.0f + rules::kWaterSpin * share * seconds);
  world.drag(swimmer.body, velocity, spin);
}

void Waters::slow(physics::World& world, std::span<const PlannedWater> waters, float shift, float gravity,
                  float seconds) {
  BR_ZONE("water");
  find(world, waters, shift);
  for (const Swimmer& swimmer : swimmers_) {
    const Vec3 center = world.body(swimmer.body).center;
    float share = 0.0f;
    for (const PlannedWater& water : waters)
      if (isOver(water, shift, center, 0.0f))
        share = maxOf(share, sunkShare(center.y() - water.center.y(), swimmer.radius));
    if (share > 0.0f) slow(world, swimmer, share, gravity, seconds);
  }
}

std::span<const Waters::Entry> Waters::entries(const physics::World& world, std::span<const PlannedWater> waters,
                                               float shift) {
  entries_.clear();
  refused_ = 0;
  for (const Swimmer& swimmer : swimmers_) {
    if (!world.isAlive(swimmer.body) || swimmer.velocity.y() > -rules::kSplashSpeed) continue;
    const Vec3 center = world.body(swimmer.body).center;
    for (const PlannedWater& water : waters) {
      const float surface = water.center.y();
      const bool fellIn = swimmer.lowest >= surface && center.y() - swimmer.radius < surface;
      if (!fellIn || !isOver(water, shift, center, 0.0f)) continue;
      if (entries_.size() == rules::kMaxSplashes) {
        ++refused_;
        break;
      }
      entries_.push_back({swimmer.body, Vec3(center.x(), surface, center.z()), swimmer.velocity, swimmer.size});
      break;
    }
  }
  return entries_;
}

void Room::readSplashes() {
  for (const Waters::Entry& entry : waters_.entries(*world_, plan_.waters, shift_)) {
    const Party party = partyOf(entry.body);
    Event event;
    event.type = EventType::Splash;
    event.look = party.look;
    event.point = entry.point;
    event.direction = entry.velocity;
    event.speed = entry.velocity.norm();
    event.size = entry.size;
    event.value = party.isBall ? 1 : 0;
    emit(event);
  }
  session_.omissions.add(Omission::RefusedSplash, waters_.refused());
}

}  // namespace brittle::sim
