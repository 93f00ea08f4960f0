// render/bake.h - room boxes to triangles with light and ambient occlusion baked into the vertices. Done once per
// segment, on the CPU; gives the same kind of mesh as level files carry ready-made.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
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

/// Bakes a face at a time, for who has a picture to draw between two faces.
///
/// Shade is sampled at whole tiles from each face's lowest corner, at least every kLongestQuad, and closer where other
/// boxes come near; evenly coloured parts of a tile become one rectangle of two triangles, or of more where its
/// neighbours bend. Light of lamps passes round what stands in its way, not through it. Order depends on the arguments
/// only.
class Baker {
 public:
  Baker(std::span<const BakeBox> boxes, const BakeDef& def);
  ~Baker();
  Baker(Baker&&) noexcept;
  Baker& operator=(Baker&&) noexcept;

  /// Bakes the next face that can be seen. False when there is none left.
  bool step();
  /// What is left to bake, and the mesh of all; the baker is empty then.
  BakedMesh finish();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// All faces at once.
BakedMesh bake(std::span<const BakeBox> boxes, const BakeDef& def);

inline constexpr float kLongestQuad = 1.0f;  // between two samples [m]

}  // namespace brittle::render
