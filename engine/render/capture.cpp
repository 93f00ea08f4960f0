#include "engine/render/capture.h"

#include "engine/core/file.h"
#include "engine/math/types.h"

#include <stb_image.h>
#include <stb_image_write.h>

namespace brittle::render {

namespace {

void append(void* context, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(context);
  const auto* first = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), first, first + size);
}

std::vector<std::uint8_t> withoutAlpha(const Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.pixels.size() / 4 * 3);
  for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
    rgb.insert(rgb.end(), image.pixels.begin() + static_cast<std::ptrdiff_t>(i),
               image.pixels.begin() + static_cast<std::ptrdiff_t>(i) + 3);
  }
  return rgb;
}

}  // namespace

Status writePng(const Image& image, const std::string& path) {
  if (image.width <= 0 || image.height <= 0) return errorAt(path, 0, "an empty picture cannot be written");
  const std::vector<std::uint8_t> rgb = withoutAlpha(image);
  std::vector<std::uint8_t> png;
  if (stbi_write_png_to_func(append, &png, image.width, image.height, 3, rgb.data(), image.width * 3) == 0)
    return errorAt(path, 0, "no memory to compress the picture");
  return writeFile(path, png);
}

Result<Image> readPng(const std::string& path) {
  Image image;
  int channels = 0;
  std::uint8_t* pixels = stbi_load(path.c_str(), &image.width, &image.height, &channels, 4);
  if (pixels == nullptr) return Error{path + ": not a readable PNG: " + stbi_failure_reason()};
  image.pixels.assign(pixels,
                      pixels + 4u * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  stbi_image_free(pixels);
  return image;
}

ImageDifference compare(const Image& a, const Image& b) {
  ImageDifference result;
  if (a.width != b.width || a.height != b.height || a.pixels.empty()) return result;
  result.largest = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    const int difference = a.pixels[i] < b.pixels[i] ? b.pixels[i] - a.pixels[i] : a.pixels[i] - b.pixels[i];
    result.largest = maxOf(result.largest, difference);
    sum += difference;
  }
  result.mean = sum / (static_cast<double>(a.pixels.size()) / 4.0 * 3.0);
  return result;
}

}  // namespace brittle::render
