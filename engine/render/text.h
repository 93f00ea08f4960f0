// render/text.h - a font of our own: every printable ASCII character as straight strokes on an 8 x 12 grid, so that text needs no font
// file and is sharp at any size. All characters are equally wide, which keeps counters still; small letters look like capitals.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/render/gl_object.h"

namespace brittle::render {

inline constexpr int kGlyphHeight = 12;      // of a capital letter [units]
inline constexpr int kGlyphWidth = 8;        // [units]
inline constexpr float kGlyphAdvance = 11.0f;  // from one character to the next [units]
inline constexpr int kMaxStrokes = 16;       // a glyph has fewer or as many

/// From (x0, y0) to (x1, y1), y up from the base line. [units]
struct Stroke {
  std::uint8_t x0, y0, x1, y1;
};

/// Row of a character in the stroke table: printable ASCII in order, then one box for everything else.
int glyphRow(char character);
inline constexpr int kGlyphRows = '~' - ' ' + 2;

/// The strokes of a row; none for the space.
std::vector<Stroke> glyphStrokes(int row);

/// The width of `characters` characters of cap height 1.
float textWidth(std::size_t characters);

/// The table as a texture, a row a glyph, a texel a stroke; unused texels are 255.
GlTexture makeStrokeTexture(const Gl& gl);

}  // namespace brittle::render
