// runtime/loop.h - the main loop: events, ticks, picture. Drives anything that ticks and draws; knows neither the game
// nor GL, and its clock is the platform's, so tests run it in made-up time.
#pragma once

#include <vector>

#include "engine/runtime/fixed_step.h"
#include "engine/runtime/frame_times.h"
#include "engine/runtime/input_collector.h"
#include "engine/runtime/platform.h"

namespace brittle::runtime {

/// What a picture shows beside the client's own state.
struct Shown {
  float alpha = 1.0f;  // between the last two ticks: 0 is the one before, 1 the last
  PictureSize size;
  bool paused = false;
  const FrameTimes* times = nullptr;  // null unless the user asked for them
};

/// What the loop runs.
class Client {
 public:
  virtual ~Client() = default;
  virtual void tick(const replay::InputFrame& input) = 0;
  virtual void draw(const Shown& shown) = 0;
  /// Tangent of half the angle between the picture's left and right border, now.
  virtual float tanHalfWidth(PictureSize size) const = 0;
  /// What touches and held pointers mean on a picture of this size, now.
  virtual Controls controls(PictureSize) const { return {}; }
  /// True ends the loop after this frame.
  virtual bool isDone() const = 0;
};

class Loop {
 public:
  Loop(Platform& platform, Client& client);
  /// One frame. False when the window was closed or the client is done.
  bool frame();
  /// By the user, or because the window lost its focus.
  bool isPaused() const { return paused_ || isAway_; }

 private:
  void handleEvents();
  int ticksDue();

  Platform& platform_;
  Client& client_;
  FixedStep step_;
  InputCollector input_;
  std::vector<Event> events_;
  FrameTimer timer_;
  double lastSeconds_;
  bool paused_ = false, isAway_ = false;
  bool quit_ = false, showsTimes_ = false;
};

}  // namespace brittle::runtime
