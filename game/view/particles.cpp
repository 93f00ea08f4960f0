#include "game/view/particles.h"

#include <cmath>

#include "engine/effects/has/explosions.h"
#include "game/view/noise.h"
#include "game/view/power_ups.h"

namespace brittle::view {
namespace {

using render::packRgba;
using render::Rgb;

constexpr float kTick = 1.0f / 60.0f;                     // [s]
constexpr float kFlashTicks = 8.0f, kSparkTicks = 46.0f;  // lives
constexpr float kSplinterTicks = 30.0f, kPuffTicks = 70.0f;
constexpr float kGlitterGravity = 5.0f, kGravity = 9.0f;  // glitter falls slower than splinters [m/s2]
constexpr float kHiddenNear = 0.5f, kShownFrom = 2.5f;    // distances from the eye, chosen by eye [m]
constexpr float kHitSpeed = 7.0f;                         // slower hits raise no dust [m/s]

/// What a kind of thing throws off when it breaks, for a size of half a metre.
struct Burst {
  Rgb light, dust;
  int sparks, stars, splinters, puffs;
  float flash;  // radius [m]; 0: none
};

Burst burstOf(sim::Look look) {
  const Rgb pale(0.88f, 0.97f, 1.0f), wood(0.62f, 0.48f, 0.36f), stone(0.66f, 0.66f, 0.68f);
  switch (look) {
    case sim::Look::Crystal:
      return {{0.60f, 0.86f, 1.0f}, pale, 20, 9, 8, 2, 0.95f};
    case sim::Look::Wood:
      return {wood, wood, 0, 0, 12, 4, 0.0f};
    case sim::Look::Stone:
    case sim::Look::Static:
      return {stone, stone, 0, 0, 8, 6, 0.0f};
    default:
      return {pale, {0.90f, 0.96f, 0.98f}, 16, 4, 14, 5, 0.5f};
  }
}

/// One event's particles; `key` makes them its own.
class Emitter {
 public:
  Emitter(const Vec3& point, const Vec3& direction, float age, std::uint64_t key, render::Frame& frame)
      : point_(point), direction_(direction), age_(age), noise_(key), frame_(frame) {}

  void flash(const Rgb& color, float radius) {
    if (age_ >= kFlashTicks || radius <= 0.0f) return;
    const float left = 1.0f - age_ / kFlashTicks;
    frame_.glows.push_back(
        {point_, radius * (1.3f - 0.3f * left), packRgba(color, 0.5f * left * left * shown(point_))});
    frame_.glows.push_back({point_, 1.6f * radius * left, packRgba(color, 0.8f * left * shown(point_)), 0.0f, 1.0f});
  }

  /// Points of light that twinkle as they fall; the first `stars` of them have rays.
  void sparks(const Rgb& color, int count, int stars, float spread) {
    if (age_ >= kSparkTicks) return;
    const float left = 1.0f - age_ / kSparkTicks;
    for (int i = 0; i < count + stars; ++i) {
      const auto n = static_cast<std::uint32_t>(i) * 8;
      const float twinkle = std::sin(age_ * noise_(n + 4, 0.25f, 0.8f) + 6.0f * noise_(n + 5));
      const float light = left * maxOf(0.25f + 0.75f * twinkle, 0.0f);
      const bool isStar = i < stars;
      const float radius = noise_(n + 6, 0.018f, 0.045f) * (isStar ? 4.0f : 1.0f);
      const Vec3 at = flight(n, spread, kGlitterGravity, age_);
      frame_.glows.push_back({at, radius, packRgba(color, light * shown(at)), 0.0f, isStar ? 1.0f : 0.0f});
    }
  }

  /// Thin bright streaks along their way.
  void splinters(const Rgb& color, int count, float spread) {
    if (age_ >= kSplinterTicks) return;
    const float left = 1.0f - age_ / kSplinterTicks;
    for (int i = 0; i < count; ++i) {
      const auto n = 512 + static_cast<std::uint32_t>(i) * 8;
      const Vec3 to = flight(n, spread, kGravity, age_),
                 from = flight(n, spread, kGravity, age_ - noise_(n + 5, 1.0f, 2.5f));
      frame_.beams.push_back({from, to, noise_(n + 6, 0.004f, 0.009f), packRgba(color, 0.55f * left * shown(to))});
    }
  }

  /// Soft clouds that grow and thin out.
  void puffs(const Rgb& color, int count, float size, float strength) {
    if (age_ >= kPuffTicks) return;
    const float t = age_ / kPuffTicks;
    for (int i = 0; i < count; ++i) {
      const auto n = 1024 + static_cast<std::uint32_t>(i) * 8;
      const Vec3 drift(noise_(n, -1.0f, 1.0f), noise_(n + 1, -0.4f, 0.8f), noise_(n + 2, -1.0f, 1.0f));
      const Vec3 at =
          point_ + drift * (size * (0.4f + 0.9f * std::sqrt(t))) + direction_ * (size * noise_(n + 3) * std::sqrt(t));
      const float radius = size * noise_(n + 4, 0.45f, 0.8f) * (0.35f + 0.65f * std::sqrt(t));
      frame_.glows.push_back({at, radius, packRgba(color, strength * (1.0f - t) * (1.0f - t) * shown(at)), 0.8f});
    }
  }

 private:
  /// What is right before the eye would cover the whole picture: it fades as it comes near.
  float shown(const Vec3& at) const {
    return clampTo(((at - frame_.camera.position).norm() - kHiddenNear) / (kShownFrom - kHiddenNear), 0.0f, 1.0f);
  }

  /// Where the particle of index `n` is `age` ticks after it left.
  Vec3 flight(std::uint32_t n, float spread, float gravity, float age) const {
    const float t = maxOf(age, 0.0f) * kTick;
    const Vec3 aside(noise_(n, -1.0f, 1.0f), noise_(n + 1, -0.5f, 1.0f), noise_(n + 2, -1.0f, 1.0f));
    const Vec3 velocity = spread * aside + direction_ * noise_(n + 3, 0.2f, 2.6f);
    const float slowed = t / (1.0f + 0.8f * t);  // the air holds them back
    return point_ + velocity * slowed - Vec3(0.0f, 0.5f * gravity * t * t, 0.0f);
  }

  Vec3 point_, direction_;
  float age_;
  Noise noise_;
  render::Frame& frame_;
};

void addBreak(const sim::Event& event, Emitter emitter) {
  const Burst burst = burstOf(event.look);
  const float size = clampTo(event.size, 0.15f, 0.8f);
  const float share = clampTo(size / 0.5f, 0.4f, 1.5f);
  const auto some = [share](int count) { return static_cast<int>(static_cast<float>(count) * share + 0.5f); };
  emitter.flash(burst.light, burst.flash);
  emitter.puffs(burst.dust, some(burst.puffs), 0.9f * size, 0.20f);
  emitter.splinters(burst.light, some(burst.splinters), 2.4f);
  emitter.sparks(burst.light, some(burst.sparks), some(burst.stars), 1.7f);
}

/// A ball that hits what does not break.
void addHit(const sim::Event& event, Emitter emitter) {
  if (event.value != 1 || event.speed < kHitSpeed) return;
  const float share = clampTo(event.speed / 20.0f, 0.0f, 1.0f);
  if (event.look == sim::Look::Static || event.look == sim::Look::Stone)
    emitter.puffs(burstOf(sim::Look::Stone).dust, 3, 0.22f, 0.22f * share);
  if (event.look == sim::Look::Metal || event.look == sim::Look::Door)
    emitter.splinters({1.0f, 0.86f, 0.6f}, 6, 2.0f * share);
}

/// A power-up that a ball has hit.
void addTaken(const sim::Event& event, Emitter emitter) {
  const Rgb color = colorOf(static_cast<sim::PowerUp>(event.value));
  emitter.flash(color, 1.1f);
  emitter.sparks(color, 18, 6, 1.5f);
}

/// In the game's time, but no slower than that it is gone when it is forgotten. [ticks]
float ageOf(const Remembered& r, double tick, double time, float life) {
  const float seen = static_cast<float>(tick - static_cast<double>(r.tick)) + 0.5f;
  const float own = static_cast<float>(time - r.time) + 0.5f;
  return maxOf(own, seen * life / static_cast<float>(kMemoryTicks));
}

/// How far from it an event throws anything. [m]
float reachOf(const sim::Event& event) {
  constexpr float burst = 4.0f;  // the fastest sparks come 2.6 m far, and a flash is a metre wide
  return event.type == sim::EventType::Explosion ? maxOf(burst, event.size) : burst;
}

}  // namespace

void addParticles(const sim::FramePacket& packet, const Memory& memory, double tick, double time, Bounds& bounds,
                  render::Frame& frame) {
  const std::size_t glows = frame.glows.size(), streaks = frame.beams.size();
  std::uint64_t sameTick = 0, lastTick = 0;
  for (const Remembered& r : memory.events()) {
    sameTick = r.tick == lastTick ? sameTick + 1 : 0;
    lastTick = r.tick;
    // An event happens in the course of its tick: half a tick before the packet that brings it.
    const float life = r.event.type == sim::EventType::Explosion ? kBlastTicks : kPuffTicks;
    const float age = ageOf(r, tick, time, life);
    if (age < 0.0f || age >= life) continue;
    if (isBehind(frame.camera, r.pointIn(packet.originZ), reachOf(r.event))) {
      bounds.omissions.add(Omission::BehindCamera);
      continue;
    }
    const Emitter emitter(r.pointIn(packet.originZ), r.event.direction, age, r.tick * 64 + sameTick, frame);
    if (r.event.type == sim::EventType::Break) addBreak(r.event, emitter);
    if (r.event.type == sim::EventType::Hit) addHit(r.event, emitter);
    if constexpr (effects::kHasExplosions)
      if (r.event.type == sim::EventType::Explosion)
        addExplosion(r.event, r.pointIn(packet.originZ), age, r.tick * 64 + sameTick, frame);
    if (r.event.type == sim::EventType::PowerUpCollected) addTaken(r.event, emitter);
  }
  bounds.omissions.add(Omission::Glow, keepLatest(frame.glows, glows, bounds.budget.glows));
  bounds.omissions.add(Omission::Streak, keepLatest(frame.beams, streaks, bounds.budget.streaks));
}

}  // namespace brittle::view
