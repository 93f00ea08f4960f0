// runtime/input_collector.h - raw events in, one input frame per tick out. Turns a touched pixel into an aim in the
// view's tangent plane, so that nothing after it knows how large the picture is.
#pragma once

#include <deque>

#include "engine/replay/input_frame.h"
#include "engine/runtime/platform.h"

namespace brittle::runtime {

class InputCollector {
 public:
  /// The picture the following events refer to. `tanHalfWidth`: tangent of half the angle from its left border to its
  /// right.
  void setView(PictureSize size, float tanHalfWidth);
  /// A pointer that goes down throws; R asks for a restart; the rest is not for the simulation.
  void add(const Event& event);
  /// Everything since the last call, in order; throws beyond kMaxThrows wait for the next tick.
  replay::InputFrame take();
  /// Forgets what was not taken.
  void clear();

 private:
  PictureSize size_;
  float tanHalfWidth_ = 1.0f;
  std::deque<replay::Throw> throws_;
  std::uint8_t buttons_ = 0;
};

}  // namespace brittle::runtime
