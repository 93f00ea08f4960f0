// content/baked_mesh.h - a segment's boxes as its author's editor baked them: segments/NAME.mesh beside NAME.xml.
// A zlib archive (RFC 1950) of a vertex count (32 bits), vertices of 24 bytes, a count that is not to be trusted, and
// indices (32 bits) up to the end, three a triangle; little-endian.
//
// Only the picture reads it. The simulation never sees it, and a replay's content hash leaves it out: the hash says
// whether a replay plays as it was recorded, and it does with the mesh baked anew, damaged or gone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/math/types.h"
#include "game/content/problem.h"

namespace brittle::content {

struct BakedVertex {
  Vec3 point = Vec3::Zero();  // in the segment's frame [m]
  float u = 0.0f, v = 0.0f;   // in the tile atlas
  std::uint32_t color = 0;    // R lowest; rgb: half the colour times light, alpha: openness, 255 is open
};

/// All of a mesh or nothing: half a room would look worse than one baked anew.
struct BakedMesh {
  std::vector<BakedVertex> vertices;
  std::vector<std::uint32_t> indices;  // a multiple of three, each below the number of vertices
  Problems problems;                   // at most one; the mesh is empty then
};

/// Reads the bytes of a mesh as they are stored, which a gzip archive may lie around. Never fails.
BakedMesh readBakedMesh(const std::string& bytes, const std::string& file);

}  // namespace brittle::content
