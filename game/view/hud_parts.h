// view/hud_parts.h - what the files of the HUD share: where the counter is, its colours, a ball, a line of text.
#pragma once

#include <string>

#include "game/view/memory.h"

namespace brittle::view::hud {

inline const render::Rgb kInk(1.0f, 1.0f, 1.0f), kWarm(1.0f, 0.84f, 0.45f), kAlarm(1.0f, 0.36f, 0.28f);

inline constexpr float kCountDown = 0.102f;  // the ball count's centre below the top [HUD heights]
inline constexpr float kBallRadius = 0.0105f;

inline render::HudPoint topCentre(float right, float down) {
  return {Vec2(0.5f, 0.0f), Vec2(right, down)};
}
/// A place in the middle column, by fraction of the picture's height.
inline render::HudPoint middle(float down) {
  return {Vec2(0.5f, down), Vec2::Zero()};
}

/// 0 before `from`, 1 from `to` on, and a soft step between.
inline float softStep(float from, float to, float value) {
  const float t = clampTo((value - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

std::string number(const char* format, int value);
/// A ball as an icon, `radius` in HUD heights.
void addBall(const render::HudPoint& at, float radius, float alpha, render::Frame& frame);
/// A centred line with wide letters.
void addSign(const render::HudPoint& at, float height, const render::Rgb& color, float alpha, std::string text,
             render::Frame& frame);

inline constexpr float kTakenTicks = 34.0f;  // a power-up that was collected flies to its sign so long

// The parts of addHud that have files of their own.
void addScreens(const sim::FramePacket& packet, const Memory& memory, double tick, render::Frame& frame);
/// In place of the screens: play has stopped, and goes on at a touch.
void addPause(render::Frame& frame);
void addPowerUpSigns(const sim::Hud& hud, const Memory& memory, double tick, render::Frame& frame);
void addPowerUpBorder(const sim::Hud& hud, double tick, render::Frame& frame);
/// Where the sign of a kind is, or would be.
render::HudPoint signOf(const sim::Hud& hud, sim::PowerUp kind);
void addFlights(const sim::FramePacket& packet, const Memory& memory, double tick, float aspect, render::Frame& frame);

}  // namespace brittle::view::hud
