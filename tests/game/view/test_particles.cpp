#include "game/view/particles.h"

#include <gtest/gtest.h>

#include "game/view/air.h"
#include "packets.h"

namespace brittle::view {
namespace {

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
  frame.camera.position = packet.camera.position;
  addParticles(packet, memory, 40.0, 40.0, anyBounds(), frame);
  addAir(packet, 40.0, frame);
  packet.originZ -= 64.0;
  packet.camera.position.z() += 64.0f;
  shifted.camera.position = packet.camera.position;
  addParticles(packet, memory, 40.0, 40.0, anyBounds(), shifted);
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
  addParticles(packetAt(40), {}, 40.0, 40.0, anyBounds(), frame);
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
    addParticles(packet, memory, 44.0, 44.0, anyBounds(), frame);
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
    addParticles(packet, memory, 40.0, 40.0, anyBounds(), frame);
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
  addParticles(packet, memory, 40.0 + kMemoryTicks - 1.0, 40.0 + kMemoryTicks - 1.0, anyBounds(), frame);
  EXPECT_TRUE(frame.glows.empty());
  EXPECT_TRUE(frame.beams.empty());
}

TEST(Particles, GoByTheGamesTime) {
  sim::FramePacket packet = packetAt(10);
  packet.events.push_back(eventOf(sim::EventType::Break, Vec3(0.0f, 1.0f, -5.0f)));
  Memory memory;
  memory.tick(packet);
  const auto beamsAt = [&](double tick, double time) {
    render::Frame frame;
    addParticles(packetAt(10), memory, tick, time, anyBounds(), frame);
    return frame.beams;
  };
  ASSERT_FALSE(beamsAt(14.0, 14.0).empty());
  EXPECT_EQ(beamsAt(18.0, 14.0)[0].to, beamsAt(14.0, 14.0)[0].to) << "4 ticks later, but at the same time";
  EXPECT_FALSE(beamsAt(80.0, 27.0).empty());
  EXPECT_TRUE(beamsAt(10.0 + kMemoryTicks, 40.0).empty());
}

}  // namespace
}  // namespace brittle::view
