#include "engine/render/text.h"

namespace brittle::render {

namespace {

constexpr int kStoredGlyphs = kGlyphRows - 26 - 1;  // small letters are capitals, the box is made below
constexpr float kSpacing = 3.4f;                    // between two characters [units]
constexpr float kSpace = 5.0f;                      // width of a space [units]
constexpr int kCurve = 6;                           // straight parts of a round corner

// Polylines separated by spaces; a point is two digits of base 13, x then y, y up. Two equal points are a dot.
constexpr std::string_view kFont[kStoredGlyphs] = {
    // space to /
    "",
    "4c45 4040",
    "2c29 6c69",
    "202c 606c 0484 0888",
    "8a6c2c0a0826668482602002 4c40",
    "008c 0c2c2a0a0c 6282806062",
    "80080a2c4c5a580402204084",
    "4c49",
    "6c494360",
    "2c494320",
    "424a 0884 0488",
    "424a 0686",
    "1200",
    "1676",
    "0000",
    "008c",
    // 0 to 9
    "20020a2c6c8a826020",
    "194c40",
    "0a2c6c8a870080",
    "0a2c6c8a886636 668482602002",
    "606c0383",
    "8c0c07678582602002",
    "8a6c2c0a02206082856707",
    "0c8c30",
    "26080a2c6c8a88662604022060828466",
    "022060828a6c2c0a072585",
    // : to @
    "0303 0909",
    "1200 1919",
    "7a1672",
    "1474 1878",
    "1a7612",
    "0a2c6c8a884644 4040",
    "644448686473848a6c2c0a022070",
    // A to Z
    "004c80 1474",
    "000c6c8a886606 6684826000",
    "8a6c2c0a02206082",
    "000c5c89835000",
    "7c0c0070 0656",
    "7c0c00 0656",
    "8a6c2c0a022060828656",
    "000c 808c 0686",
    "000c",
    "6c62402002",
    "000c 8c0680",
    "0c0070",
    "000c478c80",
    "000c808c",
    "20020a2c6c8a826020",
    "000c6c8a876505",
    "20020a2c6c8a826020 5380",
    "000c6c8a876505 4580",
    "8a6c2c0a0826668482602002",
    "0c8c 4c40",
    "0c022060828c",
    "0c408c",
    "0c2048608c",
    "0c80 008c",
    "0c468c 4640",
    "0c8c0080",
    // [ to `
    "6c3c3060",
    "0c80",
    "2c5c5020",
    "184c78",
    "0080",
    "3c59",
    // { to ~
    "6c4c4726454060",
    "4c40",
    "2c4c4766454020",
    "06286486",
};
constexpr std::string_view kBox = "000c8c8000";

float digit(char c) {
  return static_cast<float>(c <= '9' ? c - '0' : c - 'a' + 10);
}

std::string_view polylines(int row) {
  if (row == kGlyphRows - 1) return kBox;
  const int character = row + ' ';
  if (character >= 'a' && character <= 'z') return kFont[row - ('a' - 'A')];
  return kFont[character > 'z' ? row - 26 : row];
}

/// Whether the way turns by 60 degrees or more at `at`, or not at all.
bool staysSharp(const Vec2& before, const Vec2& at, const Vec2& after) {
  const float cosine = (at - before).normalized().dot((after - at).normalized());
  return cosine <= 0.5f || cosine > 0.999f;
}

/// A parabola between the middles of the two sides of each blunt corner.
Stroke rounded(const Stroke& corners) {
  const std::size_t last = corners.size() - 1;
  const bool isClosed = last > 1 && corners.front() == corners.back();
  Stroke result;
  for (std::size_t i = 0; i <= last; ++i) {
    const bool isEnd = i == 0 || i == last;
    const Vec2 at = corners[i];
    const Vec2 before = corners[i == 0 ? (isClosed ? last - 1 : 0) : i - 1];
    const Vec2 after = corners[i == last ? (isClosed ? 1 : last) : i + 1];
    if ((isEnd && !isClosed) || staysSharp(before, at, after)) {
      result.push_back(at);
      continue;
    }
    for (int k = 0; k <= kCurve; ++k) {
      const float t = static_cast<float>(k) / kCurve;
      const Vec2 from = 0.5f * (before + at), to = 0.5f * (at + after);
      result.push_back((1.0f - t) * (1.0f - t) * from + 2.0f * t * (1.0f - t) * at + t * t * to);
    }
  }
  return result;
}

float distanceTo(const Vec2& a, const Vec2& b, const Vec2& point) {
  const Vec2 way = b - a;
  const float t = clampTo((point - a).dot(way) / maxOf(way.squaredNorm(), 1e-6f), 0.0f, 1.0f);
  return (point - a - t * way).norm();
}

std::uint8_t texelAt(const std::vector<Stroke>& strokes, int x, int y) {
  const Vec2 point((static_cast<float>(x) + 0.5f) / kGlyphTexels - kGlyphMargin,
                   kGlyphHeight + kGlyphMargin - (static_cast<float>(y) + 0.5f) / kGlyphTexels);
  float nearest = kGlyphReach;
  for (const Stroke& stroke : strokes)
    for (std::size_t i = 1; i < stroke.size(); ++i)
      nearest = minOf(nearest, distanceTo(stroke[i - 1], stroke[i], point));
  return static_cast<std::uint8_t>(nearest / kGlyphReach * 255.0f + 0.5f);
}

}  // namespace

int glyphRow(char character) {
  return character >= ' ' && character <= '~' ? character - ' ' : kGlyphRows - 1;
}

std::vector<Stroke> glyphStrokes(int row) {
  std::vector<Stroke> strokes;
  Stroke corners;
  const std::string_view text = polylines(row);
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != ' ') {
      corners.emplace_back(digit(text[i]), digit(text[i + 1]));
      i += 2;
    } else {
      ++i;
    }
    if ((i < text.size() && text[i] != ' ') || corners.empty()) continue;
    strokes.push_back(rounded(corners));
    corners.clear();
  }
  return strokes;
}

float glyphAdvance(char character) {
  if (character == ' ') return kSpace;
  if (character >= '0' && character <= '9') return kGlyphWidth + kSpacing;
  float width = 0.0f;
  for (const Stroke& stroke : glyphStrokes(glyphRow(character)))
    for (const Vec2& point : stroke) width = maxOf(width, point.x());
  return width + kSpacing;
}

float textWidth(std::string_view text) {
  float width = 0.0f;
  for (const char c : text) width += glyphAdvance(c);
  return text.empty() ? 0.0f : (width - kSpacing) / kGlyphHeight;
}

std::vector<std::uint8_t> paintGlyphs() {
  std::vector<std::uint8_t> atlas(static_cast<std::size_t>(kGlyphAtlasWidth) * kGlyphAtlasHeight, 255);
  for (int row = 0; row < kGlyphRows; ++row) {
    const std::vector<Stroke> strokes = glyphStrokes(row);
    const int left = row % kGlyphColumns * kCellWidth, top = row / kGlyphColumns * kCellHeight;
    for (int y = 0; y < kCellHeight; ++y)
      for (int x = 0; x < kCellWidth; ++x)
        atlas[static_cast<std::size_t>(top + y) * kGlyphAtlasWidth + static_cast<std::size_t>(left + x)] =
            texelAt(strokes, x, y);
  }
  return atlas;
}

GlTexture makeGlyphTexture(const Gl& gl) {
  return makeByteTexture(gl, kGlyphAtlasWidth, kGlyphAtlasHeight, 1, paintGlyphs());
}

}  // namespace brittle::render
