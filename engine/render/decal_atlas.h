// render/decal_atlas.h - the pictures decals show: 64 sprites that level files number row by row, and the emblems of
// doors in a row below. Our own, computed: coverage only, the colour is the decal's.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/render/gl_object.h"

namespace brittle::render {

inline constexpr int kDecalsAcross = 8, kDecalRows = 9;
inline constexpr int kDecalPixels = 64;
inline constexpr int kEmblems = 4;

/// Cell of a sprite: 0 to 63 are themselves, -1 to -4 the emblems; anything else is wrapped into 0 to 63.
inline int decalCell(int tile) {
  return tile < 0 && tile >= -kEmblems ? 63 - tile : tile & 63;
}

/// Coverage of the atlas, top row first, a byte a texel.
std::vector<std::uint8_t> paintDecals();
/// With mipmaps down to a few pixels a sprite.
GlTexture makeDecalTexture(const Gl& gl);

}  // namespace brittle::render
