// runtime/input_collector.h - raw events in, one input frame per tick out. Turns a touched pixel into an aim in the
// view's tangent plane, so that nothing after it knows how large the picture is.
#pragma once

#include <deque>
#include <vector>

#include "engine/replay/input_frame.h"
#include "engine/runtime/platform.h"

namespace brittle::runtime {

/// What the next events mean beside throws.
struct Controls {
  struct Spot {
    float left = 0.0f, top = 0.0f, right = 0.0f, bottom = 0.0f;  // [pixels], y down
  };
  std::vector<Spot> uses;  // a touch there uses what is held in that place, and throws nothing
  int throwEvery = 0;      // a pointer that stays down throws again after so many ticks; 0: not
};

class InputCollector {
 public:
  /// The picture the following events refer to. `tanHalfWidth`: tangent of half the angle from its left border to its
  /// right.
  void setView(PictureSize size, float tanHalfWidth);
  void setControls(Controls controls) { controls_ = std::move(controls); }
  /// A pointer that goes down throws, or uses what it touches; 1 to 4 use what is held in these places; R asks for a
  /// restart; the rest is not for the simulation.
  void add(const Event& event);
  /// The next tick's: everything since the last call, in order; throws beyond kMaxThrows wait for the next tick.
  replay::InputFrame take();
  /// Forgets what was not taken.
  void clear();

 private:
  struct Held {
    std::uint32_t pointer = 0;
    float x = 0.0f, y = 0.0f;  // [pixels]
    int ticks = 0;             // since it threw
  };
  void pointerDown(const Event& event);
  void keyDown(const Event& event);
  void throwHeld();
  replay::Throw aimAt(float x, float y) const;

  PictureSize size_;
  Controls controls_;
  std::vector<Held> held_;  // pointers that went down to throw
  float tanHalfWidth_ = 1.0f;
  std::deque<replay::Throw> throws_;
  std::uint8_t buttons_ = 0;
};

}  // namespace brittle::runtime
