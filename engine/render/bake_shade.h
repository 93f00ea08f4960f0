// render/bake_shade.h - the colours at the crossings of a face's lines, and the largest rectangles between them that
// are evenly coloured. Pure.
#pragma once

#include <cstdint>
#include <vector>

namespace brittle::render {

struct Shade {
  std::vector<float> us, vs;          // lines across and along [m], rising from 0
  std::vector<std::uint32_t> colors;  // by row of v

  std::uint32_t at(std::size_t i, std::size_t j) const { return colors[j * us.size() + i]; }
};

/// Part of a face, by its lines.
struct Patch {
  std::size_t left, right, low, high;
};

/// Rectangles that fill `whole`, each as wide and then as high as its colours, taken from its corners, are right to
/// within 3 of 255.
std::vector<Patch> evenPatches(const Shade& shade, const Patch& whole);

/// Where whole tiles begin and end: indices of the lines at multiples of `tile` [m], of the first and of the last.
std::vector<std::size_t> tileLines(const std::vector<float>& lines, float tile);

}  // namespace brittle::render
