#include "game/view/smoke.h"

#include <algorithm>
#include <cmath>

#include "engine/math/trig.h"
#include "game/view/noise.h"

namespace brittle::view {
namespace {

constexpr float kPuffStart = 0.12f, kPuffSpread = 0.42f;  // radius as it begins [m], and of its growth [m/s^(1/2)]
constexpr float kPuffHold = 1.6f;                         // the air takes its speed at this rate [1/s]
constexpr float kPuffRise = 0.22f;                        // it is warm [m/s]
const render::Rgb kPuffColor(0.93f, 0.94f, 0.96f);

render::Puff puffOf(const Vec3& from, const Vec3& velocity, float age, std::uint64_t key) {
  const Noise noise(key);
  const Vec3 aside(noise(0, -1.0f, 1.0f), noise(1, -0.5f, 0.8f), noise(2, -1.0f, 1.0f));
  render::Puff puff;
  puff.position =
      from + velocity * puffDrift(age) + aside * (0.16f * std::sqrt(age)) + Vec3(0.0f, kPuffRise * age, 0.0f);
  puff.radius = puffRadius(age) * noise(3, 0.8f, 1.25f);
  puff.color = render::packRgba(kPuffColor * noise(4, 0.9f, 1.0f), puffCover(age));
  puff.turn = 6.28f * noise(5) + noise(6, -0.5f, 0.5f) * age;
  puff.pattern = noise(7) * 16.0f;
  return puff;
}

}  // namespace

float puffRadius(float age) {
  return kPuffStart + kPuffSpread * std::sqrt(maxOf(age, 0.0f));
}

float puffDrift(float age) {
  return (1.0f - exponential(-kPuffHold * maxOf(age, 0.0f))) / kPuffHold;
}

float puffCover(float age) {
  if (age < 0.0f || age >= kPuffSeconds) return 0.0f;
  const float left = 1.0f - age / kPuffSeconds;
  return 0.60f * left * left * minOf(0.3f + age / 0.15f, 1.0f);
}

void addSmoke(const sim::FramePacket& packet, const Memory& memory, double tick, Bounds& bounds, render::Frame& frame) {
  std::uint64_t sameTick = 0, lastTick = 0;
  for (const Remembered& r : memory.events()) {
    if (r.event.type != sim::EventType::Smoke) continue;
    sameTick = r.tick == lastTick ? sameTick + 1 : 0;
    lastTick = r.tick;
    // An event happens in the course of its tick: half a tick before the packet that brings it.
    const float age = (static_cast<float>(tick - static_cast<double>(r.tick)) + 0.5f) / 60.0f;
    if (puffCover(age) <= 0.0f) continue;
    frame.puffs.push_back(puffOf(r.pointIn(packet.originZ), r.event.direction, age, r.tick * 64 + sameTick));
  }
  bounds.omissions.add(Omission::Puff, keepLatest(frame.puffs, 0, bounds.budget.puffs));
  const Vec3 eye = frame.camera.position;
  std::stable_sort(frame.puffs.begin(), frame.puffs.end(), [&eye](const render::Puff& a, const render::Puff& b) {
    return (a.position - eye).squaredNorm() > (b.position - eye).squaredNorm();
  });
}

}  // namespace brittle::view
