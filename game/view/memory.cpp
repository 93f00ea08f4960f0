#include "game/view/memory.h"

namespace brittle::view {
namespace {

float since(std::uint64_t past, double tick) {
  const double age = tick - static_cast<double>(past);
  return age < static_cast<double>(kMemoryTicks) ? static_cast<float>(maxOf(age, 0.0))
                                                 : static_cast<float>(kMemoryTicks);
}

}  // namespace

void Memory::tick(const sim::FramePacket& packet) {
  while (!events_.empty() && events_.front().tick + kMemoryTicks <= packet.tick) events_.pop_front();
  for (const sim::Event& event : packet.events) {
    if (event.type == sim::EventType::RoomEntered) fogBefore_ = fog_;
    events_.push_back({event, packet.tick, static_cast<double>(event.point.z()) + packet.originZ, packet.time});
  }
  fog_ = fogOf(packet);
  if (knowsBalls_ && packet.hud.balls != balls_) {
    ballsChanged_ = true;
    ballsChange_ = packet.hud.balls - balls_;
    ballsTick_ = packet.tick;
  }
  balls_ = packet.hud.balls;
  knowsBalls_ = true;
}

void Memory::clear() {
  *this = Memory();
}

float Memory::ageOf(sim::EventType type, double tick) const {
  for (auto it = events_.rbegin(); it != events_.rend(); ++it)
    if (it->event.type == type && static_cast<double>(it->tick) <= tick + 1.0) return since(it->tick, tick);
  return static_cast<float>(kMemoryTicks);
}

float Memory::ballsAge(double tick) const {
  return ballsChanged_ ? since(ballsTick_, tick) : static_cast<float>(kMemoryTicks);
}

render::Fog fogOf(const sim::FramePacket& packet) {
  render::Fog fog;
  if (!packet.rooms.empty()) {
    fog.bottom = packet.rooms.front().fogBottom;
    fog.top = packet.rooms.front().fogTop;
  }
  if (packet.fogFull > packet.fogNear) {
    fog.start = packet.fogNear;
    fog.end = packet.fogFull;
  }
  return fog;
}

}  // namespace brittle::view
