// runtime/platform.h - what a platform must provide: a picture to draw into, the raw events of the user, and time.
// Implemented by platform/*; used by the main loop. Nothing here knows the game, and nothing of the simulation may see
// it.
#pragma once

#include <cstdint>
#include <vector>

namespace brittle::runtime {

enum class EventKind : std::uint8_t {
  Quit,
  Resized,
  FocusLost,
  FocusGained,
  PointerDown,
  PointerMoved,
  PointerUp,
  KeyDown,
  KeyUp
};

/// The keys the runtime knows; printable ones carry their character in Event::character.
enum class Key : std::uint8_t {
  Other,
  Character,
  Escape,
  Enter,
  Space,
  Backspace,
  Left,
  Right,
  Up,
  Down,
  Back,
  F3,
  F4
};

/// The mouse's pointer; fingers count from 1, each keeping its number while it touches.
inline constexpr std::uint32_t kMousePointer = 0;

/// One raw event. Which members mean something depends on the kind.
struct Event {
  EventKind kind = EventKind::Quit;
  std::uint32_t pointer = kMousePointer;  // Pointer*
  float x = 0.0f, y = 0.0f;               // Pointer*: [pixels of the picture] from its top left corner
  Key key = Key::Other;                   // Key*
  char character = 0;                     // Key*, Key::Character: lower-case ASCII
  bool repeated = false;                  // KeyDown: sent by auto-repeat
  int width = 0, height = 0;              // Resized: [pixels]
};

/// Size of the picture. [pixels]
struct PictureSize {
  int width = 0, height = 0;
  friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// Finds a GL function by name; null if there is none.
using GlLoader = void* (*)(const char* name);

class Platform {
 public:
  virtual ~Platform() = default;

  /// The drawable size, which on dense displays differs from the window's.
  virtual PictureSize size() const = 0;
  /// Appends what happened since the last call, in order. A mouse click that the system made from a touch is left out.
  virtual void pollEvents(std::vector<Event>& events) = 0;
  /// Shows what was drawn; where there is a display, at most once per refresh.
  virtual void swap() = 0;
  /// GL functions of the context, which is current on the calling thread.
  virtual GlLoader glLoader() const = 0;
  /// Whether framebuffer 0 is shown; without it (off-screen) the renderer must draw into one of its own.
  virtual bool hasDefaultFramebuffer() const = 0;
  /// Monotonic time since start. [s]
  virtual double seconds() const = 0;
  /// Gives the processor away for about that long. [s]
  virtual void sleep(double seconds) = 0;
};

}  // namespace brittle::runtime
