#include "game/view/air.h"

#include <cmath>
#include <string_view>

#include "game/view/noise.h"

namespace brittle::view {
namespace {

constexpr double kTick = 1.0 / 60.0;  // [s]
constexpr double kCell = 0.5;         // a mote lives in its own slice of the way [m]
constexpr int kCells = 36;            // slices ahead of the camera
constexpr float kEdge = 0.5f;         // motes come and go this near to the ends of their way [m]

struct Air {
  std::string_view name;
  int motes;           // a slice
  float low, high;     // between which they move [m]
  float inner, outer;  // distance from the middle of the room [m]
  float rise;          // [m/s]
  float small, large;  // radius [m]
  float light;         // [0, 1]
  bool isStar;
};

constexpr Air kAirs[] = {
    {"falling", 1, -1.0f, 4.0f, 0.0f, 3.8f, -0.06f, 0.010f, 0.024f, 0.60f, false},
    {"fallinglite", 1, -1.0f, 4.0f, 0.0f, 3.6f, -0.05f, 0.010f, 0.020f, 0.50f, false},
    {"dustyfalling", 2, -1.0f, 4.5f, 0.0f, 4.0f, -0.07f, 0.010f, 0.030f, 0.45f, false},
    {"lowrising", 1, -1.0f, 0.8f, 0.0f, 3.5f, 0.10f, 0.012f, 0.028f, 0.60f, false},
    {"lowrising2", 2, -1.0f, 1.2f, 0.0f, 3.5f, 0.16f, 0.012f, 0.028f, 0.60f, false},
    {"lowrising3", 3, -1.0f, 1.6f, 0.0f, 3.5f, 0.22f, 0.010f, 0.026f, 0.60f, false},
    {"sides", 2, -0.8f, 4.0f, 2.2f, 4.5f, -0.03f, 0.012f, 0.030f, 0.60f, false},
    {"sidesrising", 2, -1.0f, 4.0f, 2.2f, 4.5f, 0.18f, 0.012f, 0.030f, 0.65f, false},
    {"bubbles", 2, -1.0f, 4.5f, 0.0f, 4.0f, 0.45f, 0.020f, 0.060f, 0.35f, false},
    {"starfield", 3, -4.0f, 7.0f, 1.5f, 9.0f, 0.0f, 0.030f, 0.110f, 0.90f, true},
};

const Air& airOf(std::string_view name) {
  for (const Air& air : kAirs)
    if (air.name == name) return air;
  return kAirs[0];
}

void addMote(const Air& air, std::int64_t cell, int index, double tick, double originZ, render::Frame& frame) {
  const Noise noise(static_cast<std::uint64_t>(cell));
  const auto n = static_cast<std::uint32_t>(index) * 8;
  const double height = static_cast<double>(air.high - air.low);
  const double risen =
      static_cast<double>(noise(n, 0.0f, air.high - air.low)) + tick * kTick * static_cast<double>(air.rise);
  const float y = air.low + static_cast<float>(risen - std::floor(risen / height) * height);
  const float sway = 0.15f * std::sin(static_cast<float>(std::fmod(tick, 7200.0)) * 0.014f + 6.0f * noise(n + 1));
  const float aside = noise(n + 2, air.inner, air.outer) * (noise(n + 3) < 0.5f ? -1.0f : 1.0f);
  const double z = (static_cast<double>(cell) + static_cast<double>(noise(n + 4))) * kCell;
  const float edge = clampTo(minOf(y - air.low, air.high - y) / kEdge, 0.0f, 1.0f);  // none jumps from end to end
  const float light = air.light * (air.rise == 0.0f ? 1.0f : edge) * noise(n + 6, 0.6f, 1.0f);
  frame.glows.push_back({Vec3(aside + sway, y, static_cast<float>(z - originZ)), noise(n + 5, air.small, air.large),
                         render::packRgba(render::Rgb(1.0f, 0.97f, 0.9f), light), 0.0f, air.isStar ? 1.0f : 0.0f});
}

}  // namespace

void addAir(const sim::FramePacket& packet, double tick, render::Frame& frame) {
  if (packet.rooms.empty() || packet.rooms.front().particles.empty()) return;
  const Air& air = airOf(packet.rooms.front().particles);
  const double cameraZ = static_cast<double>(packet.camera.position.z()) + packet.originZ;
  const auto first = static_cast<std::int64_t>(std::floor(cameraZ / kCell));
  for (int i = 0; i < kCells; ++i)
    for (int mote = 0; mote < air.motes; ++mote) addMote(air, first - i, mote, tick, packet.originZ, frame);
}

}  // namespace brittle::view
