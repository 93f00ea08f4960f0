#include "engine/render/gl_object.h"

namespace brittle::render {

GLuint generate(const Gl& gl, GlKind kind) {
  GLuint name = 0;
  switch (kind) {
    case GlKind::Buffer:
      gl.GenBuffers(1, &name);
      break;
    case GlKind::Texture:
      gl.GenTextures(1, &name);
      break;
    case GlKind::Renderbuffer:
      gl.GenRenderbuffers(1, &name);
      break;
    case GlKind::Framebuffer:
      gl.GenFramebuffers(1, &name);
      break;
    case GlKind::VertexArray:
      gl.GenVertexArrays(1, &name);
      break;
  }
  return name;
}

void destroy(const Gl& gl, GlKind kind, GLuint name) {
  switch (kind) {
    case GlKind::Buffer:
      gl.DeleteBuffers(1, &name);
      break;
    case GlKind::Texture:
      gl.DeleteTextures(1, &name);
      break;
    case GlKind::Renderbuffer:
      gl.DeleteRenderbuffers(1, &name);
      break;
    case GlKind::Framebuffer:
      gl.DeleteFramebuffers(1, &name);
      break;
    case GlKind::VertexArray:
      gl.DeleteVertexArrays(1, &name);
      break;
  }
}

}  // namespace brittle::render
