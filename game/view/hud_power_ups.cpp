// The power-ups at the left of the HUD: a round sign for each kind with how many there are, what is left of one that
// runs as a pie about it, and its colour along the picture's border.
#include <cmath>

#include "game/view/hud.h"
#include "game/view/hud_parts.h"
#include "game/view/power_ups.h"

namespace brittle::view {
namespace hud {
namespace {

using render::HudPoint;
using render::packRgba;
using sim::PowerUp;

// Layout, chosen by eye: above the progress bar, so that a narrow picture has room for both. [HUD heights]
constexpr float kFirst = 0.082f, kStep = 0.118f, kUp = 0.165f;
constexpr float kSign = 0.046f;  // radius
constexpr float kTouch = 0.5f * kStep;
constexpr float kArrivalTicks = 24.0f;
constexpr float kLastQuarter = 0.25f;
constexpr float kBlinkTicks = 16.0f;
constexpr float kColourTicks = 50.0f;  // a colour of the border stays so long where several run

HudPoint placeOf(std::size_t place) {
  return {Vec2(0.0f, 1.0f), Vec2(kFirst + kStep * static_cast<float>(place), -kUp)};
}

HudPoint moved(HudPoint at, float right, float down) {
  at.offset += Vec2(right, down);
  return at;
}

/// 1, and by turns less where it is about to end.
float blinkOf(const sim::PowerUpView& held, double tick) {
  const bool isEnding = held.runs && held.left < kLastQuarter;
  return isEnding && std::fmod(tick, static_cast<double>(kBlinkTicks)) > 0.55 * static_cast<double>(kBlinkTicks) ? 0.25f
                                                                                                                 : 1.0f;
}

struct Brush {
  HudPoint at;
  float radius;
  render::Rgb color;
  float alpha;
  render::Frame& frame;

  void arc(float inner, float outer, float from, float to, float strength = 1.0f) {
    frame.arcs.push_back({at, inner * radius, outer * radius, from, to, packRgba(color, alpha * strength)});
  }
  void box(float right, float down, float width, float height, float corner, float strength = 1.0f) {
    frame.quads.push_back({moved(at, right * radius, down * radius), Vec2(width, height) * radius,
                           packRgba(color, alpha * strength), corner * radius});
  }
};

void addClock(Brush brush) {
  brush.arc(0.50f, 0.60f, 0.0f, 1.0f);
  brush.box(0.0f, -0.16f, 0.09f, 0.40f, 0.045f);
  brush.box(0.13f, 0.0f, 0.34f, 0.09f, 0.045f);
}

void addBurst(Brush brush) {
  constexpr int kRays = 8;
  for (int i = 0; i < kRays; ++i) {
    const float middle = (static_cast<float>(i) + 0.5f) / kRays;
    const bool isLong = i % 2 == 0;
    brush.arc(0.30f, isLong ? 0.66f : 0.50f, middle - 0.20f / kRays, middle + 0.20f / kRays);
  }
  brush.arc(0.0f, 0.20f, 0.0f, 1.0f);
}

void addBarrel(Brush brush) {
  brush.box(0.0f, 0.0f, 0.66f, 0.92f, 0.20f);
  Brush dark = brush;
  dark.color = render::Rgb(0.05f, 0.03f, 0.03f);
  for (const float down : {-0.26f, 0.26f}) dark.box(0.0f, down, 0.70f, 0.07f, 0.0f, 0.8f);
}

void addThreeBalls(Brush brush) {
  constexpr float kPlaces[][2] = {{0.0f, -0.30f}, {-0.30f, 0.22f}, {0.30f, 0.22f}};
  for (const auto& place : kPlaces)
    addBall(moved(brush.at, place[0] * brush.radius, place[1] * brush.radius), 0.235f * brush.radius, brush.alpha,
            brush.frame);
}

void addGlyph(PowerUp kind, const Brush& brush) {
  switch (kind) {
    case PowerUp::BallFrenzy:
      return addThreeBalls(brush);
    case PowerUp::SlowMotion:
      return addClock(brush);
    case PowerUp::NitroBalls:
      return addBurst(brush);
    default:
      return addBarrel(brush);
  }
}

void addHeld(const sim::PowerUpView& held, std::size_t place, float pulse, double tick, render::Frame& frame) {
  const float blink = blinkOf(held, tick);
  Brush brush{placeOf(place), kSign * (1.0f + 0.22f * pulse), colorOf(held.kind), 1.0f, frame};
  const float diameter = 2.0f * brush.radius;
  frame.quads.push_back({brush.at, Vec2(diameter, diameter), packRgba({0.03f, 0.05f, 0.08f}, 0.62f), brush.radius});
  const bool isHeld = held.count > 0;
  if (held.runs) {
    brush.arc(0.0f, 0.86f, 0.0f, held.left, 0.30f * blink);
    brush.arc(0.88f, 1.0f, 0.0f, held.left, blink);
  }
  brush.arc(0.90f, 0.97f, 0.0f, 1.0f, isHeld ? 0.85f : 0.25f);
  brush.alpha = isHeld || held.runs ? blink : 0.4f;
  addGlyph(held.kind, brush);
  if (!isHeld) return;
  render::HudText count{moved(brush.at, 0.80f * brush.radius, 0.78f * brush.radius), 0.024f, render::HudAlign::Center,
                        packRgba(kInk), number("%d", held.count)};
  count.stroke = 0.14f;
  frame.arcs.push_back({count.at, 0.0f, 0.020f, 0.0f, 1.0f, packRgba({0.03f, 0.05f, 0.08f}, 0.85f)});
  frame.texts.push_back(count);
}

}  // namespace

HudPoint signOf(const sim::Hud& hud, PowerUp kind) {
  for (std::size_t i = 0; i < hud.powerUps.size(); ++i)
    if (hud.powerUps[i].kind == kind) return placeOf(i);
  return placeOf(0);
}

void addPowerUpSigns(const sim::Hud& hud, const Memory& memory, double tick, render::Frame& frame) {
  for (std::size_t i = 0; i < hud.powerUps.size(); ++i) {
    float pulse = 0.0f;
    for (const Remembered& r : memory.events()) {
      const float age = static_cast<float>(tick - static_cast<double>(r.tick)) - kTakenTicks;
      const bool isOwn = r.event.value == static_cast<std::int32_t>(hud.powerUps[i].kind);
      if (r.event.type == sim::EventType::PowerUpCollected && isOwn && age >= 0.0f)
        pulse = maxOf(pulse, 1.0f - age / kArrivalTicks);
    }
    addHeld(hud.powerUps[i], i, pulse * pulse, tick, frame);
  }
}

/// Where several run the border goes from one colour to the next; pain covers them.
void addPowerUpBorder(const sim::Hud& hud, double tick, render::Frame& frame) {
  std::vector<const sim::PowerUpView*> running;
  for (const sim::PowerUpView& held : hud.powerUps)
    if (held.runs) running.push_back(&held);
  if (running.empty()) return;
  const double turn = std::fmod(tick / static_cast<double>(kColourTicks), static_cast<double>(running.size()));
  const auto place = static_cast<std::size_t>(turn);
  const sim::PowerUpView &from = *running[place % running.size()], &to = *running[(place + 1) % running.size()];
  const float way = softStep(0.7f, 1.0f, static_cast<float>(turn - std::floor(turn)));
  const render::Rgb color = colorOf(from.kind) + (colorOf(to.kind) - colorOf(from.kind)) * way;
  const float strength = blinkOf(from, tick) + (blinkOf(to, tick) - blinkOf(from, tick)) * way;
  const Vec4 own(color.x(), color.y(), color.z(), 0.40f * strength);
  const float pain = clampTo(hud.pain, 0.0f, 1.0f);
  frame.border = own + (frame.border - own) * pain;
}

}  // namespace hud

std::vector<TouchSpot> powerUpSpots(const sim::Hud& hud, float width, float height) {
  std::vector<TouchSpot> spots;
  if (hud.phase != sim::Phase::Playing) return spots;
  const float unit = minOf(height, width / render::kHudWidth);
  for (std::size_t i = 0; i < hud.powerUps.size(); ++i) {
    const render::HudPoint at = hud::placeOf(i);
    const float x = at.anchor.x() * width + at.offset.x() * unit, y = at.anchor.y() * height + at.offset.y() * unit;
    const float half = hud::kTouch * unit;
    spots.push_back({x - half, y - half, x + half, y + half});
  }
  return spots;
}

}  // namespace brittle::view
