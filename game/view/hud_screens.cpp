// Signs in the middle of the picture: the title, hints, the last balls counted down, the room entered, how it ended.
#include <cmath>

#include "engine/render/text.h"
#include "game/view/hud_parts.h"

namespace brittle::view::hud {
namespace {

constexpr float kHintTicks = 170.0f;
constexpr float kSoon = 1000.0f;  // hints are for the beginning: up to this distance [level's units]
constexpr int kCountedDown = 10;  // fewer balls than these are shown large
constexpr float kCountTicks = 45.0f;
constexpr float kRoomTicks = 130.0f;
constexpr float kEndTicks = 60.0f;  // until the picture of an end is complete

/// 1 for `age` in the middle of a sign's life of `ticks`, rising and falling at its ends.
float shown(float age, float ticks) {
  return softStep(0.0f, 18.0f, age) * (1.0f - softStep(ticks - 30.0f, ticks, age));
}

float pulseOf(double tick) {
  return 0.72f + 0.28f * std::sin(static_cast<float>(std::fmod(tick, 7200.0)) * 0.08f);
}

void addTitle(float alpha, double tick, render::Frame& frame) {
  if (alpha <= 0.0f) return;
  frame.tint = Vec4(0.02f, 0.06f, 0.10f, 0.30f * alpha);
  render::HudText name{middle(0.37f - 0.04f * (1.0f - alpha)), 0.135f, render::HudAlign::Center,
                       render::packRgba(kInk, alpha), "BRITTLE"};
  name.stroke = 0.055f;
  name.spacing = 0.42f;
  frame.texts.push_back(name);
  frame.quads.push_back({middle(0.505f), Vec2(0.16f, 0.0025f), render::packRgba(kInk, 0.6f * alpha)});
  addSign(middle(0.575f), 0.030f, kInk, alpha * pulseOf(tick), "TAP TO BEGIN", frame);
}

struct Hint {
  std::string text;
  float alpha = 0.0f;
};

/// The first that applies. Each depends on what the packet and the last kMemoryTicks say, so it may come again.
Hint hintOf(const sim::FramePacket& packet, const Memory& memory, double tick) {
  const sim::Hud& hud = packet.hud;
  const auto age = [&](sim::EventType type) { return memory.ageOf(type, tick); };
  const float phaseAge =
      static_cast<float>(hud.phaseTicks) + static_cast<float>(tick - static_cast<double>(packet.tick));
  constexpr float kLong = static_cast<float>(kMemoryTicks);
  if (hud.distance > kSoon) return {};
  if (age(sim::EventType::Crash) < kHintTicks)
    return {"BREAK WHAT IS IN YOUR WAY", shown(age(sim::EventType::Crash), kHintTicks)};
  if (age(sim::EventType::PowerUpCollected) < kHintTicks && !hud.powerUps.empty() && !hud.powerUps.front().runs)
    return {"TAP ITS SIGN TO USE IT", shown(age(sim::EventType::PowerUpCollected), kHintTicks)};
  if (age(sim::EventType::Multiball) < kHintTicks && hud.ballsPerThrow > 1)
    return {number("%d BALLS WITH EVERY THROW", hud.ballsPerThrow), shown(age(sim::EventType::Multiball), kHintTicks)};
  if (hud.countsBalls && hud.balls <= 5 && memory.ballsChange() < 0 && memory.ballsAge(tick) < kHintTicks)
    return {"CRYSTALS GIVE YOU BALLS", shown(memory.ballsAge(tick), kHintTicks)};
  if (hud.room > 0) return {};
  if (phaseAge < kHintTicks && age(sim::EventType::Throw) >= kLong)
    return {"TAP TO THROW", shown(phaseAge, kHintTicks)};
  if (phaseAge >= kHintTicks && phaseAge < 3.0f * kHintTicks && hud.streak == 0 &&
      age(sim::EventType::Crystal) >= kLong)
    return {"AIM AT THE CRYSTALS", shown(phaseAge - kHintTicks, 2.0f * kHintTicks)};
  return {};
}

void addHint(const Hint& hint, render::Frame& frame) {
  if (hint.alpha <= 0.0f) return;
  addSign(middle(0.745f), 0.027f, kInk, hint.alpha, hint.text, frame);
}

/// The number of the last balls, large and going, as each leaves.
void addCountdown(const sim::Hud& hud, float age, render::Frame& frame) {
  if (!hud.countsBalls || hud.balls >= kCountedDown || age >= kCountTicks) return;
  const float left = 1.0f - age / kCountTicks;
  render::HudText digit{middle(0.45f), 0.30f * (1.15f - 0.15f * left), render::HudAlign::Center,
                        render::packRgba(hud.balls <= 3 ? kAlarm : kInk, 0.50f * left * left), number("%d", hud.balls)};
  digit.stroke = 0.06f;
  frame.texts.push_back(digit);
}

void addRoom(const sim::Hud& hud, float age, render::Frame& frame) {
  if (hud.room == 0 || age >= kRoomTicks) return;
  const float alpha = shown(age, kRoomTicks);
  frame.quads.push_back({middle(0.285f), Vec2(0.30f * alpha, 0.0025f), render::packRgba(kInk, 0.7f * alpha)});
  addSign(middle(0.325f), 0.034f, kInk, alpha, number("ROOM %d", hud.room + 1), frame);
}

/// A ball and how many there are, as one centred line.
void addCount(float down, int balls, float alpha, render::Frame& frame) {
  constexpr float height = 0.042f, radius = 0.021f, gap = 0.020f;
  const std::string text = number("%d", balls);
  const float left = -0.5f * (2.0f * radius + gap + height * render::textWidth(text));
  addBall({Vec2(0.5f, down), Vec2(left + radius, 0.0f)}, radius, alpha, frame);
  const render::HudPoint at{Vec2(0.5f, down), Vec2(left + 2.0f * radius + gap, 0.0f)};
  frame.texts.push_back({at, height, render::HudAlign::Left, render::packRgba(kInk, alpha), text});
}

/// How far it went, and the balls with which it goes on.
void addEnd(const sim::Hud& hud, float age, double tick, render::Frame& frame) {
  const bool isWon = hud.phase == sim::Phase::Checkpoint;
  const float in = softStep(0.0f, kEndTicks, age);
  frame.tint = isWon ? Vec4(0.03f, 0.10f, 0.16f, 0.42f * in) : Vec4(0.05f, 0.04f, 0.07f, 0.60f * in);
  addSign(middle(0.38f), 0.078f, kInk, in, isWon ? "CHECKPOINT" : "OUT OF BALLS", frame);
  frame.quads.push_back({middle(0.46f), Vec2(0.24f * in, 0.0025f), render::packRgba(kInk, 0.7f * in)});
  addSign(middle(0.525f), 0.042f, kWarm, in, number("%d m", static_cast<int>(hud.distance)), frame);
  if (hud.countsBalls && hud.checkpointBalls > 0) addCount(0.61f, hud.checkpointBalls, in, frame);
  const float later = softStep(kEndTicks, 1.5f * kEndTicks, age);
  addSign(middle(0.74f), 0.027f, kInk, later * pulseOf(tick), isWon ? "TAP TO GO ON" : "TAP TO TRY AGAIN", frame);
}

}  // namespace

void addPause(render::Frame& frame) {
  frame.tint = Vec4(0.03f, 0.06f, 0.10f, 0.45f);
  addSign(middle(0.45f), 0.078f, kInk, 1.0f, "PAUSED", frame);
  addSign(middle(0.56f), 0.027f, kInk, 0.8f, "TAP TO GO ON", frame);
}

void addScreens(const sim::FramePacket& packet, const Memory& memory, double tick, render::Frame& frame) {
  const sim::Hud& hud = packet.hud;
  const float phaseAge =
      static_cast<float>(hud.phaseTicks) + static_cast<float>(tick - static_cast<double>(packet.tick));
  if (hud.phase == sim::Phase::Title) return addTitle(softStep(0.0f, 40.0f, phaseAge), tick, frame);
  if (hud.phase != sim::Phase::Playing) return addEnd(hud, phaseAge, tick, frame);
  addTitle(1.0f - softStep(0.0f, 24.0f, memory.ageOf(sim::EventType::Begin, tick)), tick, frame);
  addHint(hintOf(packet, memory, tick), frame);
  addRoom(hud, memory.ageOf(sim::EventType::RoomEntered, tick), frame);
  if (memory.ballsChange() < 0) addCountdown(hud, memory.ballsAge(tick), frame);
}

}  // namespace brittle::view::hud
