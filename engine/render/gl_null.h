// render/gl_null.h - a GL without a driver: the whole table, recording what it is asked and answering as if all went
// well. Tests of the renderer run on it, and every misuse it can tell gives one sentence.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/render/gl.h"

namespace brittle::render {

/// What was asked of the null table. Only one can be in use at a time (GL functions carry no context).
class NullGl {
 public:
  struct Draw {
    GLuint program = 0;
    GLsizei vertices = 0;  // or indices
    GLsizei instances = 1;
    GLuint framebuffer = 0;
  };

  NullGl();
  ~NullGl();
  NullGl(const NullGl&) = delete;
  NullGl& operator=(const NullGl&) = delete;

  /// The table to give to a renderer.
  Gl& table() { return table_; }

  /// A function of the one in use by its whole name, "glClear"; null if there is none. As a GlLoader.
  static void* find(const char* name);

  const std::vector<Draw>& draws() const { return draws_; }
  /// One sentence per misuse, in order.
  const std::vector<std::string>& complaints() const { return complaints_; }
  /// How often a function was called, by its name without "gl".
  std::uint32_t calls(const std::string& function) const;
  /// Bytes sent by BufferData and BufferSubData to a target.
  std::uint64_t bytesTo(GLenum target) const;
  /// GL objects that were made and not deleted.
  std::size_t liveObjects() const;
  /// Forgets draws, calls and bytes; objects and state stay.
  void clearRecord();

  /// The next shader that is compiled fails with this text.
  void failNextShader(std::string message) { shaderError_ = std::move(message); }

 private:
  friend struct NullFunctions;
  struct Buffer {
    GLsizeiptr size = 0;
  };
  struct Texture {
    GLsizei width = 0, height = 0;
  };
  struct Framebuffer {
    GLuint colorTexture = 0, depthTexture = 0;
    bool hasColor = false, hasDepth = false;
  };
  struct VertexArray {
    GLuint indexBuffer = 0;
  };

  void complain(std::string sentence) { complaints_.push_back(std::move(sentence)); }
  void checkDraw(GLsizei vertices, GLsizei instances);
  void checkIndices(GLsizei count, GLenum type, std::uintptr_t offset);
  GLuint& bufferAt(GLenum target);

  Gl table_;
  std::vector<Draw> draws_;
  std::vector<std::string> complaints_;
  std::map<std::string, std::uint32_t> calls_;
  std::map<GLenum, std::uint64_t> bytes_;
  std::string shaderError_;

  GLuint nextName_ = 1;
  std::map<GLuint, Buffer> buffers_;
  std::map<GLuint, Texture> textures_;
  std::map<GLuint, Framebuffer> framebuffers_;
  std::map<GLuint, VertexArray> arrays_;
  std::map<GLuint, bool> renderbuffers_, shaders_, programs_;  // shaders: whether they compiled
  std::map<GLenum, GLuint> boundBuffers_;
  std::map<GLenum, GLuint> boundTextures_;  // by unit
  GLenum activeUnit_ = GL_TEXTURE0;
  GLuint program_ = 0, array_ = 0, drawFramebuffer_ = 0, readFramebuffer_ = 0, boundRenderbuffer_ = 0;
  GLsizei viewportWidth_ = 0, viewportHeight_ = 0;
};

}  // namespace brittle::render
