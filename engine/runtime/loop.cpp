#include "engine/runtime/loop.h"

namespace brittle::runtime {
namespace {

constexpr double kShortestFrame = 1.0 / 250.0;  // [s]

}  // namespace

Loop::Loop(Platform& platform, Client& client)
    : platform_(platform), client_(client), lastSeconds_(platform.seconds()) {}

bool Loop::frame() {
  handleEvents();
  int due = ticksDue();
  timer_.begins(lastSeconds_);
  for (; due > 0; --due) client_.tick(input_.take());
  timer_.simulated(platform_.seconds());
  client_.draw({step_.alpha(), platform_.size(), isPaused(), showsTimes_ ? &timer_.times() : nullptr});
  timer_.drawn(platform_.seconds());
  platform_.swap();
  timer_.swapped(platform_.seconds());
  // Where the display does not hold frames back, nothing else would.
  platform_.sleep(kShortestFrame - (platform_.seconds() - lastSeconds_));
  return !quit_ && !client_.isDone();
}

/// Time passes while the loop is paused, but no tick becomes due: play goes on where it stopped.
int Loop::ticksDue() {
  const double now = platform_.seconds();
  const double elapsed = now - lastSeconds_;
  lastSeconds_ = now;
  return isPaused() ? 0 : step_.advance(elapsed);
}

void Loop::handleEvents() {
  events_.clear();
  platform_.pollEvents(events_);
  input_.setView(platform_.size(), client_.tanHalfWidth(platform_.size()));
  input_.setControls(client_.controls(platform_.size()));
  for (const Event& event : events_) {
    const bool pressed = event.kind == EventKind::KeyDown && !event.repeated;
    const bool leaves = pressed && (event.key == Key::Escape || event.key == Key::Back);
    if (event.kind == EventKind::Quit || leaves) {
      quit_ = true;
    } else if (event.kind == EventKind::FocusLost) {
      isAway_ = true;
      input_.clear();
    } else if (event.kind == EventKind::FocusGained) {
      isAway_ = false;
    } else if (pressed && event.key == Key::Character && event.character == 'p') {
      paused_ = !paused_;
    } else if (pressed && event.key == Key::F3) {
      showsTimes_ = !showsTimes_;
    } else if (!isPaused()) {
      input_.add(event);
    } else if (event.kind == EventKind::PointerDown) {
      paused_ = isAway_ = false;  // the touch that comes back to the game is not a throw
    }
  }
}

}  // namespace brittle::runtime
