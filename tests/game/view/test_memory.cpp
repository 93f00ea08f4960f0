#include "game/view/memory.h"

#include <gtest/gtest.h>

#include "game/view/air.h"
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

TEST(Memory, KnowsByHowMuchTheBallsChanged) {
  Memory memory;
  for (const std::int32_t balls : {25, 24, 29}) {
    sim::FramePacket packet = packetAt(static_cast<std::uint64_t>(balls));
    packet.hud.balls = balls;
    memory.tick(packet);
  }
  EXPECT_EQ(memory.ballsChange(), 5);
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
  addParticles(packet, memory, 40.0, 40.0, frame);
  addAir(packet, 40.0, frame);
  packet.originZ -= 64.0;
  packet.camera.position.z() += 64.0f;
  addParticles(packet, memory, 40.0, 40.0, shifted);
  addAir(packet, 40.0, shifted);
  ASSERT_GT(frame.glows.size(), 40u);
  ASSERT_EQ(shifted.glows.size(), frame.glows.size());
  for (std::size_t i = 0; i < frame.glows.size(); ++i) {
    EXPECT_NEAR(shifted.glows[i].position.z() - 64.0f, frame.glows[i].position.z(), 2e-5f);
    EXPECT_EQ(shifted.glows[i].color, frame.glows[i].color);
  }
}

TEST(Particles, AreNoneWhenNobodyAsks) {
  render::Frame frame;
  addParticles(packetAt(40), {}, 40.0, 40.0, frame);
  addAir(packetAt(40), 40.0, frame);
  EXPECT_TRUE(frame.glows.empty());
}

TEST(Particles, DependOnWhatBreaks) {
  const auto of = [](sim::Look look) {
    sim::FramePacket packet = packetAt(40);
    packet.events.push_back(eventOf(sim::EventType::Break, Vec3(0.0f, 1.0f, -3.0f)));
    packet.events[0].look = look;
    packet.events[0].size = 0.5f;
    Memory memory;
    memory.tick(packet);
    render::Frame frame;
    addParticles(packet, memory, 44.0, 44.0, frame);
    return frame;
  };
  const auto stars = [](const render::Frame& frame) {
    return std::count_if(frame.glows.begin(), frame.glows.end(), [](const render::Glow& g) { return g.star > 0.0f; });
  };
  EXPECT_GT(stars(of(sim::Look::Crystal)), stars(of(sim::Look::Glass)));
  EXPECT_GT(stars(of(sim::Look::Glass)), 0);
  EXPECT_EQ(stars(of(sim::Look::Wood)), 0);
  EXPECT_FALSE(of(sim::Look::Wood).beams.empty());  // splinters
}

TEST(Particles, FadeBeforeTheEye) {
  const auto lightAt = [](float ahead) {
    sim::FramePacket packet = packetAt(40);
    packet.events.push_back(eventOf(sim::EventType::Break, Vec3(0.0f, 1.0f, -ahead)));
    Memory memory;
    memory.tick(packet);
    render::Frame frame;
    frame.camera.position = Vec3(0.0f, 1.0f, 0.0f);
    addParticles(packet, memory, 40.0, 40.0, frame);
    std::uint32_t light = 0;
    for (const render::Glow& glow : frame.glows) light += glow.color >> 24;
    for (const render::Beam& beam : frame.beams) light += beam.color >> 24;
    return light;
  };
  EXPECT_EQ(lightAt(0.2f), 0u);
  EXPECT_LT(lightAt(1.2f), lightAt(4.0f) / 2);
  EXPECT_GT(lightAt(1.2f), 0u);
  EXPECT_EQ(lightAt(4.0f), lightAt(9.0f));
}

TEST(Particles, OfABreakAreGoneWellBeforeItIsForgotten) {
  sim::FramePacket packet = packetAt(40);
  packet.events.push_back(eventOf(sim::EventType::Break, Vec3(0.0f, 1.0f, -3.0f)));
  Memory memory;
  memory.tick(packet);
  render::Frame frame;
  addParticles(packet, memory, 40.0 + kMemoryTicks - 1.0, 40.0 + kMemoryTicks - 1.0, frame);
  EXPECT_TRUE(frame.glows.empty());
  EXPECT_TRUE(frame.beams.empty());
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
TEST(Particles, GoByTheGamesTime) {
  sim::FramePacket packet = packetAt(10);
  packet.events.push_back(eventOf(sim::EventType::Break, Vec3(0.0f, 1.0f, -5.0f)));
  Memory memory;
  memory.tick(packet);
  const auto beamsAt = [&](double tick, double time) {
    render::Frame frame;
    addParticles(packetAt(10), memory, tick, time, frame);
    return frame.beams;
  };
  ASSERT_FALSE(beamsAt(14.0, 14.0).empty());
  EXPECT_EQ(beamsAt(18.0, 14.0)[0].to, beamsAt(14.0, 14.0)[0].to) << "4 ticks later, but at the same time";
  EXPECT_FALSE(beamsAt(80.0, 27.0).empty());
  EXPECT_TRUE(beamsAt(10.0 + kMemoryTicks, 40.0).empty());
}

}  // namespace
}  // namespace brittle::view
