#include "game/view/hud.h"

#include <cstdio>

#include "engine/effects/has/explosions.h"
#include "game/view/hud_parts.h"
#include "game/view/power_ups.h"

namespace brittle::view {
namespace hud {

std::string number(const char* format, int value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void addBall(const render::HudPoint& at, float radius, float alpha, render::Frame& frame) {
  const auto disc = [&](float shift, float size, const render::Rgb& color, float strength) {
    render::HudPoint place = at;
    place.offset += Vec2(-shift, -shift) * radius;
    frame.arcs.push_back({place, 0.0f, size * radius, 0.0f, 1.0f, render::packRgba(color, strength * alpha)});
  };
  disc(0.0f, 1.22f, render::Rgb::Zero(), 0.18f);
  disc(0.0f, 1.0f, {0.60f, 0.65f, 0.72f}, 1.0f);
  disc(0.16f, 0.74f, {0.84f, 0.88f, 0.92f}, 1.0f);
  disc(0.34f, 0.30f, kInk, 1.0f);
}

void addSign(const render::HudPoint& at, float height, const render::Rgb& color, float alpha, std::string text,
             render::Frame& frame) {
  render::HudText line{at, height, render::HudAlign::Center, render::packRgba(color, alpha), std::move(text)};
  line.stroke = 0.11f;
  line.spacing = 0.16f;
  frame.texts.push_back(line);
}

}  // namespace hud

namespace {

using namespace hud;
using render::packRgba;

// Layout, chosen by eye. [HUD heights]
constexpr float kCountHeight = 0.056f;
constexpr float kRingInner = 0.0790f, kRingOuter = 0.0845f;
constexpr float kRingGap = 0.012f;  // between two parts of the ring [turns]
constexpr float kBarWidth = 0.60f, kBarThickness = 0.006f, kBarGap = 0.010f;
constexpr int kStreakTurn = 10;  // a full ring is this many crystals in a row
constexpr int kFewBalls = 5;
constexpr float kPulseTicks = 16.0f, kLostTicks = 40.0f;

/// A part for each crystal until the next ball of a throw: warm when it is won.
void addStreak(const sim::Hud& hud, float lost, render::Frame& frame) {
  const int won = hud.streak % kStreakTurn;
  for (int i = 0; i < kStreakTurn; ++i) {
    const float from = (static_cast<float>(i) + 0.5f * kRingGap * kStreakTurn) / kStreakTurn;
    const float to = (static_cast<float>(i + 1) - 0.5f * kRingGap * kStreakTurn) / kStreakTurn;
    const render::Rgb empty = kInk + (kAlarm - kInk) * lost;
    const std::uint32_t color = i < won ? packRgba(kWarm, 0.95f) : packRgba(empty, 0.25f + 0.5f * lost);
    frame.arcs.push_back({topCentre(0.0f, kCountDown), kRingInner, kRingOuter, from, to, color});
  }
}

void addBalls(const sim::Hud& hud, float pulse, render::Frame& frame) {
  const render::Rgb color = hud.balls <= kFewBalls ? kWarm : kInk;
  render::HudText count{topCentre(0.0f, kCountDown), kCountHeight * (1.0f + 0.20f * pulse), render::HudAlign::Center,
                        packRgba(color), number("%d", hud.balls)};
  count.stroke = 0.115f;
  frame.texts.push_back(count);
  // A ball for each that leaves with one throw.
  const float first = -0.5f * static_cast<float>(hud.ballsPerThrow - 1);
  for (int i = 0; i < hud.ballsPerThrow; ++i)
    addBall(topCentre((first + static_cast<float>(i)) * 0.030f, kCountDown + kRingOuter + 0.028f), kBallRadius, 1.0f,
            frame);
}

/// A part for each room of the level, filled as far as they are passed.
void addProgress(const sim::Hud& hud, render::Frame& frame) {
  const int rooms = clampTo(hud.rooms, 1, 20);
  const float width = (kBarWidth + kBarGap) / static_cast<float>(rooms) - kBarGap;
  for (int i = 0; i < rooms; ++i) {
    const float left = static_cast<float>(i) * (width + kBarGap) - 0.5f * kBarWidth;
    const float done = i < hud.room ? 1.0f : i == hud.room ? clampTo(hud.roomProgress, 0.0f, 1.0f) : 0.0f;
    const auto bar = [&](float length, float alpha) {
      const render::HudPoint at{Vec2(0.5f, 1.0f), Vec2(left + 0.5f * length, -0.040f)};
      frame.quads.push_back({at, Vec2(length, kBarThickness), packRgba(kInk, alpha), 0.5f * kBarThickness});
    };
    bar(width, 0.25f);
    if (done > 0.0f) bar(maxOf(done * width, kBarThickness), 0.95f);
  }
  render::HudText text{{Vec2(0.5f, 1.0f), Vec2(0.0f, -0.078f)},
                       0.028f,
                       render::HudAlign::Center,
                       packRgba(kInk, 0.95f),
                       number("%d m", static_cast<int>(hud.distance))};
  text.spacing = 0.08f;
  frame.texts.push_back(text);
}

/// A blast lights up the picture for an instant.
void addGlare(const sim::FramePacket& packet, const Memory& memory, double tick, render::Frame& frame) {
  float glare = 0.0f;
  for (const Remembered& r : memory.events()) {
    const float age = static_cast<float>(tick - static_cast<double>(r.tick)) + 0.5f;
    if (r.event.type == sim::EventType::Explosion && age >= 0.0f)
      glare = maxOf(glare, glareOf(r.event, age, (r.pointIn(packet.originZ) - packet.camera.position).norm()));
  }
  if (glare > 0.0f) frame.tint = Vec4(1.0f, 0.90f, 0.72f, 0.5f * glare);
}

void addPain(const sim::Hud& hud, render::Frame& frame) {
  const float pain = clampTo(hud.pain, 0.0f, 1.0f);
  frame.border = Vec4(0.85f, 0.08f, 0.06f, 0.85f * pain);
  // The first instants of a crash light up the whole picture.
  const float flash = clampTo((pain - 0.8f) * 5.0f, 0.0f, 1.0f);
  if (flash > 0.0f) frame.tint = Vec4(1.0f, 0.85f, 0.80f, 0.45f * flash);
}

}  // namespace

void addHud(const sim::FramePacket& packet, const Memory& memory, double tick, float aspect, render::Frame& frame,
            bool paused) {
  const sim::Hud& hud = packet.hud;
  const float lost =
      1.0f -
      minOf(memory.ageOf(sim::EventType::CrystalMissed, tick), memory.ageOf(sim::EventType::Crash, tick)) / kLostTicks;
  const float pulse = clampTo(1.0f - memory.ballsAge(tick) / kPulseTicks, 0.0f, 1.0f);
  if constexpr (effects::kHasExplosions) addGlare(packet, memory, tick, frame);
  addPain(hud, frame);
  if (!hud.powerUps.empty()) addPowerUpBorder(hud, tick, frame);
  if (hud.phase == sim::Phase::Playing) {  // the end has its own signs for all of this
    if (hud.countsBalls) {
      addStreak(hud, clampTo(lost, 0.0f, 1.0f), frame);
      addBalls(hud, pulse * pulse, frame);
    }
    addProgress(hud, frame);
    addPowerUpSigns(hud, memory, tick, frame);
  }
  if (hud.phase != sim::Phase::Title) addFlights(packet, memory, tick, aspect, frame);
  if (paused)
    addPause(frame);
  else
    addScreens(packet, memory, tick, frame);
}

}  // namespace brittle::view
