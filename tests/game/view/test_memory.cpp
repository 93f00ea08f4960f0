#include "game/view/memory.h"

#include <gtest/gtest.h>

#include "game/view/air.h"
#include "packets.h"

namespace brittle::view {
namespace {

TEST(Memory, ForgetsAfterItsTime) {
  Memory memory;
  sim::FramePacket packet = packetAt(10);
  packet.events.push_back(eventOf(sim::EventType::Break, Vec3::Zero()));
  memory.tick(packet);
  memory.tick(packetAt(10 + kMemoryTicks - 1));
  EXPECT_EQ(memory.events().size(), 1u);
  memory.tick(packetAt(10 + kMemoryTicks));
  EXPECT_TRUE(memory.events().empty());
}

TEST(Memory, AgesCountFromTheEvent) {
  Memory memory;
  EXPECT_EQ(memory.ageOf(sim::EventType::Throw, 5.0), static_cast<float>(kMemoryTicks));
  sim::FramePacket packet = packetAt(10);
  packet.events.push_back(eventOf(sim::EventType::Throw, Vec3::Zero()));
  memory.tick(packet);
  EXPECT_FLOAT_EQ(memory.ageOf(sim::EventType::Throw, 12.5), 2.5f);
}

TEST(Memory, KeepsTheFogOfTheRoomBefore) {
  Memory memory;
  sim::FramePacket packet = packetAt(1);
  packet.rooms[0].fogTop = Vec3(0.1f, 0.2f, 0.3f);
  memory.tick(packet);
  packet = packetAt(2);
  packet.rooms[0].fogTop = Vec3(0.9f, 0.9f, 0.9f);
  packet.events.push_back(eventOf(sim::EventType::RoomEntered, Vec3::Zero()));
  memory.tick(packet);
  EXPECT_EQ(memory.fogBefore().top, Vec3(0.1f, 0.2f, 0.3f));
}

TEST(Memory, KnowsWhenTheBallsChanged) {
  Memory memory;
  memory.tick(packetAt(1));
  EXPECT_EQ(memory.ballsAge(1.0), static_cast<float>(kMemoryTicks));  // the first number is no change
  sim::FramePacket packet = packetAt(2);
  packet.hud.balls = 24;
  memory.tick(packet);
  EXPECT_EQ(memory.ballsAge(5.0), 3.0f);
}

TEST(Memory, KnowsByHowMuchTheBallsChanged) {
  Memory memory;
  for (const std::int32_t balls : {25, 24, 29}) {
    sim::FramePacket packet = packetAt(static_cast<std::uint64_t>(balls));
    packet.hud.balls = balls;
    memory.tick(packet);
  }
  EXPECT_EQ(memory.ballsChange(), 5);
}

TEST(Air, MovesAsItsNameSays) {
  const auto meanHeight = [](const char* name, double tick) {
    sim::FramePacket packet = packetAt(0);
    packet.rooms[0].particles = name;
    render::Frame frame;
    addAir(packet, tick, frame);
    float sum = 0.0f;
    for (const render::Glow& glow : frame.glows) sum += glow.position.y();
    return sum / static_cast<float>(frame.glows.size());
  };
  EXPECT_LT(meanHeight("lowrising", 0.0), 0.6f);
  EXPECT_GT(meanHeight("falling", 0.0), 0.6f);
  EXPECT_NE(meanHeight("bubbles", 0.0), meanHeight("bubbles", 10.0));
  EXPECT_EQ(meanHeight("no such air", 5.0), meanHeight("falling", 5.0));
}

// In slow motion what flies is slower, as everything is; but gone by the time it is forgotten.
}  // namespace
}  // namespace brittle::view
