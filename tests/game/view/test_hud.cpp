#include "game/view/hud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/render/text.h"
#include "packets.h"

namespace brittle::view {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr float kAspect = 16.0f / 9.0f;
constexpr int kStreakParts = 10;

render::Frame hudOf(const sim::FramePacket& packet, const Memory& memory = {}, bool paused = false) {
  render::Frame frame;
  addHud(packet, memory, static_cast<double>(packet.tick), kAspect, frame, paused);
  return frame;
}

std::vector<std::string> textsOf(const sim::FramePacket& packet, const Memory& memory = {}, bool paused = false) {
  std::vector<std::string> texts;
  for (const render::HudText& text : hudOf(packet, memory, paused).texts) texts.push_back(text.text);
  return texts;
}

sim::FramePacket playingAt(std::uint64_t tick) {
  sim::FramePacket packet = packetAt(tick);
  packet.hud.phaseTicks = static_cast<std::uint32_t>(tick);
  packet.hud.rooms = 2;
  return packet;
}

TEST(Hud, ShowsBallsAndDistance) {
  sim::FramePacket packet = playingAt(1000);
  packet.hud.balls = 17;
  packet.hud.distance = 123.9f;
  EXPECT_THAT(textsOf(packet), ::testing::ElementsAre("17", "123 m"));
}

TEST(Hud, ShowsNoBallsWhereTheyAreFree) {
  sim::FramePacket packet = playingAt(1000);
  packet.hud.countsBalls = false;
  EXPECT_THAT(textsOf(packet), ::testing::ElementsAre("0 m"));
  EXPECT_THAT(hudOf(packet).arcs, IsEmpty());
}

TEST(Hud, WarmsAPartOfTheRingForEachCrystalOfTheStreak) {
  sim::FramePacket packet = playingAt(1000);
  const render::Frame none = hudOf(packet);
  packet.hud.streak = 23;
  const render::Frame three = hudOf(packet);
  for (std::size_t i = 0; i < kStreakParts; ++i) EXPECT_EQ(three.arcs[i].color != none.arcs[i].color, i < 3) << i;
}

TEST(Hud, HasABallForEachOfAThrow) {
  sim::FramePacket packet = playingAt(1000);
  const std::size_t one = hudOf(packet).arcs.size();
  packet.hud.ballsPerThrow = 3;
  const std::size_t three = hudOf(packet).arcs.size();
  EXPECT_EQ(three - one, 2 * (one - kStreakParts));
}

TEST(Hud, ABarForEachRoomFillsAsTheRoomIsPassed) {
  sim::FramePacket packet = playingAt(1000);
  packet.hud.rooms = 3;
  packet.hud.room = 1;
  packet.hud.roomProgress = 0.25f;
  const std::vector<render::HudQuad> quads = hudOf(packet).quads;
  ASSERT_EQ(quads.size(), 5u);  // three bars, one of them full and one in part
  EXPECT_FLOAT_EQ(quads[1].size.x(), quads[0].size.x());
  EXPECT_FLOAT_EQ(quads[3].size.x(), 0.25f * quads[2].size.x());
  const auto left = [](const render::HudQuad& quad) { return quad.at.offset.x() - 0.5f * quad.size.x(); };
  EXPECT_NEAR(left(quads[3]), left(quads[2]), 1e-6f);
}

TEST(Hud, ShowsTheFrameTimeAndItsParts) {
  render::Frame frame;
  addTimings({.frame = 16.667f, .simulate = 1.25f, .draw = 3.5f, .swap = 11.9f, .longest = 33.3f}, frame);
  std::vector<std::string> texts;
  for (const render::HudText& text : frame.texts) texts.push_back(text.text);
  EXPECT_THAT(texts, ::testing::ElementsAre("frame", "16.67 ms", "longest", "33.30 ms", "simulate", "1.25 ms", "draw",
                                            "3.50 ms", "swap", "11.90 ms"));
  EXPECT_FLOAT_EQ(frame.texts[0].at.offset.y(), frame.texts[1].at.offset.y()) << "a name and its number share a line";
  EXPECT_LT(frame.texts[1].at.offset.y(), frame.texts[2].at.offset.y());
}

TEST(Hud, LongTimesStandApartFromTheirNames) {
  render::Frame frame;
  addTimings({.frame = 1234.567f, .simulate = 1234.567f, .draw = 0.0f, .swap = 0.0f, .longest = 9876.543f}, frame);
  ASSERT_EQ(frame.quads.size(), 1u);
  const render::HudQuad& back = frame.quads[0];
  for (std::size_t i = 0; i < frame.texts.size(); i += 2) {
    const render::HudText &name = frame.texts[i], &time = frame.texts[i + 1];
    const float end = name.at.offset.x() + name.height * render::textWidth(name.text);
    const float start = time.at.offset.x() - time.height * render::textWidth(time.text);
    EXPECT_GT(start - end, 0.5f * name.height) << name.text;
    EXPECT_LT(time.at.offset.x(), back.at.offset.x() + 0.5f * back.size.x());
    EXPECT_LT(std::fabs(time.at.offset.y() - back.at.offset.y()) + name.height, 0.5f * back.size.y() + 0.01f);
  }
}

TEST(Hud, ListsTheEffectsThatRunBelowTheTimes) {
  sim::FramePacket packet = playingAt(100);
  packet.rooms[0].effects = effects::EffectMask().with(effects::Effect::Water).with(effects::Effect::Echo);
  render::Frame frame;
  addTimings({}, frame);
  const float lowest = frame.texts.back().at.offset.y();
  frame.texts.clear();
  addRunning(packet, frame);
  ASSERT_EQ(frame.texts.size(), 2u);
  EXPECT_EQ(frame.texts[0].text, "water");
  EXPECT_EQ(frame.texts[1].text, "echo");
  EXPECT_GT(frame.texts[0].at.offset.y(), lowest);
}

TEST(Hud, HintsUntilTheFirstThrow) {
  const sim::FramePacket packet = playingAt(100);
  EXPECT_THAT(textsOf(packet), Contains("TAP TO THROW"));
  sim::FramePacket thrown = playingAt(90);
  thrown.events.push_back(eventOf(sim::EventType::Throw, Vec3::Zero()));
  Memory memory;
  memory.tick(thrown);
  EXPECT_THAT(textsOf(packet, memory), Not(Contains("TAP TO THROW")));
  EXPECT_THAT(textsOf(playingAt(400)), Not(Contains("TAP TO THROW")));
}

TEST(Hud, HintsAreForTheBeginning) {
  sim::FramePacket packet = playingAt(100);
  packet.hud.distance = 2000.0f;
  EXPECT_THAT(textsOf(packet), ::testing::ElementsAre("25", "2000 m"));
}

TEST(Hud, CountsTheLastBallsDown) {
  sim::FramePacket packet = playingAt(1000);
  packet.hud.balls = 8;
  Memory memory;
  memory.tick(packet);
  packet = playingAt(1001);
  packet.hud.balls = 7;
  memory.tick(packet);
  const auto largest = [](const render::Frame& frame) {
    float height = 0.0f;
    for (const render::HudText& text : frame.texts)
      if (text.text == "7") height = maxOf(height, text.height);
    return height;
  };
  EXPECT_GT(largest(hudOf(packet, memory)), 0.2f);
  packet.tick = 1100;
  EXPECT_LT(largest(hudOf(packet, memory)), 0.1f);
  packet.hud.balls = 9;  // a ball won is no reason to count
  memory.tick(packet);
  EXPECT_LT(largest(hudOf(packet, memory)), 0.1f);
}

TEST(Hud, WonBallsFlyFromTheirCrystalToTheCounter) {
  sim::FramePacket packet = playingAt(100);
  sim::Event won = eventOf(sim::EventType::Crystal, packet.camera.position + Vec3(-1.0f, -0.5f, -4.0f));
  won.value = 5;
  packet.events.push_back(won);
  Memory memory;
  memory.tick(packet);
  packet.events.clear();
  const auto placeAt = [&](std::uint64_t tick) {
    packet.tick = tick;
    render::Frame frame;
    frame.camera.position = packet.camera.position;
    addHud(packet, memory, static_cast<double>(tick), kAspect, frame);
    for (const render::HudText& text : frame.texts)
      if (text.text == "+5") return text.at.anchor;
    return Vec2(-1.0f, -1.0f);
  };
  EXPECT_LT(placeAt(102).x(), 0.4f);
  EXPECT_GT(placeAt(102).y(), 0.4f);
  EXPECT_NEAR(placeAt(140).x(), 0.5f, 0.05f);
  EXPECT_LT(placeAt(140).y(), 0.1f);
  EXPECT_EQ(placeAt(160).x(), -1.0f);
}

TEST(Hud, LostBallsFall) {
  sim::FramePacket packet = playingAt(1000);
  const std::size_t before = hudOf(packet).arcs.size();
  sim::Event crash = eventOf(sim::EventType::Crash, Vec3::Zero());
  crash.value = 4;
  packet.events.push_back(crash);
  Memory memory;
  memory.tick(packet);
  packet.tick = 1020;
  EXPECT_THAT(textsOf(packet, memory), Contains("-4"));
  EXPECT_EQ(hudOf(packet, memory).arcs.size(), before + 4 * (before - kStreakParts));
}

TEST(Hud, ACrashReddensTheBorder) {
  sim::FramePacket packet = playingAt(1000);
  EXPECT_EQ(hudOf(packet).border.w(), 0.0f);
  EXPECT_EQ(hudOf(packet).tint.w(), 0.0f);
  packet.hud.pain = 1.0f;
  EXPECT_GT(hudOf(packet).border.w(), 0.5f);
  EXPECT_GT(hudOf(packet).tint.w(), 0.2f);
}

TEST(Hud, TheTitleStandsAloneAndGoesWithTheFirstTouch) {
  sim::FramePacket packet = playingAt(100);
  packet.hud.phase = sim::Phase::Title;
  EXPECT_THAT(textsOf(packet), ::testing::ElementsAre("BRITTLE", "TAP TO BEGIN"));
  packet.hud.phase = sim::Phase::Playing;
  packet.events.push_back(eventOf(sim::EventType::Begin, Vec3::Zero()));
  Memory memory;
  memory.tick(packet);
  packet.tick = 110;
  EXPECT_THAT(textsOf(packet, memory), Contains("BRITTLE"));
  packet.tick = 130;
  EXPECT_THAT(textsOf(packet, memory), Not(Contains("BRITTLE")));
}

TEST(Hud, NamesTheRoomThatIsEntered) {
  sim::FramePacket packet = playingAt(1000);
  packet.hud.room = 1;
  packet.events.push_back(eventOf(sim::EventType::RoomEntered, Vec3::Zero()));
  Memory memory;
  memory.tick(packet);
  packet.tick = 1050;
  EXPECT_THAT(textsOf(packet, memory), Contains("ROOM 2"));
  packet.tick = 1170;
  EXPECT_THAT(textsOf(packet, memory), Not(Contains("ROOM 2")));
}

TEST(Hud, SaysHowItEnded) {
  sim::FramePacket packet = playingAt(1000);
  packet.hud.phase = sim::Phase::GameOver;
  EXPECT_THAT(textsOf(packet), ::testing::ElementsAre("OUT OF BALLS", "0 m", "TAP TO TRY AGAIN"));
  packet.hud.phase = sim::Phase::Checkpoint;
  packet.hud.balls = packet.hud.checkpointBalls = 31;
  EXPECT_THAT(textsOf(packet), ::testing::ElementsAre("CHECKPOINT", "0 m", "31", "TAP TO GO ON"))
      << "nothing is said twice";
  EXPECT_GT(hudOf(packet).tint.w(), 0.2f);
  packet.hud.countsBalls = false;
  EXPECT_THAT(textsOf(packet), Not(Contains("31"))) << "balls that are free are not counted";
}

TEST(Hud, TheBallsOfAnEndStandInTheMiddleAndApart) {
  sim::FramePacket packet = playingAt(1000);
  packet.hud.phase = sim::Phase::Checkpoint;
  for (const int balls : {4, 45, 120}) {
    packet.hud.checkpointBalls = balls;
    const render::Frame frame = hudOf(packet);
    const auto text = std::find_if(frame.texts.begin(), frame.texts.end(),
                                   [&](const render::HudText& t) { return t.text == std::to_string(balls); });
    ASSERT_NE(text, frame.texts.end());
    const render::HudArc& ball = frame.arcs[1];  // below it lies its shade
    const float left = ball.at.offset.x() - ball.outer, gap = text->at.offset.x() - ball.at.offset.x() - ball.outer;
    EXPECT_GT(gap, 0.3f * text->height);
    EXPECT_NEAR(-left, text->at.offset.x() + text->height * render::textWidth(text->text), 1e-4f);
  }
}

TEST(Hud, APauseSaysSoOverADarkenedPicture) {
  sim::FramePacket packet = playingAt(1000);
  EXPECT_THAT(textsOf(packet, {}, true), Contains("PAUSED"));
  EXPECT_GT(hudOf(packet, {}, true).tint.w(), 0.3f);
  packet.hud.phase = sim::Phase::GameOver;
  EXPECT_THAT(textsOf(packet, {}, true), Not(Contains("OUT OF BALLS")));
}

}  // namespace
}  // namespace brittle::view
