#include "engine/render/tiles.h"

#include <cmath>

#include "engine/math/types.h"

namespace brittle::render {

namespace {

constexpr int kMipLevels = 7;  // 512 pixels to 8: one a tile

/// Distance from x to the next line of a grid with `lines` a unit. [units of the grid]
float toLine(float x, float lines) {
  const float f = x * lines - std::floor(x * lines);
  return minOf(f, 1.0f - f) / lines;
}

float groove(float distance, float width) {
  return clampTo(distance / width, 0.0f, 1.0f);
}

/// Repeatable noise in [0, 1] on a grid of `cells` a unit.
float speckle(float x, float y, int cells, int seed) {
  std::uint32_t h = static_cast<std::uint32_t>(seed) * 0x9e3779b9u +
                    static_cast<std::uint32_t>(x * static_cast<float>(cells)) * 0x85ebca6bu +
                    static_cast<std::uint32_t>(y * static_cast<float>(cells)) * 0xc2b2ae35u;
  h = (h ^ h >> 15) * 0x2c1b3c6du;
  h = (h ^ h >> 12) * 0x297a2d39u;
  return static_cast<float>((h ^ h >> 15) & 0xffffu) / 65535.0f;
}

float bricks(float x, float y, int rows) {
  const float row = std::floor(y * static_cast<float>(rows));
  const float shift = static_cast<float>(static_cast<int>(row) % 2) * 0.25f;
  return minOf(groove(toLine(x + shift, 2.0f), 0.03f), groove(toLine(y, static_cast<float>(rows)), 0.03f));
}

/// The pattern of a family at (x, y) in [0, 1): 1 is unchanged, 0 the darkest groove.
float pattern(int family, int variant, float x, float y) {
  const float n = static_cast<float>(variant + 1);
  switch (family) {
    case 0:
      return variant == 0 ? 1.0f : 1.0f - 0.2f * speckle(x, y, 16 << (variant % 3), variant);  // plain, grain
    case 1:
      return minOf(groove(toLine(x, n), 0.02f), groove(toLine(y, n), 0.02f));  // panels
    case 2:
      return groove(toLine(y, n), 0.03f);  // planks across
    case 3:
      return groove(toLine(x, n), 0.03f);  // planks upright
    case 4:
      return bricks(x, y, 2 * (variant + 1));  // bricks
    case 5:
      return groove(minOf(toLine(x + y, n), toLine(x - y + 1.0f, n)), 0.025f);  // diamonds
    case 6:
      return groove(std::fabs(std::hypot(x - 0.5f, y - 0.5f) - 0.06f * n), 0.03f);  // rings
    default:
      return 0.5f + 0.5f * std::cos(6.2831853f * n * (x + y)) * std::cos(6.2831853f * n * (x - y));  // weave
  }
}

}  // namespace

std::vector<std::uint8_t> paintTiles() {
  std::vector<std::uint8_t> grey(static_cast<std::size_t>(kAtlasPixels) * kAtlasPixels);
  for (int py = 0; py < kAtlasPixels; ++py) {
    for (int px = 0; px < kAtlasPixels; ++px) {
      const float x = (static_cast<float>(px % kTilePixels) + 0.5f) / kTilePixels;
      const float y = (static_cast<float>(py % kTilePixels) + 0.5f) / kTilePixels;
      const float value = 0.72f + 0.28f * pattern(py / kTilePixels, px / kTilePixels, x, y);
      grey[static_cast<std::size_t>(py) * kAtlasPixels + static_cast<std::size_t>(px)] =
          static_cast<std::uint8_t>(clampTo(value, 0.0f, 1.0f) * 255.0f + 0.5f);
    }
  }
  return grey;
}

GlTexture makeTileTexture(const Gl& gl) {
  return makeByteTexture(gl, kAtlasPixels, kAtlasPixels, kMipLevels, paintTiles());
}

}  // namespace brittle::render
