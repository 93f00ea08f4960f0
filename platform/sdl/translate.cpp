#include "platform/sdl/translate.h"

namespace brittle::platform {

using runtime::Event;
using runtime::EventKind;
using runtime::Key;

namespace {

Key keyOf(SDL_Keycode code) {
  switch (code) {
    case SDLK_ESCAPE:
      return Key::Escape;
    case SDLK_RETURN:
    case SDLK_KP_ENTER:
      return Key::Enter;
    case SDLK_SPACE:
      return Key::Space;
    case SDLK_BACKSPACE:
      return Key::Backspace;
    case SDLK_LEFT:
      return Key::Left;
    case SDLK_RIGHT:
      return Key::Right;
    case SDLK_UP:
      return Key::Up;
    case SDLK_DOWN:
      return Key::Down;
    case SDLK_AC_BACK:
      return Key::Back;
    case SDLK_F3:
      return Key::F3;
    case SDLK_F4:
      return Key::F4;
    default:
      return code > SDLK_SPACE && code < SDLK_DELETE ? Key::Character : Key::Other;
  }
}

}  // namespace

void EventTranslator::setSizes(runtime::PictureSize window, runtime::PictureSize picture) {
  window_ = window;
  picture_ = picture;
}

void EventTranslator::addPointer(EventKind kind, std::uint32_t pointer, float x, float y,
                                 std::vector<Event>& out) const {
  Event event;
  event.kind = kind;
  event.pointer = pointer;
  event.x = x * static_cast<float>(picture_.width);
  event.y = y * static_cast<float>(picture_.height);
  out.push_back(event);
}

std::size_t EventTranslator::slotOf(SDL_FingerID id) {
  for (std::size_t i = 0; i < fingers_.size(); ++i) {
    if (fingers_[i].isDown && fingers_[i].id == id) return i;
  }
  for (std::size_t i = 0; i < fingers_.size(); ++i) {
    if (!fingers_[i].isDown) return i;
  }
  fingers_.push_back({id, false});
  return fingers_.size() - 1;
}

void EventTranslator::addFinger(const SDL_TouchFingerEvent& finger, std::vector<Event>& out) {
  const std::size_t slot = slotOf(finger.fingerId);
  // A move or a lift of a finger that never went down (the window got focus in between) means nothing.
  if (finger.type != SDL_FINGERDOWN && !fingers_[slot].isDown) return;
  fingers_[slot] = {finger.fingerId, finger.type != SDL_FINGERUP};
  const EventKind kind = finger.type == SDL_FINGERDOWN ? EventKind::PointerDown
                         : finger.type == SDL_FINGERUP ? EventKind::PointerUp
                                                       : EventKind::PointerMoved;
  addPointer(kind, static_cast<std::uint32_t>(slot) + 1, finger.x, finger.y, out);
}

void EventTranslator::addMouseButton(const SDL_MouseButtonEvent& button, std::vector<Event>& out) {
  if (button.which == SDL_TOUCH_MOUSEID || button.button != SDL_BUTTON_LEFT) return;
  const EventKind kind = button.type == SDL_MOUSEBUTTONDOWN ? EventKind::PointerDown : EventKind::PointerUp;
  addPointer(kind, runtime::kMousePointer, static_cast<float>(button.x) / static_cast<float>(window_.width),
             static_cast<float>(button.y) / static_cast<float>(window_.height), out);
}

void EventTranslator::addKey(const SDL_KeyboardEvent& key, std::vector<Event>& out) const {
  Event event;
  event.kind = key.type == SDL_KEYDOWN ? EventKind::KeyDown : EventKind::KeyUp;
  event.key = keyOf(key.keysym.sym);
  if (event.key == Key::Character) event.character = static_cast<char>(key.keysym.sym);
  event.repeated = key.repeat != 0;
  out.push_back(event);
}

void EventTranslator::addWindow(const SDL_WindowEvent& window, std::vector<Event>& out) {
  Event event;
  switch (window.event) {
    case SDL_WINDOWEVENT_FOCUS_LOST:
      event.kind = EventKind::FocusLost;
      break;
    case SDL_WINDOWEVENT_FOCUS_GAINED:
      event.kind = EventKind::FocusGained;
      break;
    case SDL_WINDOWEVENT_SIZE_CHANGED:
      event.kind = EventKind::Resized;
      event.width = picture_.width;
      event.height = picture_.height;
      break;
    default:
      return;
  }
  out.push_back(event);
}

void EventTranslator::translate(const SDL_Event& event, std::vector<Event>& out) {
  switch (event.type) {
    case SDL_QUIT:
      out.push_back({});
      break;
    case SDL_WINDOWEVENT:
      addWindow(event.window, out);
      break;
    case SDL_FINGERDOWN:
    case SDL_FINGERMOTION:
    case SDL_FINGERUP:
      addFinger(event.tfinger, out);
      break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      addMouseButton(event.button, out);
      break;
    case SDL_MOUSEMOTION:
      if (event.motion.which == SDL_TOUCH_MOUSEID) break;
      addPointer(EventKind::PointerMoved, runtime::kMousePointer,
                 static_cast<float>(event.motion.x) / static_cast<float>(window_.width),
                 static_cast<float>(event.motion.y) / static_cast<float>(window_.height), out);
      break;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      addKey(event.key, out);
      break;
    default:
      break;
  }
}

}  // namespace brittle::platform
