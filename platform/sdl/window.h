// platform/sdl/window.h - a window with a GLES 3.0 context, and its events as the runtime's. Works on X11, Wayland, a
// bare console and without any display (SDL_VIDEODRIVER=offscreen).
#pragma once

#include <memory>
#include <string>

#include "engine/core/result.h"
#include "engine/runtime/platform.h"

namespace brittle::platform {

struct WindowDef {
  std::string title = "Brittle";
  runtime::PictureSize size = {1280, 720};  // of the window [points]; the picture may have more pixels
  bool fullscreen = false;
  bool verticalSync = true;  // one frame per refresh of the display, by its own clock or by ours
};

/// Opens a window and makes its context current on the calling thread. One may live at a time. Fails with SDL's words
/// and, where there is no display, with how to run without one.
Result<std::unique_ptr<runtime::Platform>> openWindow(const WindowDef& def);

}  // namespace brittle::platform
