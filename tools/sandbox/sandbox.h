// sandbox/sandbox.h - a run under glass: pause, single steps forward and back, settings, costs. Keys: space pauses, .
// and , step on and back, R restarts, B throws a ball through the middle, a click throws one there, arrows turn the
// view.
#pragma once

#include "engine/runtime/loop.h"
#include "tools/panels/gui.h"
#include "tools/panels/phases.h"
#include "tools/sandbox/run.h"

namespace brittle::sandbox {

class Sandbox : public runtime::Client {
 public:
  /// All must outlive it. `frames`: ends after so many pictures; 0: when the window is closed.
  Sandbox(Run& run, render::Renderer& renderer, panels::Gui& gui, runtime::Platform& platform, std::uint32_t frames)
      : run_(run), renderer_(renderer), gui_(gui), platform_(platform), frames_(frames), size_(platform.size()) {}

  /// Before the loop hears it. True: it is none of the loop's business.
  bool hear(const runtime::Event& event);
  void tick(const replay::InputFrame&) override;
  void draw(const runtime::Shown& shown) override;
  float tanHalfWidth(runtime::PictureSize) const override { return 1.0f; }  // the loop's own throws are not used
  bool isDone() const override { return frames_ != 0 && drawn_ >= frames_; }
  void setPaused(bool paused) { isPaused_ = paused; }

 private:
  bool press(const runtime::Event& event);
  void play();
  void step();
  void back();
  void showControls();
  void showSettings();

  Run& run_;
  render::Renderer& renderer_;
  panels::Gui& gui_;
  runtime::Platform& platform_;
  panels::Phases phases_;
  const std::uint32_t frames_;
  std::uint32_t drawn_ = 0, ticks_ = 0;
  runtime::PictureSize size_;  // that the renderer draws: at first the platform's
  bool isPaused_ = false;
  int slowness_ = 1;  // ticks of the loop to one of the run
};

}  // namespace brittle::sandbox
