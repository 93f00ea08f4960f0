#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdio>

#include "platform/headless/context.h"
#include "platform/headless/library.h"

namespace brittle::platform {

namespace {

// name, type: the functions of libEGL we use.
#define BR_EGL_FUNCTIONS(X)                           \
  X(GetProcAddress, PFNEGLGETPROCADDRESSPROC)         \
  X(GetPlatformDisplay, PFNEGLGETPLATFORMDISPLAYPROC) \
  X(Initialize, PFNEGLINITIALIZEPROC)                 \
  X(BindAPI, PFNEGLBINDAPIPROC)                       \
  X(CreateContext, PFNEGLCREATECONTEXTPROC)           \
  X(MakeCurrent, PFNEGLMAKECURRENTPROC)               \
  X(DestroyContext, PFNEGLDESTROYCONTEXTPROC)         \
  X(GetError, PFNEGLGETERRORPROC)

struct Egl {
#define BR_EGL_MEMBER(name, type) type name = nullptr;
  BR_EGL_FUNCTIONS(BR_EGL_MEMBER)
#undef BR_EGL_MEMBER
};

Result<Egl> loadEgl() {
  const Result<Library> library = Library::open("libEGL.so.1", "libegl1 libegl-mesa0");
  if (!library) return library.error();
  Egl egl;
#define BR_EGL_LOAD(name, type)                          \
  egl.name = library->find<type>("egl" #name);           \
  if (egl.name == nullptr)                               \
    return Error{"libEGL.so.1 lacks egl" #name           \
                 ": EGL 1.5 is needed (apt-get install " \
                 "libegl1)"};
  BR_EGL_FUNCTIONS(BR_EGL_LOAD)
#undef BR_EGL_LOAD
  return egl;
}

Egl loadedEgl;  // the GL loader is a plain function and needs it

void* findInEgl(const char* name) {
  return reinterpret_cast<void*>(loadedEgl.GetProcAddress(name));
}

class EglContext : public Context {
 public:
  EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
  ~EglContext() override {
    // The display stays initialised: it belongs to the process, and Mesa counts no users.
    loadedEgl.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    loadedEgl.DestroyContext(display_, context_);
  }
  runtime::GlLoader loader() const override { return findInEgl; }

 private:
  EGLDisplay display_;
  EGLContext context_;
};

Error eglError(const std::string& what) {
  char code[16];
  std::snprintf(code, sizeof(code), "0x%04X", static_cast<unsigned>(loadedEgl.GetError()));
  return {"EGL: " + what + " (error " + code + "); the software driver is in libgl1-mesa-dri"};
}

}  // namespace

Result<std::unique_ptr<Context>> createEglContext() {
  Result<Egl> egl = loadEgl();
  if (!egl) return egl.error();
  loadedEgl = *egl;
  EGLDisplay display = loadedEgl.GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) return eglError("no display without a surface");
  if (loadedEgl.Initialize(display, nullptr, nullptr) == EGL_FALSE) return eglError("the display cannot be opened");
  loadedEgl.BindAPI(EGL_OPENGL_ES_API);
  const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  EGLContext context = loadedEgl.CreateContext(display, EGLConfig(nullptr), EGL_NO_CONTEXT, wanted);
  if (context == EGL_NO_CONTEXT) return eglError("no GLES 3.0 context");
  if (loadedEgl.MakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
    loadedEgl.DestroyContext(display, context);
    return eglError("the context cannot be made current");
  }
  return std::unique_ptr<Context>(new EglContext(display, context));
}

}  // namespace brittle::platform
