#include "engine/render/gl.h"

#include <cstdio>

namespace brittle::render {

namespace {

constexpr GLenum kFramebufferSrgb = 0x8DB9;  // desktop only: GLES always encodes when it writes to sRGB

/// "OpenGL ES 3.2 Mesa" or "4.5 (Core Profile) Mesa": the first number, and whether it is the desktop dialect.
struct Version {
  int major = 0, minor = 0;
  bool isDesktop = false;
};

Version parseVersion(const char* text) {
  Version version;
  version.isDesktop = std::string(text).find("OpenGL ES") == std::string::npos;
  while (*text != 0 && (*text < '0' || *text > '9')) ++text;
  std::sscanf(text, "%d.%d", &version.major, &version.minor);
  return version;
}

}  // namespace

Result<Gl> loadGl(GlLoader loader) {
  Gl gl;
#define BR_GL_LOAD(name, type)                          \
  gl.name = reinterpret_cast<type>(loader("gl" #name)); \
  if (gl.name == nullptr) return Error{"the GL context lacks gl" #name ": GLES 3.0 is needed"};
  BR_GL_FUNCTIONS(BR_GL_LOAD)
#undef BR_GL_LOAD

  const char* text = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
  if (text == nullptr) return Error{"no GL context is current on this thread"};
  const Version version = parseVersion(text);
  // Desktop 4.3 is the first whose shading compiler must accept GLES 3.0 sources.
  const bool isEnough = version.isDesktop ? version.major * 10 + version.minor >= 43 : version.major >= 3;
  if (!isEnough) return Error{std::string("the GL context is \"") + text + "\": GLES 3.0 is needed"};
  if (version.isDesktop) gl.Enable(kFramebufferSrgb);
  const char* device = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
  gl.description = std::string(text) + ", " + (device != nullptr ? device : "unnamed device");
  return gl;
}

std::string glErrorName(GLenum error) {
  switch (error) {
    case GL_NO_ERROR:
      return "no error";
    case GL_INVALID_ENUM:
      return "invalid enum";
    case GL_INVALID_VALUE:
      return "invalid value";
    case GL_INVALID_OPERATION:
      return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "incomplete framebuffer";
    case GL_OUT_OF_MEMORY:
      return "out of memory";
    default:
      return "GL error " + std::to_string(error);
  }
}

}  // namespace brittle::render
