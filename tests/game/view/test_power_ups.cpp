// Power-ups as they are seen: in the room, on the HUD, along the picture's border.
#include "game/view/power_ups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/view/hud.h"
#include "packets.h"

namespace brittle::view {
namespace {

using sim::PowerUp;

constexpr PowerUp kAll[] = {PowerUp::BallFrenzy, PowerUp::SlowMotion, PowerUp::NitroBalls, PowerUp::Barrel};

render::Frame hudOf(const sim::FramePacket& packet, const Memory& memory = {}) {
  render::Frame frame;
  addHud(packet, memory, static_cast<double>(packet.tick), 16.0f / 9.0f, frame);
  return frame;
}

sim::FramePacket holding(std::vector<sim::PowerUpView> powerUps, std::uint64_t tick = 1000) {
  sim::FramePacket packet = packetAt(tick);
  packet.hud.phaseTicks = 1000;
  packet.hud.powerUps = std::move(powerUps);
  return packet;
}

TEST(PowerUpHud, WithoutAnyNothingIsAdded) {
  const render::Frame frame = hudOf(holding({}));
  EXPECT_EQ(frame.border.w(), 0.0f);
  for (const render::HudArc& arc : frame.arcs) EXPECT_EQ(arc.at.anchor.x(), 0.5f);
  EXPECT_TRUE(powerUpSpots(holding({}).hud, 1280.0f, 720.0f).empty());
}

TEST(PowerUpHud, EachKindShowsItsNumberAtTheLeft) {
  const render::Frame frame = hudOf(
      holding({{PowerUp::BallFrenzy, 2}, {PowerUp::SlowMotion, 3}, {PowerUp::NitroBalls, 4}, {PowerUp::Barrel, 9}}));
  std::vector<std::string> numbers;
  for (const render::HudText& text : frame.texts)
    if (text.at.anchor == Vec2(0.0f, 1.0f)) numbers.push_back(text.text);
  EXPECT_THAT(numbers, ::testing::ElementsAre("2", "3", "4", "9"));
}

// A pie of what is left: from the top, clockwise, as far as there is time.
TEST(PowerUpHud, WhatRunsHasAPieOfItsRest) {
  for (const float left : {1.0f, 0.6f, 0.3f}) {
    const render::Frame frame = hudOf(holding({{PowerUp::NitroBalls, 0, true, left}}));
    int pies = 0;
    for (const render::HudArc& arc : frame.arcs)
      pies += arc.at.anchor.x() == 0.0f && arc.from == 0.0f && arc.to == left && arc.outer > 0.04f ? 1 : 0;
    EXPECT_GE(pies, 1) << left;
  }
}

TEST(PowerUpHud, TheBorderHasTheColourOfWhatRuns) {
  const auto border = [](PowerUp kind) { return hudOf(holding({{kind, 0, true, 0.9f}})).border; };
  const Vec4 frenzy = border(PowerUp::BallFrenzy), slow = border(PowerUp::SlowMotion),
             nitro = border(PowerUp::NitroBalls);
  EXPECT_GT(frenzy.y(), frenzy.x() + 0.3f) << "green";
  EXPECT_GT(slow.x(), slow.y() + 0.3f) << "magenta";
  EXPECT_GT(slow.z(), slow.y() + 0.3f);
  EXPECT_GT(minOf(nitro.x(), nitro.y()), nitro.z() + 0.3f) << "yellow";
  EXPECT_EQ(hudOf(holding({{PowerUp::NitroBalls, 3}})).border.w(), 0.0f) << "held, not used";
}

TEST(PowerUpHud, ItBlinksInTheLastQuarterOnly) {
  for (const float left : {0.5f, 0.26f, 0.24f, 0.05f}) {
    std::set<float> strengths;
    for (std::uint64_t tick = 1000; tick < 1032; ++tick)
      strengths.insert(hudOf(holding({{PowerUp::SlowMotion, 0, true, left}}, tick)).border.w());
    EXPECT_EQ(strengths.size() > 1, left < 0.25f) << left;
  }
}

TEST(PowerUpHud, PainCoversTheBorder) {
  sim::FramePacket packet = holding({{PowerUp::BallFrenzy, 0, true, 0.9f}});
  packet.hud.pain = 1.0f;
  const Vec4 border = hudOf(packet).border;
  EXPECT_GT(border.x(), border.y() + 0.5f);
}

// What is touched is what is seen there, at any size.
TEST(PowerUpHud, TouchesMeetTheSigns) {
  const sim::FramePacket packet = holding({{PowerUp::BallFrenzy, 1}, {PowerUp::Barrel, 1}});
  for (const Vec2& size : {Vec2(1280.0f, 720.0f), Vec2(400.0f, 800.0f)}) {
    const std::vector<TouchSpot> spots = powerUpSpots(packet.hud, size.x(), size.y());
    ASSERT_EQ(spots.size(), 2u);
    const float unit = minOf(size.y(), size.x() / render::kHudWidth);
    std::vector<Vec2> numbers;
    for (const render::HudText& text : hudOf(packet).texts)
      if (text.at.anchor.x() == 0.0f)
        numbers.push_back(Vec2(text.at.offset.x() * unit, size.y() + text.at.offset.y() * unit));
    ASSERT_EQ(numbers.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_TRUE(numbers[i].x() > spots[i].left && numbers[i].x() < spots[i].right);
      EXPECT_TRUE(numbers[i].y() > spots[i].top && numbers[i].y() < spots[i].bottom);
    }
    EXPECT_LE(spots[0].right, spots[1].left + 1e-3f) << "none is touched with the other";
    EXPECT_GE(spots[0].left, 0.0f);
  }
}

TEST(PowerUpHud, ThereIsNothingToTouchWhenPlayIsOver) {
  sim::FramePacket packet = holding({{PowerUp::BallFrenzy, 1}});
  packet.hud.phase = sim::Phase::GameOver;
  EXPECT_TRUE(powerUpSpots(packet.hud, 1280.0f, 720.0f).empty());
}

TEST(PowerUpLook, ColoursDiffer) {
  for (const PowerUp a : kAll)
    for (const PowerUp b : kAll) EXPECT_TRUE(a == b || (colorOf(a) - colorOf(b)).norm() > 0.25f);
}

TEST(PowerUpLook, WhatWaitsTurnsInItsPlaceByTheGamesTime) {
  sim::RoomView room;
  room.pickups.push_back({PowerUp::Barrel, 1, Vec3(0.0f, 1.0f, -5.0f)});
  const auto poseAt = [&room](double time) {
    std::vector<Transform> bodies(2);
    bodies[1].position = Vec3(0.0f, 1.0f, -5.0f);
    turnPickups(room, time, bodies);
    EXPECT_EQ(bodies[0].position, Vec3(Vec3::Zero())) << "nothing else does";
    EXPECT_LT((bodies[1].position - Vec3(0.0f, 1.0f, -5.0f)).norm(), 0.1f);
    return bodies[1];
  };
  EXPECT_EQ(poseAt(100.0).rotation.coeffs(), poseAt(100.0).rotation.coeffs());
  EXPECT_GT((poseAt(100.0).rotation.coeffs() - poseAt(130.0).rotation.coeffs()).norm(), 0.1f);
}

TEST(PowerUpLook, OnlyBallsWithAChargeShine) {
  sim::FramePacket packet = packetAt(10);
  packet.balls.push_back({1, {}, 0.13f, sim::Charge::None});
  render::Frame frame;
  addPowerUps(packet, 10.0, frame);
  EXPECT_TRUE(frame.glows.empty());
  EXPECT_EQ(tintOf(packet.balls[0]), render::kWhite);
  packet.balls[0].charge = sim::Charge::Nitro;
  addPowerUps(packet, 10.0, frame);
  EXPECT_FALSE(frame.glows.empty());
  EXPECT_NE(tintOf(packet.balls[0]), render::kWhite);
}

}  // namespace
}  // namespace brittle::view
