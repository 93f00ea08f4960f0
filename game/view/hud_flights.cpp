// What flies to and from the ball counter: balls won rise from their crystal, balls lost in a crash fall out of it.
#include "game/view/hud_parts.h"
#include "game/view/noise.h"
#include "game/view/power_ups.h"

namespace brittle::view::hud {
namespace {

constexpr float kRiseTicks = 16.0f;  // a label stands over its crystal so long
constexpr float kFlyTicks = 30.0f;   // and then is on its way
constexpr float kFallTicks = 70.0f;
constexpr float kGravity = 0.00075f;  // [HUD heights/tick2]
constexpr int kMostFalling = 10;

/// Where a point of the room is on the picture; false behind the camera.
bool project(const render::Camera& camera, const Vec3& point, float aspect, render::HudPoint& place) {
  const Vec3 seen = camera.rotation.conjugate() * (point - camera.position);
  const float depth = -seen.z();
  if (depth < 0.3f) return false;
  const float x = seen.x() / (depth * camera.tanHalfWidth), y = seen.y() * aspect / (depth * camera.tanHalfWidth);
  place = {Vec2(0.5f + 0.5f * clampTo(x, -0.95f, 0.95f), 0.5f - 0.5f * clampTo(y, -0.9f, 0.9f)), Vec2::Zero()};
  return true;
}

void addWon(const Remembered& r, float age, const Vec3& point, float aspect, render::Frame& frame) {
  if (age >= kRiseTicks + kFlyTicks || r.event.value <= 0) return;
  render::HudPoint from = topCentre(0.0f, 0.4f);
  project(frame.camera, point + Vec3(0.0f, 0.35f, 0.0f), aspect, from);
  const render::HudPoint to = topCentre(0.0f, kCountDown);
  const float way = softStep(kRiseTicks, kRiseTicks + kFlyTicks, age);
  const float eased = way * way;
  render::HudPoint at{from.anchor + (to.anchor - from.anchor) * eased, from.offset + (to.offset - from.offset) * eased};
  at.offset.y() -= 0.03f * softStep(0.0f, kRiseTicks, age) * (1.0f - way);
  const float height = 0.048f - 0.020f * way;
  const float alpha = softStep(0.0f, 5.0f, age) * (1.0f - softStep(0.85f, 1.0f, way));
  frame.texts.push_back(
      {at, height, render::HudAlign::Center, render::packRgba(kWarm, alpha), number("+%d", r.event.value)});
}

/// A disc of its colour, from the room to its sign.
void addTaken(const Remembered& r, float age, const Vec3& point, const sim::Hud& hud, float aspect,
              render::Frame& frame) {
  if (age >= kTakenTicks) return;
  const auto kind = static_cast<sim::PowerUp>(r.event.value);
  render::HudPoint from = topCentre(0.0f, 0.4f);
  project(frame.camera, point, aspect, from);
  const render::HudPoint to = signOf(hud, kind);
  const float way = softStep(4.0f, kTakenTicks, age), eased = way * way;
  const render::HudPoint at{from.anchor + (to.anchor - from.anchor) * eased,
                            from.offset + (to.offset - from.offset) * eased};
  const float radius = 0.020f + 0.014f * (1.0f - way);
  frame.arcs.push_back({at, 0.0f, 1.8f * radius, 0.0f, 1.0f, render::packRgba(colorOf(kind), 0.25f)});
  frame.arcs.push_back({at, 0.0f, radius, 0.0f, 1.0f, render::packRgba(colorOf(kind), 0.95f)});
}

void addLost(const Remembered& r, float age, render::Frame& frame) {
  if (age >= kFallTicks || r.event.value <= 0) return;
  const float left = 1.0f - softStep(0.4f * kFallTicks, kFallTicks, age);
  frame.texts.push_back({topCentre(0.150f, kCountDown + 0.0012f * age), 0.038f, render::HudAlign::Center,
                         render::packRgba(kAlarm, left), number("-%d", r.event.value)});
  const Noise noise(r.tick);
  for (int i = 0; i < minOf(r.event.value, kMostFalling); ++i) {
    const auto n = static_cast<std::uint32_t>(i) * 4;
    const float start = noise(n, 0.0f, 10.0f), t = age - start;
    if (t < 0.0f) continue;
    const float across = noise(n + 1, -0.05f, 0.05f) + noise(n + 2, -0.0025f, 0.0025f) * t;
    const float down = kCountDown + noise(n + 3, -0.005f, 0.0f) * t + 0.5f * kGravity * t * t;
    addBall(topCentre(across, down), kBallRadius * 1.1f, left, frame);
  }
}

}  // namespace

void addFlights(const sim::FramePacket& packet, const Memory& memory, double tick, float aspect, render::Frame& frame) {
  for (const Remembered& r : memory.events()) {
    const float age = static_cast<float>(tick - static_cast<double>(r.tick)) + 0.5f;
    if (age < 0.0f) continue;
    if (r.event.type == sim::EventType::PowerUpCollected)
      addTaken(r, age, r.pointIn(packet.originZ), packet.hud, aspect, frame);
    if (!packet.hud.countsBalls) continue;
    if (r.event.type == sim::EventType::Crystal) addWon(r, age, r.pointIn(packet.originZ), aspect, frame);
    if (r.event.type == sim::EventType::Crash) addLost(r, age, frame);
  }
}

}  // namespace brittle::view::hud
