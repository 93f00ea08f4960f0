// What a room makes of balls that explode, and of their blasts. The module of Effect::Explosions.
#include "engine/physics/explosion.h"

#include <algorithm>

#include "game/sim/room.h"

namespace brittle::sim {

namespace {

physics::ExplosionDef blastOf(Charge charge, const Vec3& center) {
  const rules::BlastRule& rule = charge == Charge::Barrel ? rules::kBarrelBlast : rules::kNitroBlast;
  physics::ExplosionDef def;
  def.center = center;
  def.breakReach = rule.breakReach;
  def.pushReach = rule.pushReach;
  def.pressure = rule.pressure;
  def.mostSpeed = rule.mostSpeed;
  def.breakSpeed = rule.breakSpeed;
  return def;
}

}  // namespace

/// A charged ball goes off where it first broke or met something: what it broke it may have passed by now.
void Room::explodeBalls() {
  const bool isAny =
      std::any_of(balls_.begin(), balls_.end(), [](const Ball& b) { return b.charge() != Charge::None; });
  if (!isAny) return;
  const physics::Events events = world_->events();  // a blast adds none, but what it touches is read by handle
  for (const physics::BreakEvent& broken : events.breaks) touch(broken.striker, broken.point, -broken.normal);
  for (const physics::HitEvent& hit : events.hits)
    for (const physics::BodyHandle body : {hit.a, hit.b}) {
      if (!world_->isAlive(body)) continue;
      const Vec3 outward = normalizedOr(world_->body(body).center - hit.point, Vec3::UnitZ());
      touch(body, hit.point, outward);
    }
}

void Room::touch(physics::BodyHandle body, const Vec3& point, const Vec3& back) {
  const auto ball = std::find_if(balls_.begin(), balls_.end(), [body](const Ball& b) { return b.body == body; });
  if (ball == balls_.end() || ball->charge() == Charge::None || !world_->isAlive(body)) return;
  const Charge charge = ball->charge();
  balls_.erase(ball);
  world_->destroyBody(body);
  const rules::BlastRule& rule = charge == Charge::Barrel ? rules::kBarrelBlast : rules::kNitroBlast;
  explode(centerOfBlast(point, back, rule.standOff), charge);
}

/// Before what was touched, the way the ball came, as far as that is free.
Vec3 Room::centerOfBlast(const Vec3& touched, const Vec3& back, float standOff) const {
  const Vec3 near = touched + back * (0.5f * rules::kBallRadius), far = touched + back * standOff;
  const physics::RayResult ray = world_->castRay(near, far);
  return ray.hit ? Vec3(near + (far - near) * (0.9f * ray.fraction)) : far;
}

void Room::explode(const Vec3& center, Charge charge) {
  const rules::BlastRule& rule = charge == Charge::Barrel ? rules::kBarrelBlast : rules::kNitroBlast;
  const physics::Explosion done = physics::explode(*world_, blastOf(charge, center));
  Event event;
  event.type = EventType::Explosion;
  event.point = center;
  event.size = rule.pushReach;
  event.impulse = done.impulse;
  event.value = static_cast<std::int32_t>(done.breaks.size());
  emit(event);
  ++session_.explosions;
  for (const physics::BreakEvent& broken : done.breaks) readBreak(broken);
  shakeCamera(rule.shake * physics::shareAt((center - viewpoint_.position).norm(), rules::kShakeReach));
}

}  // namespace brittle::sim
