// render/text.h - a font of our own: every printable ASCII character as strokes on an 8 x 12 grid, so that text needs
// no font file and is sharp at any size. Corners of 45 degrees are round. Figures are equally wide, which keeps
// counters still; small letters look like capitals.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/math/types.h"
#include "engine/render/gl_object.h"

namespace brittle::render {

inline constexpr int kGlyphHeight = 12;  // of a capital letter [units]
inline constexpr int kGlyphWidth = 8;    // of the widest ones [units]

/// Points a stroke runs through, y up from the base line. [units]
using Stroke = std::vector<Vec2>;

/// Row of a character in the table: printable ASCII in order, then one box for everything else.
int glyphRow(char character);
inline constexpr int kGlyphRows = '~' - ' ' + 2;

/// The strokes of a row; none for the space.
std::vector<Stroke> glyphStrokes(int row);

/// From a character's left side to the next one's. [units]
float glyphAdvance(char character);
/// The width of a line of cap height 1.
float textWidth(std::string_view text);

// The atlas of distances to the strokes: a cell a glyph, kGlyphMargin about the grid, row by row from the top.
inline constexpr int kGlyphColumns = 12;
inline constexpr int kGlyphMargin = 3;      // [units]
inline constexpr int kGlyphTexels = 2;      // a unit
inline constexpr float kGlyphReach = 4.0f;  // the distance that is stored as 255 [units]
inline constexpr int kCellWidth = (kGlyphWidth + 2 * kGlyphMargin) * kGlyphTexels;
inline constexpr int kCellHeight = (kGlyphHeight + 2 * kGlyphMargin) * kGlyphTexels;
inline constexpr int kGlyphAtlasWidth = kGlyphColumns * kCellWidth;
inline constexpr int kGlyphAtlasHeight = (kGlyphRows + kGlyphColumns - 1) / kGlyphColumns * kCellHeight;

/// Top row first, a byte a texel.
std::vector<std::uint8_t> paintGlyphs();
GlTexture makeGlyphTexture(const Gl& gl);

}  // namespace brittle::render
