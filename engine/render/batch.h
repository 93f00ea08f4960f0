// render/batch.h - vertex arrays with the buffers they read: baked rooms that stay; instances and overlays streamed
// every frame.
#pragma once

#include <span>
#include <vector>

#include "engine/render/gl_object.h"
#include "engine/render/overlay.h"
#include "engine/render/renderer.h"

namespace brittle::render {

/// Indexed triangles on the GPU.
class StaticMesh {
 public:
  /// The last `polished` indices are of faces that reflect.
  StaticMesh(const Gl& gl, std::span<const StaticVertex> vertices, std::span<const std::uint32_t> indices,
             std::uint32_t polished);
  void draw(const Gl& gl, bool polished) const;
  std::uint32_t triangles(bool polished) const { return (polished ? polished_ : dull_) / 3; }

 private:
  GlBuffer vertices_, indices_;
  GlVertexArray array_;
  std::uint32_t dull_, polished_;  // [indices]
};

/// Instances of something whose vertices the shader makes from gl_VertexID. Takes nothing from GL before the first
/// draw.
class InstanceBatch {
 public:
  /// `layout` must outlive it.
  InstanceBatch(GLsizei stride, std::span<const Attribute> layout) : stride_(stride), layout_(layout) {}

  /// Draws all records of `instances`, `vertexCount` vertices each. Nothing for an empty list.
  template <class T>
  void draw(const Gl& gl, GLenum mode, GLsizei vertexCount, const std::vector<T>& instances) {
    if (instances.empty()) return;
    if (!array_) make(gl);
    gl.BindVertexArray(array_.name());
    stream(gl, GL_ARRAY_BUFFER, buffer_.name(), instances);
    gl.DrawArraysInstanced(mode, 0, vertexCount, static_cast<GLsizei>(instances.size()));
  }

 private:
  void make(const Gl& gl);

  GLsizei stride_;
  std::span<const Attribute> layout_;
  GlBuffer buffer_;
  GlVertexArray array_;
};

/// Indexed triangles made anew for every frame. Takes nothing from GL before the first draw.
class StreamBatch {
 public:
  /// `layout` must outlive it.
  StreamBatch(GLsizei stride, std::span<const Attribute> layout) : stride_(stride), layout_(layout) {}

  template <class T>
  void draw(const Gl& gl, const std::vector<T>& vertices, const std::vector<std::uint32_t>& indices) {
    if (indices.empty()) return;
    if (!array_) make(gl);
    gl.BindVertexArray(array_.name());
    stream(gl, GL_ARRAY_BUFFER, vertices_.name(), vertices);
    stream(gl, GL_ELEMENT_ARRAY_BUFFER, indices_.name(), indices);
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
  }

 private:
  void make(const Gl& gl);

  GLsizei stride_;
  std::span<const Attribute> layout_;
  GlBuffer vertices_, indices_;
  GlVertexArray array_;
};

/// Instances of the built-in sphere. Takes nothing from GL before the first draw.
class SphereBatch {
 public:
  /// `layout` must outlive it.
  SphereBatch(GLsizei stride, std::span<const Attribute> layout) : stride_(stride), layout_(layout) {}

  template <class T>
  void draw(const Gl& gl, const std::vector<T>& instances) {
    if (instances.empty()) return;
    if (!array_) make(gl);
    gl.BindVertexArray(array_.name());
    stream(gl, GL_ARRAY_BUFFER, instances_.name(), instances);
    gl.DrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(indexCount_), GL_UNSIGNED_SHORT, nullptr,
                             static_cast<GLsizei>(instances.size()));
  }
  std::uint32_t triangles() const { return indexCount_ / 3; }

 private:
  void make(const Gl& gl);

  GLsizei stride_;
  std::span<const Attribute> layout_;
  GlBuffer vertices_, indices_, instances_;
  GlVertexArray array_;
  std::uint32_t indexCount_ = 0;
};

/// The overlay's GL side. Takes nothing from GL before the first draw.
class OverlayBatch {
 public:
  /// Draws the parts of an overlay that has a texture, with the program in use, into a picture of that many pixels.
  /// Returns the number of triangles.
  std::uint32_t draw(const Gl& gl, const Overlay& overlay, int width, int height);

 private:
  void make(const Gl& gl);
  void upload(const Gl& gl, const std::shared_ptr<const OverlayTexture>& texture);

  GlBuffer points_, indices_;
  GlVertexArray array_;
  GlTexture texture_;
  std::shared_ptr<const OverlayTexture> uploaded_;
};

}  // namespace brittle::render
