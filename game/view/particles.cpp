#include "game/view/particles.h"

#include <cmath>
#include <cstdio>

namespace brittle::view {
namespace {

using render::packRgba;

constexpr float kTick = 1.0f / 60.0f;  // [s]
constexpr float kSparkTicks = 34.0f;   // a spark's life
constexpr float kFlashTicks = 7.0f;
constexpr float kLabelTicks = 55.0f;
constexpr float kGravity = 6.0f;    // glitter falls slower than shards [m/s2]
constexpr float kMoteCell = 0.5f;   // a mote of dust lives in its own slice of the way [m]
constexpr int kMoteCells = 34;      // slices ahead of the camera
constexpr float kMoteFall = 0.05f;  // [m/s]

/// Numbers in [0, 1) that belong to a key; another index, another number.
class Noise {
 public:
  explicit Noise(std::uint64_t key) : key_(key * 0x9e3779b97f4a7c15ull) {}
  float operator()(std::uint32_t index) const {
    std::uint64_t h = key_ + index * 0xbf58476d1ce4e5b9ull;
    h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9ull;
    h = (h ^ h >> 27) * 0x94d049bb133111ebull;
    return static_cast<float>((h ^ h >> 31) >> 40) * 0x1p-24f;
  }
  float operator()(std::uint32_t index, float low, float high) const { return low + (high - low) * (*this)(index); }

 private:
  std::uint64_t key_;
};

render::Rgb sparkColor(sim::Look look) {
  return look == sim::Look::Crystal ? render::Rgb(0.55f, 0.85f, 1.0f) : render::Rgb(0.85f, 0.95f, 1.0f);
}

void addBreak(const Remembered& r, std::uint64_t key, float age, const Vec3& point, render::Frame& frame) {
  const bool isCrystal = r.event.look == sim::Look::Crystal;
  const render::Rgb color = sparkColor(r.event.look);
  if (age < kFlashTicks) {
    const float left = 1.0f - age / kFlashTicks;
    frame.glows.push_back(
        {point, (isCrystal ? 0.9f : 0.45f) * (1.3f - 0.3f * left), packRgba(color, 0.55f * left * left)});
  }
  if (age >= kSparkTicks) return;
  const Noise noise(key);
  const int sparks = isCrystal ? 22 : 12;
  const float left = 1.0f - age / kSparkTicks, t = age * kTick;
  for (int i = 0; i < sparks; ++i) {
    const auto n = static_cast<std::uint32_t>(i) * 8;
    const Vec3 spread(noise(n, -1.0f, 1.0f), noise(n + 1, -0.6f, 1.0f), noise(n + 2, -1.0f, 1.0f));
    const Vec3 velocity = 1.6f * spread + r.event.direction * noise(n + 3, 0.2f, 2.2f);
    const Vec3 at = point + velocity * t - Vec3(0.0f, 0.5f * kGravity * t * t, 0.0f);
    const float twinkle = 0.5f + 0.5f * std::sin(age * noise(n + 4, 0.4f, 1.1f) + 6.0f * noise(n + 5));
    frame.glows.push_back({at, noise(n + 6, 0.02f, 0.05f), packRgba(color, left * twinkle)});
  }
}

/// What was won rises over the place of the crystal.
void addLabel(const Remembered& r, float age, const Vec3& point, float aspect, render::Frame& frame) {
  const render::Camera& camera = frame.camera;
  const Vec3 seen = camera.rotation.conjugate() * (point + Vec3(0.0f, 0.4f, 0.0f) - camera.position);
  if (-seen.z() < 0.5f || age >= kLabelTicks || r.event.value <= 0) return;
  const float x = seen.x() / (-seen.z() * camera.tanHalfWidth),
              y = seen.y() * aspect / (-seen.z() * camera.tanHalfWidth);
  char text[16];
  std::snprintf(text, sizeof text, "+%d", r.event.value);
  const float left = 1.0f - age / kLabelTicks;
  const float height = clampTo(0.22f / -seen.z(), 0.028f, 0.07f);
  frame.texts.push_back({{Vec2(0.5f + 0.5f * x, 0.5f - 0.5f * y), Vec2(0.0f, -0.06f * (1.0f - left))},
                         height,
                         render::HudAlign::Center,
                         packRgba(render::Rgb(1.0f, 0.92f, 0.65f), minOf(1.0f, 2.0f * left)),
                         text});
}

void addDust(const sim::FramePacket& packet, double tick, render::Frame& frame) {
  const double cameraZ = static_cast<double>(packet.camera.position.z()) + packet.originZ;
  const auto first = static_cast<std::int64_t>(std::floor(cameraZ / static_cast<double>(kMoteCell)));
  for (int i = 0; i < kMoteCells; ++i) {
    const std::int64_t cell = first - i;
    const Noise noise(static_cast<std::uint64_t>(cell));
    const double z = (static_cast<double>(cell) + static_cast<double>(noise(2))) * static_cast<double>(kMoteCell);
    const float fall = static_cast<float>(std::fmod(tick * static_cast<double>(kTick * kMoteFall), 5.0));
    float y = noise(1, 0.0f, 5.0f) - fall;
    y = (y < 0.0f ? y + 5.0f : y) - 1.0f;
    const float sway = 0.15f * std::sin(static_cast<float>(std::fmod(tick, 7200.0)) * 0.014f + 6.0f * noise(3));
    const float edge = clampTo(minOf(y + 1.0f, 4.0f - y) * 2.0f, 0.0f, 1.0f);  // no mote jumps from floor to ceiling
    const Vec3 at(noise(0, -3.6f, 3.6f) + sway, y, static_cast<float>(z - packet.originZ));
    frame.glows.push_back({at, noise(4, 0.010f, 0.022f), packRgba(render::Rgb(1.0f, 0.97f, 0.9f), 0.55f * edge)});
  }
}

}  // namespace

void addParticles(const sim::FramePacket& packet, const Memory& memory, double tick, float aspect,
                  render::Frame& frame) {
  std::uint64_t sameTick = 0, lastTick = 0;
  for (const Remembered& r : memory.events()) {
    sameTick = r.tick == lastTick ? sameTick + 1 : 0;
    lastTick = r.tick;
    // An event happens in the course of its tick: half a tick before the packet that brings it.
    const float age = static_cast<float>(tick - static_cast<double>(r.tick)) + 0.5f;
    if (age < 0.0f) continue;
    const Vec3 point = r.pointIn(packet.originZ);
    if (r.event.type == sim::EventType::Break) addBreak(r, r.tick * 64 + sameTick, age, point, frame);
    if (r.event.type == sim::EventType::Crystal) addLabel(r, age, point, aspect, frame);
  }
  if (!packet.rooms.empty() && !packet.rooms.front().particles.empty()) addDust(packet, tick, frame);
}

}  // namespace brittle::view
