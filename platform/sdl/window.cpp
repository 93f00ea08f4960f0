#include "platform/sdl/window.h"

#include <SDL.h>

#include <chrono>
#include <thread>

#include "engine/runtime/pace.h"
#include "platform/sdl/translate.h"

namespace brittle::platform {

namespace {

using runtime::PictureSize;

/// SDL itself, started and stopped with the window.
class Session {
 public:
  bool start() {
    SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");  // touches are touches; the translator drops what still comes
    SDL_SetHintWithPriority(SDL_HINT_VIDEODRIVER, driversThatShow().c_str(),
                            SDL_HINT_DEFAULT);  // the user's own word counts more
    isOn_ = SDL_InitSubSystem(SDL_INIT_VIDEO | SDL_INIT_TIMER) == 0;
    return isOn_;
  }
  ~Session() {
    if (isOn_) SDL_QuitSubSystem(SDL_INIT_VIDEO | SDL_INIT_TIMER);
  }

 private:
  /// Where no display answers SDL would fall back to drivers that show nothing: the game would run on where nobody can
  /// see or end it.
  static std::string driversThatShow() {
    std::string names;
    for (int i = 0; i < SDL_GetNumVideoDrivers(); ++i) {
      const std::string name = SDL_GetVideoDriver(i);
      const bool isUnasked =
          name == "wayland" && SDL_getenv("WAYLAND_DISPLAY") == nullptr;  // its library complains aloud
      if (name != "offscreen" && name != "dummy" && name != "evdev" && !isUnasked)
        names += (names.empty() ? "" : ",") + name;
    }
    return names;
  }

  bool isOn_ = false;
};

class Window : public runtime::Platform {
 public:
  Window() = default;
  ~Window() override {
    if (context_ != nullptr) SDL_GL_DeleteContext(context_);
    if (window_ != nullptr) SDL_DestroyWindow(window_);
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  Status open(const WindowDef& def);

  PictureSize size() const override {
    PictureSize size;
    SDL_GL_GetDrawableSize(window_, &size.width, &size.height);
    return size;
  }
  void pollEvents(std::vector<runtime::Event>& events) override {
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0) {
      if (event.type == SDL_WINDOWEVENT) updateSizes();
      translator_.translate(event, events);
    }
  }
  void swap() override {
    SDL_GL_SwapWindow(window_);
    if (isPaced_) sleep(pace_.rest(seconds()));  // drivers promise vertical sync that they do not have
  }
  runtime::GlLoader glLoader() const override { return SDL_GL_GetProcAddress; }
  bool hasDefaultFramebuffer() const override { return true; }
  double seconds() const override {
    return static_cast<double>(SDL_GetPerformanceCounter() - start_) /
           static_cast<double>(SDL_GetPerformanceFrequency());
  }
  void sleep(double seconds) override {
    if (seconds > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  }

 private:
  void updateSizes() {
    PictureSize points;
    SDL_GetWindowSize(window_, &points.width, &points.height);
    translator_.setSizes(points, size());
    SDL_DisplayMode display{};
    const bool isKnown = SDL_GetCurrentDisplayMode(SDL_GetWindowDisplayIndex(window_), &display) == 0;
    pace_.setPeriod(1.0 / (isKnown && display.refresh_rate > 0 ? display.refresh_rate : 60));
  }

  Session session_;
  SDL_Window* window_ = nullptr;
  SDL_GLContext context_ = nullptr;
  EventTranslator translator_;
  runtime::Pace pace_;
  bool isPaced_ = false;
  Uint64 start_ = SDL_GetPerformanceCounter();
};

Error sdlError(const std::string& what) {
  return {what + ": " + SDL_GetError()};
}

Status Window::open(const WindowDef& def) {
  if (!session_.start()) {
    return Error{sdlError("no display").message + " (SDL_VIDEODRIVER=offscreen runs without one)"};
  }
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);  // depth lives in the renderer's own framebuffers
  Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
  if (def.fullscreen) flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
  window_ = SDL_CreateWindow(def.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, def.size.width,
                             def.size.height, flags);
  if (window_ == nullptr) return sdlError("no window");
  context_ = SDL_GL_CreateContext(window_);
  if (context_ == nullptr) return sdlError("no GLES 3.0 context (apt-get install libgl1-mesa-dri libegl-mesa0)");
  SDL_GL_SetSwapInterval(def.verticalSync ? 1 : 0);
  isPaced_ = def.verticalSync;
  updateSizes();
  return Done{};
}

}  // namespace

Result<std::unique_ptr<runtime::Platform>> openWindow(const WindowDef& def) {
  if (def.size.width <= 0 || def.size.height <= 0) {
    return Error{"window size " + std::to_string(def.size.width) + " x " + std::to_string(def.size.height) +
                 ": both must be at least 1"};
  }
  std::unique_ptr<Window> window(new Window);
  const Status opened = window->open(def);
  if (!opened) return opened.error();
  return std::unique_ptr<runtime::Platform>(std::move(window));
}

}  // namespace brittle::platform
