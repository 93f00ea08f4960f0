#include "engine/runtime/input_collector.h"

#include <cstddef>

namespace brittle::runtime {

void InputCollector::setView(PictureSize size, float tanHalfWidth) {
  size_ = size;
  tanHalfWidth_ = tanHalfWidth;
}

replay::Throw InputCollector::aimAt(float x, float y) const {
  // Pixels are square, so the height's tangent follows from the width's.
  const float perPixel = 2.0f * tanHalfWidth_ / static_cast<float>(size_.width);
  const float right = (x - 0.5f * static_cast<float>(size_.width)) * perPixel;
  const float up = (0.5f * static_cast<float>(size_.height) - y) * perPixel;
  return replay::quantizeAim(right, up);
}

void InputCollector::add(const Event& event) {
  const auto isOf = [&event](const Held& held) { return held.pointer == event.pointer; };
  if (event.kind == EventKind::PointerDown) pointerDown(event);
  if (event.kind == EventKind::KeyDown && !event.repeated) keyDown(event);
  if (event.kind == EventKind::PointerUp) std::erase_if(held_, isOf);
  if (event.kind == EventKind::PointerMoved)
    for (Held& held : held_)
      if (isOf(held)) held = {held.pointer, event.x, event.y, held.ticks};
}

void InputCollector::pointerDown(const Event& event) {
  if (size_.width <= 0 || size_.height <= 0) return;
  for (std::size_t i = 0; i < controls_.uses.size() && i < replay::kUsePlaces; ++i) {
    const Controls::Spot& spot = controls_.uses[i];
    if (event.x < spot.left || event.x > spot.right || event.y < spot.top || event.y > spot.bottom) continue;
    buttons_ |= replay::useBit(static_cast<int>(i));
    return;
  }
  throws_.push_back(aimAt(event.x, event.y));
  std::erase_if(held_, [&event](const Held& held) { return held.pointer == event.pointer; });
  held_.push_back({event.pointer, event.x, event.y, 0});
}

void InputCollector::keyDown(const Event& event) {
  if (event.key != Key::Character) return;
  if (event.character == 'r') buttons_ |= static_cast<std::uint8_t>(replay::Button::Restart);
  const int place = event.character - '1';
  if (place >= 0 && place < replay::kUsePlaces) buttons_ |= replay::useBit(place);
}

/// Those that stay down throw again when it is time.
void InputCollector::throwHeld() {
  for (Held& held : held_) {
    ++held.ticks;
    if (controls_.throwEvery <= 0 || held.ticks <= controls_.throwEvery || size_.width <= 0) continue;
    held.ticks = 1;
    throws_.push_back(aimAt(held.x, held.y));
  }
}

replay::InputFrame InputCollector::take() {
  throwHeld();
  replay::InputFrame frame;
  frame.buttons = buttons_;
  buttons_ = 0;
  while (!throws_.empty() && frame.throws.size() < static_cast<std::size_t>(replay::kMaxThrows)) {
    frame.throws.push_back(throws_.front());
    throws_.pop_front();
  }
  return frame;
}

void InputCollector::clear() {
  throws_.clear();
  held_.clear();
  buttons_ = 0;
}

}  // namespace brittle::runtime
