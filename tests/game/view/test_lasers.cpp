#include "game/view/lasers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/view/cues.h"
#include "packets.h"

namespace brittle::view {
namespace {

sim::FramePacket packetWithBeam(bool hits, const Vec3& from = Vec3(-2.0f, 1.0f, -4.0f)) {
  sim::FramePacket packet = packetAt(48);
  packet.rooms[0].beams.push_back({from, Vec3(2.0f, 1.0f, -4.0f), hits});
  return packet;
}

render::Frame frameOf(const sim::FramePacket& packet, double tick) {
  render::Frame frame;
  addLasers(packet, tick, frame);
  return frame;
}

TEST(LaserLook, IsABeamWithSparksOnlyWhereItMeetsSomething) {
  const render::Frame free = frameOf(packetWithBeam(false), 48.0), hit = frameOf(packetWithBeam(true), 48.0);
  ASSERT_EQ(free.lasers.size(), 1u);
  EXPECT_EQ(free.lasers[0].to, Vec3(2.0f, 1.0f, -4.0f));
  EXPECT_THAT(free.beams, ::testing::IsEmpty());
  EXPECT_GT(hit.beams.size(), 3u);
  for (const render::Beam& spark : hit.beams) EXPECT_LT((spark.to - Vec3(2.0f, 1.0f, -4.0f)).norm(), 1.5f);
  EXPECT_THAT(frameOf(packetAt(48), 48.0).lasers, ::testing::IsEmpty());
}

TEST(LaserLook, IsAFunctionOfTheMoment) {
  const render::Frame once = frameOf(packetWithBeam(true), 50.25), again = frameOf(packetWithBeam(true), 50.25);
  ASSERT_EQ(once.beams.size(), again.beams.size());
  for (std::size_t i = 0; i < once.beams.size(); ++i) EXPECT_EQ(once.beams[i].to, again.beams[i].to);
  EXPECT_NE(frameOf(packetWithBeam(true), 51.0).beams[0].to, once.beams[0].to);
}

TEST(LaserSounds, HumsInTimeAndDischargesWhenItStrikes) {
  const auto count = [](const sim::FramePacket& packet, audio::Sound sound) {
    Masking masking;
    Random random(3);
    int found = 0;
    for (const Cue& cue : cuesOf(packet, 0, masking, random)) found += cue.sound == sound ? 1 : 0;
    return found;
  };
  sim::FramePacket packet = packetWithBeam(true);
  EXPECT_EQ(count(packet, audio::Sound::LaserHum), 1);
  ++packet.tick;
  EXPECT_EQ(count(packet, audio::Sound::LaserHum), 0);
  packet.events.push_back(eventOf(sim::EventType::Crash, packet.camera.position));
  EXPECT_EQ(count(packet, audio::Sound::LaserDischarge), 0) << "it ran into something else";
  packet.rooms[0].beams[0] = {packet.camera.position - Vec3::UnitX(), packet.camera.position + Vec3::UnitX(), true};
  EXPECT_EQ(count(packet, audio::Sound::LaserDischarge), 1);
}

}  // namespace
}  // namespace brittle::view
