#include "game/view/hud.h"

#include <cstdio>

namespace brittle::view {
namespace {

using render::HudAlign;
using render::HudPoint;
using render::packRgba;

// Layout, chosen by eye. [picture heights]
constexpr float kCountDown = 0.105f;  // the ball count's centre below the top
constexpr float kCountHeight = 0.062f;
constexpr float kRingInner = 0.082f, kRingOuter = 0.090f;
constexpr float kBarWidth = 0.62f, kBarThickness = 0.007f;
constexpr int kStreakTurn = 10;       // a full ring is this many crystals in a row
constexpr float kHintTicks = 170.0f;  // the hint goes after this, or with the first throw

const render::Rgb kInk(1.0f, 1.0f, 1.0f), kWarm(1.0f, 0.82f, 0.45f);

HudPoint top(float right, float down) {
  return {Vec2(0.5f, 0.0f), Vec2(right, down)};
}

std::string number(const char* format, int value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void addBalls(const sim::Hud& hud, float pulse, render::Frame& frame) {
  const render::Rgb color = hud.balls <= 5 ? kWarm : kInk;
  frame.texts.push_back({top(0.0f, kCountDown), kCountHeight * (1.0f + 0.22f * pulse), HudAlign::Center,
                         packRgba(color), number("%d", hud.balls)});
  frame.arcs.push_back({top(0.0f, kCountDown), kRingInner, kRingOuter, 0.0f, 1.0f, packRgba(kInk, 0.22f)});
  const float turn = static_cast<float>(hud.streak % kStreakTurn) / static_cast<float>(kStreakTurn);
  if (turn > 0.0f)
    frame.arcs.push_back({top(0.0f, kCountDown), kRingInner, kRingOuter, 0.0f, turn, packRgba(kWarm, 0.95f)});
  // A dot for each ball that leaves with one throw.
  const float first = -0.5f * static_cast<float>(hud.ballsPerThrow - 1);
  for (int i = 0; i < hud.ballsPerThrow; ++i)
    frame.arcs.push_back({top((first + static_cast<float>(i)) * 0.026f, kCountDown + kRingOuter + 0.026f), 0.0f,
                          0.0085f, 0.0f, 1.0f, packRgba(kInk, 0.9f)});
}

void addProgress(const sim::Hud& hud, render::Frame& frame) {
  const HudPoint bottom{Vec2(0.5f, 1.0f), Vec2(0.0f, -0.045f)};
  frame.quads.push_back({bottom, Vec2(kBarWidth, kBarThickness), packRgba(kInk, 0.22f)});
  const float done = clampTo(hud.roomProgress, 0.0f, 1.0f) * kBarWidth;
  if (done > 0.0f) {
    HudPoint at = bottom;
    at.offset.x() += 0.5f * (done - kBarWidth);
    frame.quads.push_back({at, Vec2(done, kBarThickness), packRgba(kInk, 0.9f)});
  }
  frame.texts.push_back({{Vec2(0.5f, 1.0f), Vec2(0.0f, -0.085f)},
                         0.030f,
                         HudAlign::Center,
                         packRgba(kInk, 0.95f),
                         number("%d m", static_cast<int>(hud.distance))});
}

void addEnd(const sim::Hud& hud, render::Frame& frame) {
  if (!hud.gameOver && !hud.levelDone) return;
  frame.tint = Vec4(0.04f, 0.06f, 0.10f, 0.55f);
  const HudPoint middle{Vec2(0.5f, 0.5f), Vec2::Zero()};
  frame.texts.push_back(
      {middle, 0.085f, HudAlign::Center, packRgba(kInk), hud.levelDone ? "LEVEL DONE" : "OUT OF BALLS"});
  HudPoint below = middle;
  below.offset.y() = 0.11f;
  frame.texts.push_back(
      {below, 0.040f, HudAlign::Center, packRgba(kWarm), number("%d m", static_cast<int>(hud.distance))});
}

/// While nothing was thrown yet. The memory reaches back to the start of the game for as long as this is shown.
void addHint(const sim::FramePacket& packet, const Memory& memory, double tick, render::Frame& frame) {
  const float out = clampTo((kHintTicks - static_cast<float>(tick)) / 20.0f, 0.0f, 1.0f);
  const float in = clampTo(static_cast<float>(tick) / 30.0f, 0.0f, 1.0f);
  const bool threw = memory.ageOf(sim::EventType::Throw, tick) < static_cast<float>(kMemoryTicks);
  if (out <= 0.0f || in <= 0.0f || threw || packet.hud.gameOver) return;
  frame.texts.push_back(
      {{Vec2(0.5f, 0.70f), Vec2::Zero()}, 0.042f, HudAlign::Center, packRgba(kInk, in * out), "TAP TO THROW"});
}

}  // namespace

void addHud(const sim::FramePacket& packet, const Memory& memory, double tick, render::Frame& frame) {
  const sim::Hud& hud = packet.hud;
  const float pulse = clampTo(1.0f - memory.ballsAge(tick) / 14.0f, 0.0f, 1.0f);
  addBalls(hud, pulse * pulse, frame);
  addProgress(hud, frame);
  addHint(packet, memory, tick, frame);
  addEnd(hud, frame);
  frame.border = Vec4(0.85f, 0.08f, 0.06f, 0.85f * clampTo(hud.pain, 0.0f, 1.0f));
  // The first instants of a crash light up the whole picture.
  const float flash = clampTo((hud.pain - 0.8f) * 5.0f, 0.0f, 1.0f);
  if (flash > 0.0f && !hud.gameOver) frame.tint = Vec4(1.0f, 0.85f, 0.80f, 0.45f * flash);
}

}  // namespace brittle::view
