// render/tiles.h - the 8 x 8 atlas of wall patterns that level files number 0 to 63: grey patterns of our own,
// computed, that multiply a box's colour. Tile = row * 8 + column.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/gl_object.h"

namespace brittle::render {

inline constexpr int kTilesAcross = 8;
inline constexpr int kTilePixels = 64;
inline constexpr int kAtlasPixels = kTilesAcross * kTilePixels;

/// Grey levels of the atlas, top row first, kAtlasPixels squared. Tile 0 is plain white.
std::vector<std::uint8_t> paintTiles();
/// The atlas as a texture with mipmaps down to one pixel a tile.
GlTexture makeTileTexture(const Gl& gl);

}  // namespace brittle::render
