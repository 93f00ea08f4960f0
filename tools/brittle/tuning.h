// brittle/tuning.h - the settings of accuracy under sliders while a game runs, and what the phases of its ticks cost:
// behind F4. Nothing of it exists before that key is pressed.
#pragma once

#include <memory>

#include "game/sim/game.h"
#include "tools/panels/gui.h"
#include "tools/panels/listening_platform.h"
#include "tools/panels/phases.h"

namespace brittle::program {

class Tuning {
 public:
  /// `window` must outlive it.
  explicit Tuning(runtime::Platform& window);

  /// The window, less what is meant for the panels.
  runtime::Platform& platform() { return listening_; }
  /// Around each tick.
  void tickBegins();
  void tickEnds();
  /// Applies what the user sets. The panels on top of the picture; null while they are hidden.
  const render::Overlay* build(sim::Game& game, runtime::PictureSize size);
  /// Whether the last build changed the game's accuracy.
  bool hasChanged() const { return hasChanged_; }

 private:
  struct Panels {
    panels::Gui gui;
    panels::Phases phases;
  };
  bool hear(const runtime::Event& event);

  runtime::Platform& window_;
  panels::ListeningPlatform listening_;
  std::unique_ptr<Panels> panels_;  // while they are seen
  bool hasChanged_ = false;
};

}  // namespace brittle::program
