// panels/gui.h - Dear ImGui between our platform and our renderer: the runtime's events in, an overlay out. Widgets are
// called between begin and end.
#pragma once

#include "engine/render/overlay.h"
#include "engine/runtime/platform.h"

namespace brittle::panels {

/// One may live at a time.
class Gui {
 public:
  Gui();
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// True: the event is for the widgets alone.
  bool take(const runtime::Event& event);
  /// `seconds`: of any monotonic clock.
  void begin(runtime::PictureSize size, double seconds);
  /// Valid until the next begin.
  const render::Overlay& end();

 private:
  render::Overlay overlay_;
  double lastSeconds_ = 0.0;
  bool isDown_ = false, wasPressed_ = false;  // pressed and let go between two frames counts as pressed
  bool isOurs_ = false;                       // what was pressed last, until it is let go
};

}  // namespace brittle::panels
