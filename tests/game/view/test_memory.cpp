#include "game/view/memory.h"

#include <gtest/gtest.h>

#include "game/view/particles.h"
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

TEST(Particles, StayInPlaceWhenTheOriginShifts) {
  sim::FramePacket packet = packetAt(40);
  packet.rooms[0].particles = "dust";
  packet.originZ = -640.0;
  Memory memory;
  sim::FramePacket broken = packet;
  broken.tick = 30;
  broken.events.push_back(eventOf(sim::EventType::Break, Vec3(0.5f, 1.0f, -3.0f)));
  memory.tick(broken);
  render::Frame frame, shifted;
  addParticles(packet, memory, 40.0, 16.0f / 9.0f, frame);
  packet.originZ -= 64.0;
  packet.camera.position.z() += 64.0f;
  addParticles(packet, memory, 40.0, 16.0f / 9.0f, shifted);
  ASSERT_GT(frame.glows.size(), 40u);
  ASSERT_EQ(shifted.glows.size(), frame.glows.size());
  for (std::size_t i = 0; i < frame.glows.size(); ++i) {
    EXPECT_NEAR(shifted.glows[i].position.z() - 64.0f, frame.glows[i].position.z(), 2e-5f);
    EXPECT_EQ(shifted.glows[i].color, frame.glows[i].color);
  }
}

TEST(Particles, AreNoneWhenNobodyAsks) {
  render::Frame frame;
  addParticles(packetAt(40), {}, 40.0, 16.0f / 9.0f, frame);
  EXPECT_TRUE(frame.glows.empty());
}

TEST(Particles, AWonCrystalSaysHowMuch) {
  sim::FramePacket packet = packetAt(40);
  packet.events.push_back(eventOf(sim::EventType::Crystal, Vec3(0.0f, 0.6f, -4.0f)));
  packet.events[0].value = 3;
  Memory memory;
  memory.tick(packet);
  render::Frame frame;
  frame.camera.position = packet.camera.position;
  addParticles(packet, memory, 40.0, 16.0f / 9.0f, frame);
  ASSERT_EQ(frame.texts.size(), 1u);
  EXPECT_EQ(frame.texts[0].text, "+3");
  EXPECT_NEAR(frame.texts[0].at.anchor.x(), 0.5f, 1e-6f);
}

}  // namespace
}  // namespace brittle::view
