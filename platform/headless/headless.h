// platform/headless/headless.h - a platform without display, window or user: a GL context to draw into textures, real
// time, and no events but those a test sends. EGL surfaceless is the main path; OSMesa works where no EGL device can be
// opened; null takes every GL call, draws nothing and needs no driver (pictures stay black). The libraries are opened
// at run time, so one that is missing is a message and not a program that cannot start.
#pragma once

#include <memory>

#include "engine/core/result.h"
#include "engine/runtime/platform.h"

namespace brittle::platform {

enum class HeadlessBackend { Egl, OsMesa, Null };

/// "egl", "osmesa" or "null".
const char* nameOf(HeadlessBackend backend);

class Headless : public runtime::Platform {
 public:
  /// What pollEvents will give next, for scripted runs.
  virtual void send(const runtime::Event& event) = 0;
};

/// Makes a GLES 3.0 context (OSMesa: a core profile that takes GLES 3 shaders) current on the calling thread. `size` in
/// pixels is what size() answers and has no other meaning, since there is no framebuffer 0. Destroying it releases the
/// context; only one may live at a time. Fails with what is missing and the package that brings it.
Result<std::unique_ptr<Headless>> createHeadless(HeadlessBackend backend, runtime::PictureSize size);

}  // namespace brittle::platform
