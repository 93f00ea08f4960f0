#include "engine/render/bake_shade.h"

#include <cmath>

namespace brittle::render {

namespace {

constexpr float kTolerance = 3.0f;  // of 255; a step that cannot be seen
constexpr float kOnLine = 1e-3f;    // [m]

float byteOf(std::uint32_t color, int shift) {
  return static_cast<float>(color >> shift & 0xffu);
}

/// Whether the colours of a patch are those between its corners.
class Even {
 public:
  Even(const Shade& shade, const Patch& p)
      : shade_(shade),
        patch_(p),
        corners_{shade.at(p.left, p.low), shade.at(p.right, p.low), shade.at(p.left, p.high),
                 shade.at(p.right, p.high)} {}

  bool holds() const {
    for (std::size_t j = patch_.low; j <= patch_.high; ++j)
      for (std::size_t i = patch_.left; i <= patch_.right; ++i)
        if (!holdsAt(i, j)) return false;
    return true;
  }

 private:
  bool holdsAt(std::size_t i, std::size_t j) const {
    const Shade& s = shade_;
    const float x = (s.us[i] - s.us[patch_.left]) / (s.us[patch_.right] - s.us[patch_.left]);
    const float y = (s.vs[j] - s.vs[patch_.low]) / (s.vs[patch_.high] - s.vs[patch_.low]);
    for (int shift = 0; shift < 32; shift += 8) {
      const float low = byteOf(corners_[0], shift) * (1.0f - x) + byteOf(corners_[1], shift) * x;
      const float high = byteOf(corners_[2], shift) * (1.0f - x) + byteOf(corners_[3], shift) * x;
      if (std::fabs(byteOf(s.at(i, j), shift) - (low * (1.0f - y) + high * y)) > kTolerance) return false;
    }
    return true;
  }

  const Shade& shade_;
  Patch patch_;
  std::uint32_t corners_[4];
};

/// Which cells of a patch are taken already.
class Cells {
 public:
  explicit Cells(const Patch& whole)
      : whole_(whole), taken_((whole.right - whole.left) * (whole.high - whole.low), false) {}

  bool isFree(const Patch& p) const {
    for (std::size_t j = p.low; j < p.high; ++j)
      for (std::size_t i = p.left; i < p.right; ++i)
        if (taken_[indexOf(i, j)]) return false;
    return true;
  }
  void take(const Patch& p) {
    for (std::size_t j = p.low; j < p.high; ++j)
      for (std::size_t i = p.left; i < p.right; ++i) taken_[indexOf(i, j)] = true;
  }

 private:
  std::size_t indexOf(std::size_t i, std::size_t j) const {
    return (j - whole_.low) * (whole_.right - whole_.left) + i - whole_.left;
  }

  Patch whole_;
  std::vector<bool> taken_;
};

}  // namespace

std::vector<Patch> evenPatches(const Shade& shade, const Patch& whole) {
  std::vector<Patch> patches;
  Cells cells(whole);
  for (std::size_t j = whole.low; j < whole.high; ++j) {
    for (std::size_t i = whole.left; i < whole.right; ++i) {
      Patch patch{i, i + 1, j, j + 1};
      if (!cells.isFree(patch)) continue;
      const auto mayBe = [&](const Patch& p) { return cells.isFree(p) && Even(shade, p).holds(); };
      while (patch.right < whole.right && mayBe({i, patch.right + 1, j, patch.high})) ++patch.right;
      while (patch.high < whole.high && mayBe({i, patch.right, j, patch.high + 1})) ++patch.high;
      cells.take(patch);
      patches.push_back(patch);
    }
  }
  return patches;
}

std::vector<std::size_t> tileLines(const std::vector<float>& lines, float tile) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool isTileLine = std::fabs(lines[i] - std::round(lines[i] / tile) * tile) < kOnLine;
    if (i == 0 || i + 1 == lines.size() || isTileLine) indices.push_back(i);
  }
  return indices;
}

}  // namespace brittle::render
