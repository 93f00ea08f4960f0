// render/batch.h - vertex arrays with the buffers they read: baked rooms that stay, and instances streamed every frame.
#pragma once

#include <span>
#include <vector>

#include "engine/render/gl_object.h"
#include "engine/render/renderer.h"

namespace brittle::render {

/// Indexed triangles on the GPU.
class StaticMesh {
 public:
  StaticMesh(const Gl& gl, std::span<const StaticVertex> vertices, std::span<const std::uint32_t> indices);
  void draw(const Gl& gl) const;
  std::uint32_t triangles() const { return indexCount_ / 3; }

 private:
  GlBuffer vertices_, indices_;
  GlVertexArray array_;
  std::uint32_t indexCount_;
};

/// Instances of something whose vertices the shader makes from gl_VertexID.
class InstanceBatch {
 public:
  InstanceBatch(const Gl& gl, GLsizei stride, std::span<const Attribute> layout);

  /// Draws all records of `instances`, `vertexCount` vertices each. Nothing for an empty list.
  template <class T>
  void draw(const Gl& gl, GLenum mode, GLsizei vertexCount, const std::vector<T>& instances) const {
    if (instances.empty()) return;
    gl.BindVertexArray(array_.name());
    stream(gl, GL_ARRAY_BUFFER, buffer_.name(), instances);
    gl.DrawArraysInstanced(mode, 0, vertexCount, static_cast<GLsizei>(instances.size()));
  }

 private:
  GlBuffer buffer_;
  GlVertexArray array_;
};

/// Instances of the built-in sphere.
class SphereBatch {
 public:
  SphereBatch(const Gl& gl, GLsizei stride, std::span<const Attribute> layout);

  template <class T>
  void draw(const Gl& gl, const std::vector<T>& instances) const {
    if (instances.empty()) return;
    gl.BindVertexArray(array_.name());
    stream(gl, GL_ARRAY_BUFFER, instances_.name(), instances);
    gl.DrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(indexCount_), GL_UNSIGNED_SHORT, nullptr,
                             static_cast<GLsizei>(instances.size()));
  }
  std::uint32_t triangles() const { return indexCount_ / 3; }

 private:
  GlBuffer vertices_, indices_, instances_;
  GlVertexArray array_;
  std::uint32_t indexCount_ = 0;
};

}  // namespace brittle::render
