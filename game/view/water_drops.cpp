#include "game/view/water_drops.h"

#include <cmath>

#include "engine/math/trig.h"
#include "game/view/noise.h"

namespace brittle::view {
namespace {

constexpr float kDropGravity = 9.81f;                           // [m/s2]
constexpr float kJetAfter = 0.16f;                              // the middle comes up so long after the crown [s]
constexpr float kDropHiddenNear = 0.5f, kDropShownFrom = 2.0f;  // from the eye [m]
const render::Rgb kDropColor(0.86f, 0.95f, 1.0f);

/// A drop in the air: where it left, how, how long ago.
struct Drop {
  Vec3 from, velocity;
  float age, radius, light;
};

void add(const Drop& drop, render::Frame& frame) {
  const auto at = [&](float t) {
    return Vec3(drop.from + drop.velocity * t - Vec3(0.0f, 0.5f * kDropGravity * t * t, 0.0f));
  };
  const float lands = 2.0f * drop.velocity.y() / kDropGravity;
  if (drop.age <= 0.0f || drop.age >= lands) return;
  const Vec3 now = at(drop.age);
  const float far = (now - frame.camera.position).norm();
  const float shown = clampTo((far - kDropHiddenNear) / (kDropShownFrom - kDropHiddenNear), 0.0f, 1.0f);
  const float light = drop.light * shown;
  frame.glows.push_back({now, drop.radius * 1.9f, render::packRgba(kDropColor, 0.85f * light), 0.55f});
  frame.beams.push_back(
      {at(maxOf(drop.age - 0.022f, 0.0f)), now, drop.radius * 0.45f, render::packRgba(kDropColor, 0.35f * light)});
}

}  // namespace

void addDrops(const Splash& splash, const sim::Event& event, const Vec3& point, std::uint64_t key,
              render::Frame& frame) {
  if (splash.age > 1.3f) return;
  const Noise noise(key * 131 + static_cast<std::uint64_t>(std::fabs(point.x()) * 4096.0f));
  const float push = clampTo(event.speed / 12.0f, 0.15f, 1.3f) * clampTo(event.size / 0.2f, 0.25f, 1.6f);
  const int crown = static_cast<int>(6.0f + 26.0f * minOf(push, 1.2f)),
            jet = static_cast<int>(7.0f * minOf(push, 1.0f));
  const float rim = 0.55f * event.size;
  const Vec3 along(0.10f * event.direction.x(), 0.0f, 0.10f * event.direction.z());  // it goes on the way it came
  for (int i = 0; i < crown + jet; ++i) {
    const auto n = static_cast<std::uint32_t>(i) * 8;
    const bool isJet = i >= crown;
    const float turn = 2.0f * kPi * noise(n);
    const Vec3 out(cosine(turn), 0.0f, sine(turn));
    const float aside = isJet ? noise(n + 1, 0.0f, 0.18f) : noise(n + 1, 0.5f, 1.9f) * std::sqrt(push);
    const float up = (isJet ? noise(n + 2, 1.6f, 3.9f) : noise(n + 2, 0.9f, 3.3f)) * std::sqrt(minOf(push, 1.2f));
    const float late = isJet ? kJetAfter + 0.10f * noise(n + 5) : 0.03f * noise(n + 5);
    add({point + out * (isJet ? 0.0f : rim), Vec3(out * aside + along + Vec3(0.0f, up, 0.0f)), splash.age - late,
         noise(n + 3, 0.010f, 0.026f) * (isJet ? 1.25f : 1.0f), noise(n + 4, 0.45f, 0.95f)},
        frame);
  }
}

}  // namespace brittle::view
