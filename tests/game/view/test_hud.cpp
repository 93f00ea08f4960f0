#include "game/view/hud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "packets.h"

namespace brittle::view {
namespace {

using ::testing::Contains;
using ::testing::Not;

std::vector<std::string> textsOf(const sim::FramePacket& packet, const Memory& memory = {}) {
  render::Frame frame;
  addHud(packet, memory, static_cast<double>(packet.tick), frame);
  std::vector<std::string> texts;
  for (const render::HudText& text : frame.texts) texts.push_back(text.text);
  return texts;
}

TEST(Hud, ShowsBallsAndDistance) {
  sim::FramePacket packet = packetAt(1000);
  packet.hud.balls = 17;
  packet.hud.distance = 123.9f;
  EXPECT_THAT(textsOf(packet), ::testing::ElementsAre("17", "123 m"));
}

TEST(Hud, FillsTheRingWithTheStreak) {
  sim::FramePacket packet = packetAt(1000);
  packet.hud.streak = 23;
  render::Frame frame;
  addHud(packet, {}, 1000.0, frame);
  ASSERT_GE(frame.arcs.size(), 2u);
  EXPECT_FLOAT_EQ(frame.arcs[1].to, 0.3f);
}

TEST(Hud, HasADotForEachBallOfAThrow) {
  sim::FramePacket packet = packetAt(1000);
  render::Frame one, three;
  addHud(packet, {}, 1000.0, one);
  packet.hud.ballsPerThrow = 3;
  addHud(packet, {}, 1000.0, three);
  EXPECT_EQ(three.arcs.size(), one.arcs.size() + 2);
}

TEST(Hud, TheBarGrowsWithTheRoom) {
  sim::FramePacket packet = packetAt(1000);
  packet.hud.roomProgress = 0.25f;
  render::Frame frame;
  addHud(packet, {}, 1000.0, frame);
  ASSERT_EQ(frame.quads.size(), 2u);
  EXPECT_FLOAT_EQ(frame.quads[1].size.x(), 0.25f * frame.quads[0].size.x());
  const float left = frame.quads[0].at.offset.x() - 0.5f * frame.quads[0].size.x();
  EXPECT_FLOAT_EQ(frame.quads[1].at.offset.x() - 0.5f * frame.quads[1].size.x(), left);
}

TEST(Hud, HintsUntilTheFirstThrow) {
  const sim::FramePacket packet = packetAt(100);
  EXPECT_THAT(textsOf(packet), Contains("TAP TO THROW"));
  sim::FramePacket thrown = packetAt(90);
  thrown.events.push_back(eventOf(sim::EventType::Throw, Vec3::Zero()));
  Memory memory;
  memory.tick(thrown);
  EXPECT_THAT(textsOf(packet, memory), Not(Contains("TAP TO THROW")));
  EXPECT_THAT(textsOf(packetAt(400)), Not(Contains("TAP TO THROW")));
}

TEST(Hud, ACrashReddensTheBorder) {
  sim::FramePacket packet = packetAt(1000);
  render::Frame frame;
  addHud(packet, {}, 1000.0, frame);
  EXPECT_EQ(frame.border.w(), 0.0f);
  EXPECT_EQ(frame.tint.w(), 0.0f);
  packet.hud.pain = 1.0f;
  addHud(packet, {}, 1000.0, frame);
  EXPECT_GT(frame.border.w(), 0.5f);
  EXPECT_GT(frame.tint.w(), 0.2f);
}

TEST(Hud, SaysHowItEnded) {
  sim::FramePacket packet = packetAt(1000);
  packet.hud.gameOver = true;
  EXPECT_THAT(textsOf(packet), Contains("OUT OF BALLS"));
  packet.hud.levelDone = true;
  EXPECT_THAT(textsOf(packet), Contains("LEVEL DONE"));
}

}  // namespace
}  // namespace brittle::view
