#include "engine/render/text.h"

#include <string_view>

#include "engine/core/assert.h"

namespace brittle::render {

namespace {

constexpr int kStoredGlyphs = kGlyphRows - 26 - 1;  // small letters are capitals, the box is made below

// Polylines separated by spaces; a point is two digits of base 13, x then y, y up. Two equal points are a dot.
constexpr std::string_view kFont[kStoredGlyphs] = {
    // space to /
    "", "4c45 4040", "2c29 6c69", "202c 606c 0484 0888", "8a6c2c0a0826668482602002 4c40",
    "008c 0c2c2a0a0c 6282806062", "80080a2c4c5a580402204084", "4c49", "6c494360", "2c494320", "424a 0884 0488",
    "424a 0686", "4230", "1676", "4040", "008c",
    // 0 to 9
    "20020a2c6c8a826020", "194c40 1070", "0a2c6c8a870080", "0a2c6c8a886636 668482602002", "606c0383",
    "8c0c07678582602002", "8a6c2c0a02206082856707", "0c8c30", "26080a2c6c8a88662604022060828466",
    "022060828a6c2c0a072585",
    // : to @
    "4343 4949", "4230 4949", "7a1672", "1474 1878", "1a7612", "0a2c6c8a884644 4040",
    "644448686473848a6c2c0a022070",
    // A to Z
    "00093c5c8980 0585", "000c6c8a886606 6684826000", "8a6c2c0a02206082", "000c5c89835000", "8c0c0080 0666",
    "8c0c00 0666", "8a6c2c0a022060828656", "000c 808c 0686", "2060 404c 2c6c", "8c82602002", "000c 8c0680",
    "0c0080", "000c478c80", "000c808c", "20020a2c6c8a826020", "000c6c8a876505", "20020a2c6c8a826020 5380",
    "000c6c8a876505 4580", "8a6c2c0a0826668482602002", "0c8c 4c40", "0c022060828c", "0c408c", "0c2048608c",
    "0c80 008c", "0c468c 4640", "0c8c0080",
    // [ to `
    "6c3c3060", "0c80", "2c5c5020", "184c78", "0080", "3c59",
    // { to ~
    "6c4c4726454060", "4c40", "2c4c4766454020", "06286486",
};
constexpr std::string_view kBox = "000c8c8000";

int digit(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }

std::string_view polylines(int row) {
  if (row == kGlyphRows - 1) return kBox;
  const int character = row + ' ';
  if (character >= 'a' && character <= 'z') return kFont[row - ('a' - 'A')];
  return kFont[character > 'z' ? row - 26 : row];
}

}  // namespace

int glyphRow(char character) { return character >= ' ' && character <= '~' ? character - ' ' : kGlyphRows - 1; }

std::vector<Stroke> glyphStrokes(int row) {
  std::vector<Stroke> strokes;
  const std::string_view text = polylines(row);
  for (std::size_t i = 0; i + 3 < text.size();) {
    if (text[i + 2] == ' ') {  // the end of a polyline
      i += 3;
      continue;
    }
    const auto at = [&](std::size_t k) { return static_cast<std::uint8_t>(digit(text[i + k])); };
    strokes.push_back({at(0), at(1), at(2), at(3)});
    i += 2;
  }
  BR_ASSERT(strokes.size() <= static_cast<std::size_t>(kMaxStrokes));
  return strokes;
}

float textWidth(std::size_t characters) {
  if (characters == 0) return 0.0f;
  return (static_cast<float>(characters - 1) * kGlyphAdvance + kGlyphWidth) / kGlyphHeight;
}

GlTexture makeStrokeTexture(const Gl& gl) {
  std::vector<std::uint8_t> texels(static_cast<std::size_t>(kGlyphRows) * kMaxStrokes * 4, 255);
  for (int row = 0; row < kGlyphRows; ++row) {
    std::uint8_t* out = &texels[static_cast<std::size_t>(row) * kMaxStrokes * 4];
    for (const Stroke& stroke : glyphStrokes(row)) {
      *out++ = stroke.x0;
      *out++ = stroke.y0;
      *out++ = stroke.x1;
      *out++ = stroke.y1;
    }
  }
  GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8UI, kMaxStrokes, kGlyphRows);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kMaxStrokes, kGlyphRows, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, texels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

}  // namespace brittle::render
