#include "game/view/power_ups.h"

#include <cmath>

#include "engine/math/trig.h"
#include "game/view/noise.h"

namespace brittle::view {
namespace {

constexpr float kTurn = 0.028f, kBob = 0.045f;        // [rad/tick], [rad/tick]
constexpr float kBobHeight = 0.05f;                   // [m]
constexpr float kHaloRadius = 0.62f, kOrbit = 0.36f;  // [m]
constexpr int kSparks = 5;

/// Of one thing: where it is in its turn. [rad]
float phaseOf(double time, float speed, std::uint32_t own) {
  return static_cast<float>(std::fmod(time * static_cast<double>(speed) + 1.7 * own, 6.283185307179586));
}

Vec3 bobOf(double time, std::uint32_t own) {
  return {0.0f, kBobHeight * sine(phaseOf(time, kBob, own)), 0.0f};
}

void addPickup(const sim::PickupView& pickup, double time, render::Frame& frame) {
  const render::Rgb color = colorOf(pickup.kind);
  const Vec3 at = pickup.position + bobOf(time, pickup.body);
  const float pulse = 0.85f + 0.15f * sine(phaseOf(time, 0.11f, pickup.body));
  frame.glows.push_back({at, kHaloRadius, render::packRgba(color, 0.42f * pulse)});
  frame.glows.push_back({at, 0.5f * kHaloRadius, render::packRgba(color, 0.55f * pulse)});
  for (int i = 0; i < kSparks; ++i) {
    const auto n = static_cast<std::uint32_t>(i);
    const Noise noise(pickup.body * 16 + n);
    const float angle = phaseOf(time, noise(0, 0.035f, 0.06f), n * 3), tilt = noise(1, 0.0f, kPi);
    const Vec3 around(cosine(angle), sine(angle) * cosine(tilt), sine(angle) * sine(tilt));
    const float light = 0.55f + 0.45f * sine(phaseOf(time, 0.19f, n * 7));
    frame.glows.push_back({at + around * kOrbit, 0.05f, render::packRgba(color, light), 0.0f, 0.6f});
  }
}

render::Rgb colorOfCharge(sim::Charge charge) {
  return colorOf(charge == sim::Charge::Barrel ? sim::PowerUp::Barrel : sim::PowerUp::NitroBalls);
}

void addCharge(const sim::BallView& ball, double time, render::Frame& frame) {
  const bool isBarrel = ball.charge == sim::Charge::Barrel;
  const render::Rgb color = colorOfCharge(ball.charge);
  const float flicker = 0.75f + 0.25f * Noise(ball.id * 977 + static_cast<std::uint64_t>(time))(0);
  const float size = isBarrel ? 2.0f : 1.0f;
  frame.glows.push_back({ball.pose.position, 2.6f * size * ball.radius, render::packRgba(color, 0.6f * flicker)});
  frame.glows.push_back({ball.pose.position, 1.6f * size * ball.radius, render::packRgba(color, 0.5f), 0.0f, 1.0f});
}

}  // namespace

render::Rgb colorOf(sim::PowerUp kind) {
  switch (kind) {
    case sim::PowerUp::BallFrenzy:
      return {0.36f, 0.95f, 0.46f};
    case sim::PowerUp::SlowMotion:
      return {0.95f, 0.36f, 0.90f};
    case sim::PowerUp::NitroBalls:
      return {1.0f, 0.86f, 0.26f};
    default:
      return {1.0f, 0.46f, 0.20f};
  }
}

std::uint32_t tintOf(const sim::BallView& ball) {
  return ball.charge == sim::Charge::None ? render::kWhite : render::packRgba(colorOfCharge(ball.charge));
}

void turnPickups(const sim::RoomView& room, double time, std::vector<Transform>& bodies) {
  for (const sim::PickupView& pickup : room.pickups) {
    if (pickup.body >= bodies.size()) continue;
    Transform& pose = bodies[pickup.body];
    pose.position += bobOf(time, pickup.body);
    const Quat tilt = rotationAbout(Vec3::UnitZ(), 0.25f);
    pose.rotation = tilt * rotationAbout(Vec3::UnitY(), phaseOf(time, kTurn, pickup.body)) * pose.rotation;
  }
}

void addPowerUps(const sim::FramePacket& packet, double time, render::Frame& frame) {
  for (const sim::RoomView& room : packet.rooms)
    for (const sim::PickupView& pickup : room.pickups) addPickup(pickup, time, frame);
  for (const sim::BallView& ball : packet.balls)
    if (ball.charge != sim::Charge::None) addCharge(ball, time, frame);
}

}  // namespace brittle::view
