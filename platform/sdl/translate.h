// platform/sdl/translate.h - SDL events to the runtime's. Pure but for finger numbers, so tests need no window.
#pragma once

#include <SDL.h>

#include <vector>

#include "engine/runtime/platform.h"

namespace brittle::platform {

class EventTranslator {
 public:
  /// `window`: size in points, what mouse events count in. `picture`: size in pixels, what the runtime counts in.
  void setSizes(runtime::PictureSize window, runtime::PictureSize picture);

  /// Appends what `event` means, if anything. Mouse events that SDL makes from touches are left out, and of the mouse
  /// only the left button counts. Fingers get the lowest free number from 1 and keep it until they leave.
  void translate(const SDL_Event& event, std::vector<runtime::Event>& out);

 private:
  void addPointer(runtime::EventKind kind, std::uint32_t pointer, float x, float y,
                  std::vector<runtime::Event>& out) const;
  void addFinger(const SDL_TouchFingerEvent& finger, std::vector<runtime::Event>& out);
  void addMouseButton(const SDL_MouseButtonEvent& button, std::vector<runtime::Event>& out);
  void addKey(const SDL_KeyboardEvent& key, std::vector<runtime::Event>& out) const;
  void addWindow(const SDL_WindowEvent& window, std::vector<runtime::Event>& out);
  std::size_t slotOf(SDL_FingerID id);

  runtime::PictureSize window_{1, 1}, picture_{1, 1};
  struct Finger {
    SDL_FingerID id;
    bool isDown;
  };
  std::vector<Finger> fingers_;  // by number - 1
};

}  // namespace brittle::platform
