#include "game/view/water.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/profile.h"
#include "engine/math/trig.h"
#include "game/view/water_drops.h"

namespace brittle::view {
namespace {

constexpr float kWaterGravity = 9.81f;  // [m/s2]; of the picture's waves, whatever the room's
constexpr float kWavesFor = static_cast<float>(kMemoryTicks) / 60.0f;  // a splash is seen [s]
constexpr float kFoamFor = 2.2f;                                       // [s]
constexpr float kLongGroup = 2.1f, kLongShare = 0.45f;                 // length and height of the longer waves

/// One direction of the swell.
struct Swell {
  float x, z;       // the way its crests go, unit
  float length;     // [m]
  float amplitude;  // [m]
};
constexpr std::array<Swell, 5> kSwells = {{{0.28f, 0.96f, 2.9f, 0.0065f},
                                           {-0.80f, 0.60f, 1.9f, 0.0055f},
                                           {0.96f, -0.28f, 1.3f, 0.0045f},
                                           {-0.35f, -0.94f, 0.85f, 0.0032f},
                                           {0.66f, 0.75f, 0.55f, 0.0020f}}};

/// The hollow that it leaves, and the water that comes up in its place.
float craterHeight(const Splash& splash, float distance) {
  const float radius = 0.6f * splash.wavelength();
  const float off = distance / radius;
  if (off > 2.5f) return 0.0f;
  const float beat = std::sqrt(kWaterGravity / radius);  // of a basin as deep as it is wide [rad/s]
  return -2.2f * splash.amplitude() * exponential(-off * off - 2.6f * splash.age) * cosine(beat * splash.age);
}

/// A splash's heights and foam by distance, so that a grid of any size is cheap.
class Ring {
 public:
  explicit Ring(const Splash& splash) : place_(splash.place) {
    const float wavelength = kLongGroup * splash.wavelength();
    reach_ = groupSpeed(wavelength) * splash.age + 2.2f * wavelength * (0.55f + 0.45f * splash.age);
    for (std::size_t i = 0; i < kSteps; ++i) {
      const float distance = reach_ * static_cast<float>(i) / static_cast<float>(kSteps - 1);
      const float end = 1.0f - static_cast<float>(i) / static_cast<float>(kSteps - 1);
      heights_[i] = ringHeight(splash, distance) * minOf(8.0f * end, 1.0f);
      foam_[i] = splashFoam(splash, distance);
    }
  }
  bool reaches(const Vec2& low, const Vec2& high) const {
    return (place_ - place_.cwiseMax(low).cwiseMin(high)).norm() < reach_;
  }
  void add(const Vec2& at, float& height, float& foam) const {
    const float way = (at - place_).norm() / reach_ * static_cast<float>(kSteps - 1);
    const auto i = static_cast<std::size_t>(way);
    if (!(way < static_cast<float>(kSteps - 1))) return;
    const float t = way - static_cast<float>(i);
    height += heights_[i] + (heights_[i + 1] - heights_[i]) * t;
    foam = maxOf(foam, foam_[i] + (foam_[i + 1] - foam_[i]) * t);
  }

 private:
  static constexpr std::size_t kSteps = 128;
  Vec2 place_;
  float reach_ = 0.0f;  // [m]
  std::array<float, kSteps> heights_, foam_;
};

/// The moment in seconds, small enough for single precision: the fine waves of an hour later are as fine.
float wrapped(double seconds) {
  return static_cast<float>(std::fmod(seconds, 1024.0));
}

void fill(const std::vector<Ring>& rings, double originZ, double seconds, render::Water& water) {
  const Vec2 low = Vec2(water.center.x(), water.center.z()) - water.halfSize;
  const Vec2 step(2.0f * water.halfSize.x() / static_cast<float>(water.columns),
                  2.0f * water.halfSize.y() / static_cast<float>(water.rows));
  std::vector<const Ring*> near;
  for (const Ring& ring : rings)
    if (ring.reaches(low, low + 2.0f * water.halfSize)) near.push_back(&ring);
  for (int row = 0; row <= water.rows; ++row)
    for (int column = 0; column <= water.columns; ++column) {
      const Vec2 at = low + step.cwiseProduct(Vec2(static_cast<float>(column), static_cast<float>(row)));
      float height = swellHeight(at.x(), static_cast<double>(at.y()) + originZ, seconds), foam = 0.0f;
      for (const Ring* ring : near) ring->add(at, height, foam);
      water.heights.push_back(height);
      water.foam.push_back(foam);
    }
}

/// Waters of both rooms that lie before the camera and not all in the fog, farthest first.
std::vector<sim::WaterView> watersInSight(const sim::FramePacket& packet, const render::Frame& frame) {
  const float z = frame.camera.position.z(), farthest = minOf(frame.fog.end, frame.camera.farPlane);
  std::vector<sim::WaterView> seen;
  for (const sim::RoomView& room : packet.rooms)
    for (const sim::WaterView& water : room.waters) {
      const float nearEnd = z - water.center.z() - water.halfExtents.y();
      if (nearEnd < farthest && nearEnd + 2.0f * water.halfExtents.y() > -1.0f) seen.push_back(water);
    }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const sim::WaterView& a, const sim::WaterView& b) { return a.center.z() < b.center.z(); });
  return seen;
}

}  // namespace

float crestSpeed(float wavelength) {
  return std::sqrt(kWaterGravity * wavelength / (2.0f * kPi));
}

// The group widens as it goes, and its height falls as its ring grows.
float groupHeight(float distance, float age, float wavelength) {
  const float k = 2.0f * kPi / wavelength;
  const float width = wavelength * (0.55f + 0.45f * age);
  const float off = (distance - groupSpeed(wavelength) * age) / width;
  const float phase = k * (distance - crestSpeed(wavelength) * age);
  return exponential(-off * off) * cosine(phase) / std::sqrt(1.0f + 2.0f * distance / wavelength);
}

float Splash::wavelength() const {
  return clampTo(2.6f * size, 0.16f, 1.4f);
}

float Splash::amplitude() const {
  return 0.34f * minOf(size, 0.5f) * clampTo(speed / 9.0f, 0.15f, 1.0f);
}

float ringHeight(const Splash& splash, float distance) {
  if (splash.age < 0.0f || splash.age >= kWavesFor) return 0.0f;
  const float left = 1.0f - splash.age / kWavesFor, begun = minOf(splash.age / 0.12f, 1.0f);
  const float length = splash.wavelength();
  const float waves =
      groupHeight(distance, splash.age, length) + kLongShare * groupHeight(distance, splash.age, kLongGroup * length);
  return left * (splash.amplitude() * begun * waves + craterHeight(splash, distance));
}

float splashFoam(const Splash& splash, float distance) {
  if (splash.age < 0.0f || splash.age >= kFoamFor) return 0.0f;
  const float left = 1.0f - splash.age / kFoamFor;
  const float radius =
      splash.size * (1.1f + 1.9f * std::sqrt(splash.age)) * (0.6f + 0.4f * minOf(splash.speed / 8.0f, 1.5f));
  const float inside = clampTo(1.4f - distance / radius, 0.0f, 1.0f);
  return left * inside * clampTo(splash.speed * splash.size / 0.9f, 0.2f, 1.0f);
}

float swellHeight(float x, double along, double seconds) {
  double height = 0.0;
  for (const Swell& swell : kSwells) {
    const double k = 2.0 * static_cast<double>(kPi) / static_cast<double>(swell.length);
    const double way = static_cast<double>(swell.x * x) + static_cast<double>(swell.z) * along;
    height += static_cast<double>(swell.amplitude) * std::sin(k * way - std::sqrt(9.81 * k) * seconds);
  }
  return static_cast<float>(height);
}

void addWaters(const sim::FramePacket& packet, const Memory& memory, double tick, Bounds& bounds,
               render::Frame& frame) {
  BR_ZONE("waters");
  const std::vector<sim::WaterView> seen = watersInSight(packet, frame);
  if (seen.empty()) return;
  const double seconds = tick / 60.0;
  std::vector<Ring> rings;
  for (auto r = memory.events().rbegin(); r != memory.events().rend(); ++r) {
    if (r->event.type != sim::EventType::Splash) continue;
    // It happened in the course of its tick: half a tick before the packet that brings it.
    const float age = static_cast<float>(tick - static_cast<double>(r->tick) + 0.5) / 60.0f;
    const Vec3 point = r->pointIn(packet.originZ);
    const Splash splash{Vec2(point.x(), point.z()), age, r->event.size, r->event.speed};
    if (age < 0.0f || age >= kWavesFor) continue;
    addDrops(splash, r->event, point, r->tick, frame);
    if (rings.size() < bounds.budget.ripples)
      rings.emplace_back(splash);
    else
      bounds.omissions.add(Omission::Ripple);
  }
  for (const sim::WaterView& from : seen) {
    render::Water water;
    water.center = from.center;
    water.halfSize = from.halfExtents;
    water.columns = from.cells[0];
    water.rows = from.cells[1];
    water.along = static_cast<float>(std::fmod(packet.originZ, 512.0));
    water.seconds = wrapped(seconds);
    fill(rings, packet.originZ, seconds, water);
    frame.waters.push_back(std::move(water));
  }
}

}  // namespace brittle::view
