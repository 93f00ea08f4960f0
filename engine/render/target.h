// render/target.h - the framebuffers of a picture: the scene (multisampled or not), copies of its colour and depth that
// later passes read, and the finished picture when there is no window. Made for one size.
#pragma once

#include <array>

#include "engine/math/types.h"
#include "engine/render/capture.h"
#include "engine/render/gl_object.h"

namespace brittle::render {

class Target {
 public:
  /// `offscreen`: the finished picture gets a framebuffer of its own instead of framebuffer 0.
  Target(const Gl& gl, int width, int height, int samples, bool offscreen);

  /// Whether the driver had the memory for it: of no use otherwise.
  bool isComplete() const { return isComplete_; }
  int width() const { return width_; }
  int height() const { return height_; }

  void bindScene() const;
  void bindPicture() const;
  /// Copies what the scene shows now into a texture and binds that to `unit`; the copy is made on first use.
  void copyColor(GLint unit);
  void copyDepth(GLint unit);
  /// Binds the scene's colour, resolved, to `unit`.
  void resolve(GLint unit);
  /// Draws go to one of two small pictures, `kSmall` times narrower and lower, made on first use.
  void bindSmall(std::size_t which);
  void useSmall(std::size_t which, GLint unit) const;
  int smallWidth() const { return maxOf(width_ / kSmall, 1); }
  int smallHeight() const { return maxOf(height_ / kSmall, 1); }
  /// The same at half the width and height.
  void bindHalf(std::size_t which);
  void useHalf(std::size_t which, GLint unit) const;
  Image readPicture() const;

 private:
  struct Copy {
    GlTexture texture;
    GlFramebuffer framebuffer;
  };
  static constexpr int kSmall = 4;
  Copy makeCopy(GLenum format, GLenum attachment, int width, int height) const;
  void blit(Copy& copy, GLenum format, GLbitfield what, GLint unit);
  void bindPart(Copy& part, int width, int height);
  void checkComplete();
  GlRenderbuffer makeRenderbuffer(GLenum format, GLenum attachment, int samples) const;

  const Gl& gl_;
  int width_, height_, samples_;
  bool isComplete_ = true;
  Copy scene_;  // without multisampling its colour is a texture
  GlRenderbuffer sceneColor_, sceneDepth_;
  Copy colorCopy_, depthCopy_, resolved_;
  std::array<Copy, 2> small_, half_;
  GlFramebuffer picture_;
  GlRenderbuffer pictureColor_;
};

}  // namespace brittle::render
