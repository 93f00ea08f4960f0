#include "game/view/lasers.h"

#include <cmath>

#include "game/view/noise.h"

namespace brittle::view {
namespace {

constexpr float kLaserRadius = 0.022f;  // of its core [m]
constexpr int kSparksOfBeam = 7;
constexpr double kSparkEvery = 16.0;  // a spark is followed by the next one after so many ticks
const render::Rgb kLaserColor(1.0f, 0.16f, 0.13f), kSparkColor(1.0f, 0.72f, 0.45f);

void addSparks(const sim::BeamView& beam, std::uint64_t key, double tick, render::Frame& frame) {
  const Vec3 back = normalizedOr(Vec3(beam.from - beam.to), Vec3::UnitY());
  for (int i = 0; i < kSparksOfBeam; ++i) {
    const double turns = tick / kSparkEvery + static_cast<double>(i) / kSparksOfBeam;
    const double whole = std::floor(turns);
    const auto phase = static_cast<float>(turns - whole);
    const Noise noise(key * 977 + static_cast<std::uint64_t>(whole) * 31 + static_cast<std::uint64_t>(i));
    const Vec3 aside(noise(0, -1.0f, 1.0f), noise(1, -0.7f, 1.0f), noise(2, -1.0f, 1.0f));
    const Vec3 velocity = 1.1f * aside + back * noise(3, 0.4f, 1.8f);
    const auto at = [&](float t) { return Vec3(beam.to + velocity * t - Vec3(0.0f, 4.0f * t * t, 0.0f)); };
    const float age = phase * static_cast<float>(kSparkEvery) / 60.0f;
    const std::uint32_t color = render::packRgba(kSparkColor, 0.9f * (1.0f - phase));
    frame.beams.push_back({at(maxOf(age - 0.02f, 0.0f)), at(age), 0.006f, color});
  }
}

}  // namespace

void addLasers(const sim::FramePacket& packet, double tick, render::Frame& frame) {
  const auto t = static_cast<float>(std::fmod(tick, 36000.0));
  std::uint64_t number = 0;
  for (const sim::RoomView& room : packet.rooms)
    for (const sim::BeamView& beam : room.beams) {
      const float pulse = 0.92f + 0.08f * std::sin(0.9f * t + 1.7f * static_cast<float>(++number));
      frame.lasers.push_back({beam.from, beam.to, kLaserRadius * pulse, render::packRgba(kLaserColor, pulse)});
      frame.glows.push_back({beam.from, 0.22f, render::packRgba(kLaserColor, 0.75f * pulse)});
      if (!beam.hits) continue;
      frame.glows.push_back({beam.to, 0.30f, render::packRgba(kLaserColor, 0.8f * pulse)});
      frame.glows.push_back({beam.to, 0.16f, render::packRgba(kSparkColor, 0.9f * pulse), 0.0f, 1.0f});
      addSparks(beam, number, tick, frame);
    }
}

}  // namespace brittle::view
