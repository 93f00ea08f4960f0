#include <cstdio>
#include <utility>

#include "game/view/hud.h"
#include "game/view/hud_parts.h"

namespace brittle::view {
namespace {

// Layout, chosen by eye: room for numbers of four digits. [picture heights]
constexpr float kLeft = 0.03f, kTop = 0.04f, kLetter = 0.016f, kLine = 0.03f, kNumberRight = 0.29f, kMargin = 0.016f;
constexpr float kCountRight = 0.42f;

void addCell(float right, int line, render::HudAlign align, std::string text, render::Frame& frame) {
  const render::HudPoint at{Vec2::Zero(), Vec2(right, kTop + kLine * static_cast<float>(line))};
  frame.texts.push_back({at, kLetter, align, render::packRgba(hud::kInk, 0.9f), std::move(text)});
}

}  // namespace

void addTimings(const Timings& timings, render::Frame& frame) {
  constexpr int lines = 5;
  const Vec2 size(kNumberRight + 2.0f * kMargin, kLine * (lines - 1) + kLetter + 2.0f * kMargin);
  const Vec2 center(kLeft + 0.5f * kNumberRight, kTop + 0.5f * kLine * (lines - 1));
  frame.quads.push_back({{Vec2::Zero(), center}, size, render::packRgba(render::Rgb::Zero(), 0.45f), kMargin});
  int line = 0;
  for (const auto& [name, value] :
       {std::pair("frame", timings.frame), std::pair("longest", timings.longest),
        std::pair("simulate", timings.simulate), std::pair("draw", timings.draw), std::pair("swap", timings.swap)}) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f ms", static_cast<double>(value));
    addCell(kLeft, line, render::HudAlign::Left, name, frame);
    addCell(kLeft + kNumberRight, line++, render::HudAlign::Right, text, frame);
  }
}

void addRunning(const sim::FramePacket& packet, render::Frame& frame) {
  int line = 6;  // the table has five, and one between
  for (std::size_t i = 0; i < effects::kEffects; ++i)
    if (const auto effect = static_cast<effects::Effect>(i); packet.runs(effect))
      addCell(kLeft, line++, render::HudAlign::Left, effects::nameOf(effect), frame);
}

void addOmissions(const std::vector<NamedCount>& counts, render::Frame& frame) {
  constexpr float left = kLeft + kNumberRight + 4.0f * kMargin;
  if (counts.empty()) return;
  addCell(left, 0, render::HudAlign::Left, "left out since the start", frame);
  int line = 1;
  for (const NamedCount& one : counts) {
    addCell(left, line, render::HudAlign::Left, one.name, frame);
    addCell(left + kCountRight, line++, render::HudAlign::Right, std::to_string(one.count), frame);
  }
}

}  // namespace brittle::view
