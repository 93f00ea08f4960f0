#include "tools/brittle/options.h"

#include <cstdio>

#include "tools/brittle/interrupt.h"

namespace brittle::program {
namespace {

constexpr int kLargestSide = 16384;                // of a texture everywhere the program runs [pixels]
constexpr long long kLargestArea = 7680 * 4320LL;  // [pixels]: 1.6 GB of framebuffers with multisampling

}  // namespace

Result<Size> parseSize(const std::string& text) {
  const std::size_t x = text.find('x');
  Size size;
  const bool read = x != std::string::npos && readWhole(std::string_view(text).substr(0, x), size.width) &&
                    readWhole(std::string_view(text).substr(x + 1), size.height);
  const bool fits = size.width >= 1 && size.height >= 1 && size.width <= kLargestSide && size.height <= kLargestSide;
  if (!read || !fits)
    return Error{"--size " + text + ": expected WIDTHxHEIGHT, each from 1 to " + std::to_string(kLargestSide) +
                 ", like 640x360"};
  if (1LL * size.width * size.height > kLargestArea)
    return Error{"--size " + text + ": expected at most " + std::to_string(kLargestArea) + " pixels, like 7680x4320"};
  return size;
}

Result<FrameRange> parseFrames(const std::string& text) {
  const std::size_t dots = text.find("..");
  FrameRange range;
  const bool read = dots == std::string::npos ? readWhole(text, range.first) && readWhole(text, range.last)
                                              : readWhole(std::string_view(text).substr(0, dots), range.first) &&
                                                    readWhole(std::string_view(text).substr(dots + 2), range.last);
  if (!read) return Error{"--frames " + text + ": expected FIRST..LAST in ticks, like 600..900"};
  if (range.last < range.first)
    return Error{"--frames " + text + ": ends before it begins; expected FIRST..LAST, like " +
                 std::to_string(range.last) + ".." + std::to_string(range.first)};
  return range;
}

Error interruption() {
  return {"interrupted"};
}

void complain(const Error& error) {
  std::fprintf(stderr, "brittle: %s\n", asOneLine(error.message).c_str());
}

int refuse(const Error& error) {
  complain(isInterrupted() ? interruption() : error);
  return isInterrupted() ? kInterrupted : kWrongInput;
}

}  // namespace brittle::program
