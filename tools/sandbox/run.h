// sandbox/run.h - what the sandbox plays: a scene of the accuracy study, or a recorded game.
#pragma once

#include <cstdint>

#include "engine/physics/accuracy.h"
#include "engine/render/overlay.h"
#include "engine/render/renderer.h"
#include "engine/runtime/platform.h"

namespace brittle::sandbox {

class Run {
 public:
  virtual ~Run() = default;
  /// Ticks done, and the last one that can be sought.
  virtual std::uint32_t tick() const = 0;
  virtual std::uint32_t end() const = 0;
  /// Not beyond the end of a recorded game.
  virtual void step() = 0;
  /// To any tick up to end().
  virtual void seek(std::uint32_t tick) = 0;
  /// From the beginning, with the settings as they are now.
  virtual void restart() = 0;
  virtual physics::Accuracy accuracy() const = 0;
  virtual void setAccuracy(const physics::Accuracy& accuracy) = 0;
  /// A ball towards a place of the picture; fractions from its middle, in half widths and half heights, up is positive.
  virtual void throwBall(float right, float up) = 0;
  /// Turns the view by steps.
  virtual void orbit(int right, int up) = 0;
  /// Its own widgets, between Gui::begin and end.
  virtual void showPanel() = 0;
  virtual void draw(render::Renderer& renderer, runtime::PictureSize size, const render::Overlay* overlay) = 0;
};

}  // namespace brittle::sandbox
