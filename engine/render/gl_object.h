// render/gl_object.h - owners of GL names: made on construction, deleted with their holder. They hold a pointer to the
// table, which must outlive them, and nothing else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/render/gl.h"

namespace brittle::render {

enum class GlKind { Buffer, Texture, Renderbuffer, Framebuffer, VertexArray };

GLuint generate(const Gl& gl, GlKind kind);
void destroy(const Gl& gl, GlKind kind, GLuint name);

template <GlKind kind>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(const Gl& gl) : gl_(&gl), name_(generate(gl, kind)) {}
  ~GlObject() { reset(); }
  GlObject(GlObject&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
  }
  void reset() {
    if (name_ != 0) destroy(*gl_, kind, name_);
    name_ = 0;
  }
  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  const Gl* gl_ = nullptr;
  GLuint name_ = 0;
};

using GlBuffer = GlObject<GlKind::Buffer>;
using GlTexture = GlObject<GlKind::Texture>;
using GlRenderbuffer = GlObject<GlKind::Renderbuffer>;
using GlFramebuffer = GlObject<GlKind::Framebuffer>;
using GlVertexArray = GlObject<GlKind::VertexArray>;

/// A texture of one byte a texel, top row first, seen smoothly; with more than one level, smaller ones are made from
/// it. Leaves it bound.
GlTexture makeByteTexture(const Gl& gl, int width, int height, int levels, const std::vector<std::uint8_t>& texels);

/// One attribute of a vertex array: `components` values of `type` at `offset` in records of `stride` bytes.
/// Whole: reaches the shader as integers. Normalized: whole numbers become [0, 1] or [-1, 1].
struct Attribute {
  enum class As : std::uint8_t { Float, Normalized, Whole };
  GLuint location;
  GLint components;
  GLenum type;
  As as;
  std::size_t offset;
};

/// Attaches attributes read from `buffer` to the bound vertex array; divisor 1 steps per instance.
template <class List>
void attach(const Gl& gl, GLuint buffer, GLsizei stride, const List& attributes, GLuint divisor = 0) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  for (const Attribute& a : attributes) {
    const void* offset = reinterpret_cast<const void*>(a.offset);
    gl.EnableVertexAttribArray(a.location);
    if (a.as == Attribute::As::Whole) {
      gl.VertexAttribIPointer(a.location, a.components, a.type, stride, offset);
    } else {
      gl.VertexAttribPointer(a.location, a.components, a.type, a.as == Attribute::As::Normalized, stride, offset);
    }
    if (divisor != 0) gl.VertexAttribDivisor(a.location, divisor);
  }
}

/// Replaces a buffer's contents by this frame's data; the driver may give it new memory, so nothing waits for the last
/// frame.
template <class T>
void stream(const Gl& gl, GLenum target, GLuint buffer, const T& data) {
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(data[0])), data.data(), GL_STREAM_DRAW);
}

}  // namespace brittle::render
