// render/capture.h - pictures in memory and as PNG files. Knows nothing of GL or scenes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/result.h"

namespace brittle::render {

/// RGBA8, sRGB-encoded, top row first.
struct Image {
  int width = 0, height = 0;         // [pixels]
  std::vector<std::uint8_t> pixels;  // width * height * 4

  const std::uint8_t* at(int x, int y) const { return &pixels[4u * (static_cast<std::size_t>(y) * width + x)]; }
};

/// Writes a PNG (RGB, the alpha is dropped) as core/file writes: never half a picture.
Status writePng(const Image& image, const std::string& path);
Result<Image> readPng(const std::string& path);

/// How two pictures of one size differ, over all colour bytes. [0, 255]
struct ImageDifference {
  int largest = 255;
  double mean = 255.0;
};
/// Pictures of different sizes differ by 255 everywhere.
ImageDifference compare(const Image& a, const Image& b);

}  // namespace brittle::render
