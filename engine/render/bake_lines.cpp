#include "engine/render/bake_lines.h"

#include <algorithm>
#include <cmath>

#include "engine/render/bake.h"

namespace brittle::render {

namespace {

constexpr float kSame = 1e-3f;     // lines this close are one [m]
constexpr float kApart = 0.09f;    // lines that only refine keep this distance from all others [m]
constexpr float kTouching = 0.3f;  // a box this near to a face shades it about its own outline [m]
// Distances from an outline at which shade is sampled: it falls off steeply first [m]. Chosen by eye.
constexpr float kSteps[] = {-1.1f, -0.45f, -0.15f, 0.15f, 0.45f, 1.1f};

struct Lines {
  std::vector<float> exact;   // tiles and outlines
  std::vector<float> refine;  // wished for where there is room
};

void addOutline(const FaceSide& side, const Aabb& box, float length, Lines& lines) {
  for (const float edge : {box.low[side.along], box.high[side.along]}) {
    const float at = edge - side.face.low[side.along];
    if (at > -kSame && at < length + kSame) lines.exact.push_back(at);
    for (const float step : kSteps) lines.refine.push_back(at + step);
  }
}

std::vector<float> merged(std::vector<float> sorted, float apart) {
  std::sort(sorted.begin(), sorted.end());
  std::vector<float> kept;
  for (const float line : sorted)
    if (kept.empty() || line - kept.back() > apart) kept.push_back(line);
  return kept;
}

/// Of the wishes, those that lie between the lines with room on both sides.
std::vector<float> refined(const std::vector<float>& exact, const std::vector<float>& wishes) {
  std::vector<float> lines = {exact.front()};
  auto wish = wishes.begin();
  for (std::size_t i = 1; i < exact.size(); ++i) {
    for (; wish != wishes.end() && *wish < exact[i]; ++wish)
      if (*wish - lines.back() > kApart && exact[i] - *wish > kApart) lines.push_back(*wish);
    lines.push_back(exact[i]);
  }
  return lines;
}

std::vector<float> withoutLongGaps(const std::vector<float>& lines) {
  std::vector<float> result = {lines.front()};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const float gap = lines[i] - lines[i - 1];
    const int parts = maxOf(static_cast<int>(std::ceil((gap - kSame) / kLongestQuad)), 1);
    for (int part = 1; part < parts; ++part)
      result.push_back(lines[i - 1] + gap * static_cast<float>(part) / static_cast<float>(parts));
    result.push_back(lines[i]);
  }
  return result;
}

}  // namespace

std::vector<float> cutLines(const FaceSide& side, std::span<const Aabb> near) {
  const float length = side.face.extent()[side.along];
  Lines lines;
  for (float at = 0.0f; at < length - kSame; at += side.tile) lines.exact.push_back(at);
  const Aabb touching = side.face.grownBy(kTouching);
  for (const Aabb& box : near)
    if (box.overlaps(touching)) addOutline(side, box, length, lines);
  lines.exact = merged(std::move(lines.exact), kSame);
  if (length - lines.exact.back() < kSame && lines.exact.size() > 1) lines.exact.pop_back();
  lines.exact.push_back(length);
  return withoutLongGaps(refined(lines.exact, merged(std::move(lines.refine), kApart)));
}

}  // namespace brittle::render
