#include "engine/render/target.h"

#include <algorithm>

#include "engine/core/assert.h"
#include "engine/render/shader.h"

namespace brittle::render {

namespace {

constexpr GLenum kColorFormat = GL_SRGB8_ALPHA8;
constexpr GLenum kDepthFormat = GL_DEPTH_COMPONENT24;

void bindTexture(const Gl& gl, GLint unit, GLuint texture) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_2D, texture);
}

}  // namespace

Target::Target(const Gl& gl, int width, int height, int samples, bool offscreen)
    : gl_(gl), width_(width), height_(height), samples_(samples) {
  BR_ASSERT(width > 0 && height > 0);
  if (samples_ == 0) {
    scene_ = makeCopy(kColorFormat, GL_COLOR_ATTACHMENT0, width_, height_);
  } else {
    scene_.framebuffer = GlFramebuffer(gl_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, scene_.framebuffer.name());
    sceneColor_ = makeRenderbuffer(kColorFormat, GL_COLOR_ATTACHMENT0, samples_);
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, scene_.framebuffer.name());
  sceneDepth_ = makeRenderbuffer(kDepthFormat, GL_DEPTH_ATTACHMENT, samples_);
  checkComplete();
  if (offscreen) {
    picture_ = GlFramebuffer(gl_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, picture_.name());
    pictureColor_ = makeRenderbuffer(GL_RGBA8, GL_COLOR_ATTACHMENT0, 0);
    checkComplete();
  }
}

void Target::checkComplete() {
  isComplete_ = isComplete_ && gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

GlRenderbuffer Target::makeRenderbuffer(GLenum format, GLenum attachment, int samples) const {
  GlRenderbuffer buffer(gl_);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width_, height_);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
  return buffer;
}

Target::Copy Target::makeCopy(GLenum format, GLenum attachment, int width, int height) const {
  Copy copy{GlTexture(gl_), GlFramebuffer(gl_)};
  gl_.ActiveTexture(GL_TEXTURE0 + kUnitScratch);
  gl_.BindTexture(GL_TEXTURE_2D, copy.texture.name());
  gl_.TexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
  const GLint filter = attachment == GL_DEPTH_ATTACHMENT ? GL_NEAREST : GL_LINEAR;
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl_.BindTexture(GL_TEXTURE_2D, 0);  // it will be drawn into
  gl_.BindFramebuffer(GL_FRAMEBUFFER, copy.framebuffer.name());
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, copy.texture.name(), 0);
  return copy;
}

void Target::bindScene() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, scene_.framebuffer.name());
  gl_.Viewport(0, 0, width_, height_);
}

void Target::bindPicture() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, picture_.name());
  gl_.Viewport(0, 0, width_, height_);
}

void Target::blit(Copy& copy, GLenum format, GLbitfield what, GLint unit) {
  const GLenum attachment = what == GL_DEPTH_BUFFER_BIT ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0;
  if (!copy.texture) copy = makeCopy(format, attachment, width_, height_);
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, scene_.framebuffer.name());
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, copy.framebuffer.name());
  gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, what, GL_NEAREST);
  bindScene();
  bindTexture(gl_, unit, copy.texture.name());
}

void Target::copyColor(GLint unit) {
  blit(colorCopy_, kColorFormat, GL_COLOR_BUFFER_BIT, unit);
}
void Target::copyDepth(GLint unit) {
  blit(depthCopy_, kDepthFormat, GL_DEPTH_BUFFER_BIT, unit);
}

void Target::resolve(GLint unit) {
  if (samples_ == 0) {
    bindTexture(gl_, unit, scene_.texture.name());
  } else {
    blit(resolved_, kColorFormat, GL_COLOR_BUFFER_BIT, unit);
  }
}

void Target::bindPart(Copy& part, int width, int height) {
  if (!part.texture) part = makeCopy(kColorFormat, GL_COLOR_ATTACHMENT0, width, height);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, part.framebuffer.name());
  gl_.Viewport(0, 0, width, height);
}

void Target::bindSmall(std::size_t which) {
  bindPart(small_[which], smallWidth(), smallHeight());
}

void Target::bindHalf(std::size_t which) {
  bindPart(half_[which], (width_ + 1) / 2, (height_ + 1) / 2);
}

void Target::useHalf(std::size_t which, GLint unit) const {
  bindTexture(gl_, unit, half_[which].texture.name());
}

void Target::useSmall(std::size_t which, GLint unit) const {
  bindTexture(gl_, unit, small_[which].texture.name());
}

Image Target::readPicture() const {
  Image image{width_, height_, {}};
  const std::size_t row = 4u * static_cast<std::size_t>(width_);
  image.pixels.resize(row * static_cast<std::size_t>(height_));
  gl_.BindFramebuffer(GL_FRAMEBUFFER, picture_.name());
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  for (int low = 0, high = height_ - 1; low < high; ++low, --high) {  // GL counts rows from the bottom
    const auto at = [&](int y) { return image.pixels.begin() + static_cast<std::ptrdiff_t>(row) * y; };
    std::swap_ranges(at(low), at(low + 1), at(high));
  }
  return image;
}

}  // namespace brittle::render
