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

GlTexture makeByteTexture(const Gl& gl, int width, int height, int levels, const std::vector<std::uint8_t>& texels) {
  GlTexture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  gl.TexStorage2D(GL_TEXTURE_2D, levels, GL_R8, width, height);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RED, GL_UNSIGNED_BYTE, texels.data());
  if (levels > 1) gl.GenerateMipmap(GL_TEXTURE_2D);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

}  // namespace brittle::render
