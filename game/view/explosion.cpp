// A blast as light, fire, sparks and smoke. The module of Effect::Explosions.
#include <cmath>

#include "engine/math/trig.h"
#include "game/view/noise.h"
#include "game/view/power_ups.h"

namespace brittle::view {
namespace {

using render::packRgba;
using render::Rgb;

constexpr float kSecondsPerTick = 1.0f / 60.0f;
constexpr float kLightTicks = 9.0f, kFireTicks = 26.0f, kEmberTicks = 55.0f, kGlareTicks = 10.0f;

/// The fire's colour, from white over yellow and orange to a dull red. [0, 1]
Rgb fireAt(float t) {
  const Rgb hot(1.0f, 0.95f, 0.78f), warm(1.0f, 0.62f, 0.18f), dull(0.50f, 0.12f, 0.05f);
  return t < 0.35f ? Rgb(hot + (warm - hot) * (t / 0.35f)) : Rgb(warm + (dull - warm) * ((t - 0.35f) / 0.65f));
}

/// Evenly over the sphere.
Vec3 directionOf(const Noise& noise, std::uint32_t n) {
  const float up = noise(n, -1.0f, 1.0f), turn = noise(n + 1, 0.0f, 2.0f * kPi);
  const float aside = std::sqrt(maxOf(1.0f - up * up, 0.0f));
  return {aside * cosine(turn), up, aside * sine(turn)};
}

class Burning {
 public:
  Burning(const Vec3& center, float size, float age, std::uint64_t key, render::Frame& frame)
      : center_(center), size_(size), age_(age), noise_(key), frame_(frame) {}

  void light() {
    if (age_ >= kLightTicks) return;
    const float left = 1.0f - age_ / kLightTicks;
    frame_.glows.push_back({center_, size_ * 2.6f, packRgba({1.0f, 0.88f, 0.62f}, 0.6f * left * left)});
    frame_.glows.push_back({center_, size_ * 1.3f * left, packRgba({1.0f, 0.97f, 0.88f}, 0.9f * left), 0.0f, 1.0f});
  }

  /// Balls of fire that swell, rise and go out.
  void fire(int count) {
    if (age_ >= kFireTicks) return;
    for (int i = 0; i < count; ++i) {
      const auto n = static_cast<std::uint32_t>(i) * 8;
      const float t = clampTo(age_ / (kFireTicks * noise_(n + 3, 0.65f, 1.0f)), 0.0f, 1.0f);
      const float out = 1.0f - (1.0f - t) * (1.0f - t);
      const Vec3 at = center_ + directionOf(noise_, n) * (size_ * noise_(n + 2, 0.25f, 0.95f) * out) +
                      Vec3(0.0f, 0.25f * size_ * t * t, 0.0f);
      const float radius = size_ * noise_(n + 4, 0.30f, 0.52f) * (0.35f + 0.65f * out);
      frame_.glows.push_back({at, radius, packRgba(fireAt(t), 0.85f * (1.0f - t) * shown(at)), 0.35f * t});
    }
  }

  /// Smoke that stays where the fire was, and thins out.
  void smoke(int count) {
    constexpr float from = 5.0f;
    if (age_ < from || age_ >= kBlastTicks) return;
    const float t = (age_ - from) / (kBlastTicks - from);
    for (int i = 0; i < count; ++i) {
      const auto n = 512 + static_cast<std::uint32_t>(i) * 8;
      const Vec3 way = directionOf(noise_, n) * (size_ * noise_(n + 2, 0.3f, 1.15f) * std::sqrt(t + 0.12f));
      const Vec3 at = center_ + way + Vec3(0.0f, 0.55f * size_ * t, 0.0f);
      const float radius = size_ * noise_(n + 4, 0.35f, 0.60f) * (0.5f + 0.7f * std::sqrt(t));
      const float grey = noise_(n + 5, 0.20f, 0.38f);
      const float strength = 0.34f * (1.0f - t) * (1.0f - t) * minOf((age_ - from) / 8.0f, 1.0f);
      frame_.glows.push_back({at, radius, packRgba(Rgb::Constant(grey), strength * shown(at)), 0.95f});
    }
  }

  /// Glowing bits on their way outwards.
  void embers(int count) {
    if (age_ >= kEmberTicks) return;
    const float left = 1.0f - age_ / kEmberTicks;
    for (int i = 0; i < count; ++i) {
      const auto n = 2048 + static_cast<std::uint32_t>(i) * 8;
      const Vec3 to = flight(n, age_), from = flight(n, age_ - noise_(n + 4, 1.0f, 2.2f));
      const Rgb color = fireAt(0.1f + 0.6f * (1.0f - left));
      frame_.beams.push_back({from, to, noise_(n + 5, 0.006f, 0.014f), packRgba(color, 0.9f * left * shown(to))});
    }
  }

 private:
  Vec3 flight(std::uint32_t n, float age) const {
    const float t = maxOf(age, 0.0f) * kSecondsPerTick;
    const float speed = (3.5f + 3.0f * size_) * noise_(n + 2, 0.35f, 1.0f);
    return center_ + directionOf(noise_, n) * (speed * t / (1.0f + 1.6f * t)) - Vec3(0.0f, 3.0f * t * t, 0.0f);
  }
  /// What is right before the eye would cover the whole picture: it fades as it comes near.
  float shown(const Vec3& at) const {
    return clampTo(((at - frame_.camera.position).norm() - 0.5f) / 2.0f, 0.0f, 1.0f);
  }

  Vec3 center_;
  float size_, age_;
  Noise noise_;
  render::Frame& frame_;
};

/// Of the ball of fire [m].
float fireSizeOf(const sim::Event& event) {
  return 0.24f * event.size;
}

}  // namespace

void addExplosion(const sim::Event& event, const Vec3& point, float age, std::uint64_t key, render::Frame& frame) {
  const float size = fireSizeOf(event);
  const float many = clampTo(size / 0.6f, 0.8f, 2.2f);
  const auto some = [many](float count) { return static_cast<int>(count * many); };
  Burning burning(point, size, age, key, frame);
  burning.smoke(some(9.0f));
  burning.fire(some(13.0f));
  burning.embers(some(22.0f));
  burning.light();
}

float glareOf(const sim::Event& event, float age, float distance) {
  const float near = clampTo(1.0f - distance / (3.0f * event.size), 0.0f, 1.0f);
  const float left = clampTo(1.0f - age / kGlareTicks, 0.0f, 1.0f);
  return clampTo(event.size / 9.0f, 0.0f, 1.0f) * near * left * left;
}

}  // namespace brittle::view
