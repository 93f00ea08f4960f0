#include "engine/runtime/input_collector.h"

namespace brittle::runtime {

void InputCollector::setView(PictureSize size, float tanHalfWidth) {
  size_ = size;
  tanHalfWidth_ = tanHalfWidth;
}

void InputCollector::add(const Event& event) {
  if (event.kind == EventKind::PointerDown && size_.width > 0 && size_.height > 0) {
    // Pixels are square, so the height's tangent follows from the width's.
    const float perPixel = 2.0f * tanHalfWidth_ / static_cast<float>(size_.width);
    const float right = (event.x - 0.5f * static_cast<float>(size_.width)) * perPixel;
    const float up = (0.5f * static_cast<float>(size_.height) - event.y) * perPixel;
    throws_.push_back(replay::quantizeAim(right, up));
  }
  if (event.kind == EventKind::KeyDown && event.key == Key::Character && event.character == 'r' && !event.repeated)
    buttons_ |= static_cast<std::uint8_t>(replay::Button::Restart);
}

replay::InputFrame InputCollector::take() {
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
  buttons_ = 0;
}

}  // namespace brittle::runtime
