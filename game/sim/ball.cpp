#include "game/sim/ball.h"

#include "game/sim/constants.h"
#include "game/sim/event.h"

namespace brittle::sim {

std::vector<BallStart> throwBalls(const Camera& camera, const replay::Throw& aim, int count, float gravity) {
  const Vec3 ahead(static_cast<float>(aim.x) * replay::kAimStep, static_cast<float>(aim.y) * replay::kAimStep, -1.0f);
  const Vec3 direction = camera.rotation * normalizedOr(ahead, -Vec3::UnitZ());
  const Vec3 right = camera.rotation * Vec3::UnitX();
  const float speed = rules::kThrowSpeed + camera.velocity.norm();
  // In free fall the drop over the time t to the aimed distance is g t^2 / 2: a rise of g t / 2 makes up for it.
  const float rise = 0.5f * gravity * (rules::kAimDistance / speed);
  std::vector<BallStart> starts;
  for (int i = 0; i < count; ++i) {
    const float aside = (static_cast<float>(i) - 0.5f * static_cast<float>(count - 1)) * rules::kVolleySpread;
    BallStart start;
    start.position = camera.position + direction * rules::kThrowAhead + right * aside;
    start.velocity = direction * speed + Vec3(0.0f, rise, 0.0f);
    starts.push_back(start);
  }
  return starts;
}

physics::BodyHandle makeBall(physics::World& world, const BallStart& start, std::uint32_t number) {
  physics::BodyDef def;
  def.type = physics::BodyType::Dynamic;
  def.pose.position = start.position;
  def.velocity = start.velocity;
  def.userData = kBallBit | number;
  const physics::BodyHandle body = world.createBody(def);
  physics::ShapeDef shape;
  shape.surface.density = rules::kBallDensity;
  shape.surface.friction = rules::kBallFriction;
  shape.surface.restitution = rules::kBallRestitution;
  shape.surface.category = rules::kCategoryBall;
  shape.drawMaterial = static_cast<std::uint16_t>(Look::Ball);
  shape.userData = kBallBit | number;
  world.addSphere(body, shape, rules::kBallRadius);
  return body;
}

}  // namespace brittle::sim
