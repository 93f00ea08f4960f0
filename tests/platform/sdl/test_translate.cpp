#include "platform/sdl/translate.h"

#include <gtest/gtest.h>

namespace brittle::platform {
namespace {

using runtime::Event;
using runtime::EventKind;
using runtime::Key;

class Translate : public ::testing::Test {
 protected:
  Translate() { translator_.setSizes({640, 360}, {1280, 720}); }  // a dense display: two pixels a point

  std::vector<Event> of(const SDL_Event& event) {
    std::vector<Event> out;
    translator_.translate(event, out);
    return out;
  }
  std::vector<Event> finger(Uint32 type, SDL_FingerID id, float x, float y) {
    SDL_Event event{};
    event.tfinger.type = type;
    event.tfinger.fingerId = id;
    event.tfinger.x = x;
    event.tfinger.y = y;
    return of(event);
  }
  std::vector<Event> click(Uint32 type, Uint8 button, Uint32 which, int x, int y) {
    SDL_Event event{};
    event.button.type = type;
    event.button.button = button;
    event.button.which = which;
    event.button.x = x;
    event.button.y = y;
    return of(event);
  }
  std::vector<Event> key(Uint32 type, SDL_Keycode code, Uint8 repeat = 0) {
    SDL_Event event{};
    event.key.type = type;
    event.key.keysym.sym = code;
    event.key.repeat = repeat;
    return of(event);
  }

  EventTranslator translator_;
};

TEST_F(Translate, CountsTheMouseInPixelsOfThePicture) {
  const std::vector<Event> events = click(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT, 0, 160, 90);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, EventKind::PointerDown);
  EXPECT_EQ(events[0].pointer, runtime::kMousePointer);
  EXPECT_FLOAT_EQ(events[0].x, 320.0f);
  EXPECT_FLOAT_EQ(events[0].y, 180.0f);
}

TEST_F(Translate, LeavesOutClicksMadeFromTouchesAndOtherButtons) {
  EXPECT_TRUE(click(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT, SDL_TOUCH_MOUSEID, 10, 10).empty());
  EXPECT_TRUE(click(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_RIGHT, 0, 10, 10).empty());
  SDL_Event motion{};
  motion.motion.type = SDL_MOUSEMOTION;
  motion.motion.which = SDL_TOUCH_MOUSEID;
  EXPECT_TRUE(of(motion).empty());
}

TEST_F(Translate, NumbersFingersFromOneAndReusesNumbers) {
  EXPECT_EQ(finger(SDL_FINGERDOWN, 77, 0.25f, 0.5f).at(0).pointer, 1u);
  EXPECT_EQ(finger(SDL_FINGERDOWN, 13, 0.5f, 0.5f).at(0).pointer, 2u);
  EXPECT_EQ(finger(SDL_FINGERMOTION, 13, 0.6f, 0.5f).at(0).pointer, 2u);
  EXPECT_EQ(finger(SDL_FINGERUP, 77, 0.25f, 0.5f).at(0).kind, EventKind::PointerUp);
  EXPECT_EQ(finger(SDL_FINGERDOWN, 99, 0.25f, 0.5f).at(0).pointer, 1u);
  EXPECT_FLOAT_EQ(finger(SDL_FINGERMOTION, 13, 0.5f, 0.25f).at(0).x, 640.0f);
}

TEST_F(Translate, IgnoresFingersThatNeverWentDown) {
  EXPECT_TRUE(finger(SDL_FINGERUP, 5, 0.5f, 0.5f).empty());
  EXPECT_TRUE(finger(SDL_FINGERMOTION, 5, 0.5f, 0.5f).empty());
}

TEST_F(Translate, NamesKeysAndRepeats) {
  EXPECT_EQ(key(SDL_KEYDOWN, SDLK_r).at(0).key, Key::Character);
  EXPECT_EQ(key(SDL_KEYDOWN, SDLK_r).at(0).character, 'r');
  EXPECT_EQ(key(SDL_KEYUP, SDLK_ESCAPE).at(0).key, Key::Escape);
  EXPECT_EQ(key(SDL_KEYUP, SDLK_ESCAPE).at(0).kind, EventKind::KeyUp);
  EXPECT_EQ(key(SDL_KEYDOWN, SDLK_SPACE).at(0).key, Key::Space);
  EXPECT_EQ(key(SDL_KEYDOWN, SDLK_F3).at(0).key, Key::F3);
  EXPECT_EQ(key(SDL_KEYDOWN, SDLK_F4).at(0).key, Key::F4);
  EXPECT_EQ(key(SDL_KEYDOWN, SDLK_F5).at(0).key, Key::Other);
  EXPECT_TRUE(key(SDL_KEYDOWN, SDLK_a, 1).at(0).repeated);
}

TEST_F(Translate, TellsFocusQuitAndSize) {
  SDL_Event event{};
  event.window.type = SDL_WINDOWEVENT;
  event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
  EXPECT_EQ(of(event).at(0).kind, EventKind::FocusLost);
  event.window.event = SDL_WINDOWEVENT_FOCUS_GAINED;
  EXPECT_EQ(of(event).at(0).kind, EventKind::FocusGained);
  event.window.event = SDL_WINDOWEVENT_SIZE_CHANGED;
  EXPECT_EQ(of(event).at(0).kind, EventKind::Resized);
  EXPECT_EQ(of(event).at(0).width, 1280);
  event.window.event = SDL_WINDOWEVENT_ENTER;
  EXPECT_TRUE(of(event).empty());
  event.type = SDL_QUIT;
  EXPECT_EQ(of(event).at(0).kind, EventKind::Quit);
}

}  // namespace
}  // namespace brittle::platform
