// render/mesh_store.h - the GPU's mirror of the mesh pool (vertices), and of what moves and colours it (body and shape
// textures). Only what changed is uploaded. Knows the pool and GL, not scenes.
#pragma once

#include <array>
#include <vector>

#include "engine/geometry/mesh_pool.h"
#include "engine/render/frame.h"
#include "engine/render/gl_object.h"

namespace brittle::render {

/// A texture read as a table: texels of four 32-bit words, 1024 a row. Keeps what it uploaded and
/// sends only rows that differ.
class TableTexture {
 public:
  enum class Kind { Float, Whole };
  TableTexture(const Gl& gl, Kind kind) : gl_(gl), kind_(kind) {}

  /// Four words a texel, padded to whole rows. Grows as needed and never shrinks. Returns the rows uploaded.
  std::uint32_t upload(std::vector<std::uint32_t>& words);
  void bind(GLint unit) const;

 private:
  void grow(std::size_t rows);

  const Gl& gl_;
  Kind kind_;
  GlTexture texture_;
  std::vector<std::uint32_t> uploaded_;
};

class MeshStore {
 public:
  explicit MeshStore(const Gl& gl);

  /// Brings the vertex buffer up to date and clears the pool's dirty ranges. Returns the number of vertices uploaded.
  std::uint32_t syncVertices(geometry::MeshPool& pool);
  /// Uploads body transforms and the shapes' body, material and tint.
  void syncTables(const MeshGroup& group);

  /// Binds vertices (the mesh programs' attributes) with the index buffer, and both tables.
  void bind() const;
  void bindTables() const;
  GLuint indexBuffer() const { return indices_.name(); }

 private:
  void reallocate(const geometry::MeshPool& pool);

  const Gl& gl_;
  GlBuffer vertices_, indices_;
  GlVertexArray array_;
  std::size_t capacity_ = 0;  // [vertices]
  TableTexture bodies_, shapes_;
  std::vector<std::uint32_t> bodyWords_, shapeWords_;  // kept to avoid allocating every frame
};

}  // namespace brittle::render
