// render/overlay.h - flat triangles on top of the finished picture: what a user interface is made of.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace brittle::render {

/// A corner of a triangle. The layout the overlay shader reads.
struct OverlayPoint {
  float x = 0.0f, y = 0.0f;  // from the picture's top left corner [pixels]
  float u = 0.0f, v = 0.0f;  // in the texture, [0, 1]
  std::uint32_t color = 0xffffffff;
};

/// A run of indices that is seen within a rectangle only. [pixels]
struct OverlayPart {
  int left = 0, top = 0, right = 0, bottom = 0;
  std::uint32_t first = 0, count = 0;  // of Overlay::indices
};

/// What the alpha of every triangle is multiplied by: letters, round corners.
struct OverlayTexture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> coverage;  // a byte a texel, top row first
};

struct Overlay {
  std::vector<OverlayPoint> points;
  std::vector<std::uint32_t> indices;  // triangles
  std::vector<OverlayPart> parts;      // drawn in this order
  std::shared_ptr<const OverlayTexture> texture;

  /// Empties the lists, keeping their memory; the texture stays.
  void clear();
};

}  // namespace brittle::render
