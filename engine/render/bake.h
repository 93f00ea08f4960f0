// render/bake.h - room boxes to triangles with light and ambient occlusion baked into the vertices. Done once per
// segment, on the CPU; gives the same kind of mesh as level files carry ready-made.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/aabb.h"
#include "engine/render/renderer.h"

namespace brittle::render {

/// An axis-aligned box; the three entries of each array are for its X, Y and Z faces.
struct BakeBox {
  Vec3 center = Vec3::Zero();       // [m]
  Vec3 halfExtents = Vec3::Ones();  // [m] > 0
  std::array<Rgb, 3> color = {Rgb::Ones(), Rgb::Ones(), Rgb::Ones()};
  std::array<int, 3> tile = {0, 0, 0};                 // 0 to 63
  std::array<float, 3> tileSize = {1.0f, 1.0f, 1.0f};  // side of a tile [m]; below 0.1 counts as 0.1
  std::array<int, 3> tileRotation = {0, 0, 0};         // quarter turns
  float glow = 0.0f;                                   // above 0 it is a lamp, and shines so much in its colour
  bool reflects = false;                               // polished: mirrors the room
};

/// Brightness of faces by where they look. [-] 1 is full
struct FaceLight {
  float left = 1.0f, right = 1.0f;  // faces with normal -X, +X
  float top = 1.0f, bottom = 1.0f;  // +Y, -Y
  float front = 1.0f, back = 1.0f;  // +Z, -Z
};

struct BakedMesh {
  std::vector<StaticVertex> vertices;
  std::vector<std::uint32_t> indices;
  std::uint32_t polished = 0;  // the last so many indices are of faces that reflect
};

struct BakeDef {
  FaceLight light = {};
  bool allFaces = false;        // also those a camera travelling along -Z near (0, 1) cannot see
  float occlusionReach = 4.0f;  // how far away something may be and still darken [m]
  /// What the neighbours have: darkens and shines as the boxes do but is not part of the mesh.
  std::span<const BakeBox> beyond = {};
};

/// Four vertices and two triangles a quad. Faces are cut at whole tiles from their lowest corner, at most kLongestQuad
/// apart, and closer where other boxes come near: there shade changes quickly. Light of lamps passes round what stands
/// in its way, not through it. Order depends on the arguments only. Cost: about 10 microseconds a quad.
BakedMesh bake(std::span<const BakeBox> boxes, const BakeDef& def);

inline constexpr float kLongestQuad = 1.0f;  // [m]

}  // namespace brittle::render
