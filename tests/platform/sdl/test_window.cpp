// A real window and context, without a display unless the caller set SDL_VIDEODRIVER (xvfb-run sets none: then DISPLAY
// decides).
#include "platform/sdl/window.h"

#include <SDL.h>

#include <cstdlib>

#include <gtest/gtest.h>

#include "engine/render/gl.h"
#include "engine/render/renderer.h"

namespace brittle::platform {
namespace {

using runtime::Event;
using runtime::EventKind;

class SdlWindow : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("DISPLAY") == nullptr) setenv("SDL_VIDEODRIVER", "offscreen", 0);
    auto window = openWindow({.title = "brittle test", .size = {320, 180}, .verticalSync = false});
    ASSERT_TRUE(window) << window.error().message;
    window_ = std::move(*window);
    std::vector<Event> first;
    window_->pollEvents(first);  // what opening itself causes
  }

  std::vector<Event> poll() {
    std::vector<Event> events;
    window_->pollEvents(events);
    return events;
  }
  static bool has(const std::vector<Event>& events, EventKind kind) {
    for (const Event& event : events) {
      if (event.kind == kind) return true;
    }
    return false;
  }

  std::unique_ptr<runtime::Platform> window_;
};

TEST_F(SdlWindow, DrawsAFrameAndShowsIt) {
  Result<render::Gl> gl = render::loadGl(window_->glLoader());
  ASSERT_TRUE(gl) << gl.error().message;
  EXPECT_NE(gl->description.find("OpenGL ES 3"), std::string::npos) << gl->description;
  const runtime::PictureSize size = window_->size();
  EXPECT_EQ(size, (runtime::PictureSize{320, 180}));
  const auto renderer = render::Renderer::create(*gl, {.width = size.width, .height = size.height, .offscreen = false});
  ASSERT_TRUE(renderer) << renderer.error().message;
  render::Frame frame;
  frame.quads.push_back(
      {{Vec2(0.5f, 0.5f), Vec2::Zero()}, Vec2(0.4f, 0.4f), render::packRgba(render::Rgb(1.0f, 0.0f, 0.0f))});
  (*renderer)->draw(frame);
  const render::Image image = (*renderer)->readBack();
  EXPECT_EQ(image.at(160, 90)[0], 255);
  EXPECT_EQ(image.at(160, 90)[1], 0);
  EXPECT_GT(image.at(160, 5)[1], 100);  // fog at the top
  window_->swap();
  EXPECT_EQ(render::glErrorName(gl->GetError()), "no error");
}

TEST_F(SdlWindow, PassesOnPushedEvents) {
  SDL_Event event{};
  event.type = SDL_FINGERDOWN;
  event.tfinger.fingerId = 4;
  event.tfinger.x = 0.5f;
  event.tfinger.y = 0.25f;
  SDL_PushEvent(&event);
  event = {};
  event.type = SDL_KEYDOWN;
  event.key.keysym.sym = SDLK_SPACE;
  SDL_PushEvent(&event);
  event = {};
  event.type = SDL_QUIT;
  SDL_PushEvent(&event);
  const std::vector<Event> events = poll();
  ASSERT_TRUE(has(events, EventKind::PointerDown));
  EXPECT_TRUE(has(events, EventKind::KeyDown));
  EXPECT_TRUE(has(events, EventKind::Quit));
  for (const Event& e : events) {
    if (e.kind != EventKind::PointerDown) continue;
    EXPECT_FLOAT_EQ(e.x, 160.0f);
    EXPECT_FLOAT_EQ(e.y, 45.0f);
  }
}

TEST_F(SdlWindow, TellsItsNewSize) {
  SDL_Window* window = SDL_GL_GetCurrentWindow();
  ASSERT_NE(window, nullptr);
  SDL_SetWindowSize(window, 200, 120);
  std::vector<Event> events;
  for (int i = 0; i < 50 && !has(events, EventKind::Resized); ++i) {  // an X server answers when it likes
    window_->pollEvents(events);
    window_->sleep(0.01);
  }
  ASSERT_TRUE(has(events, EventKind::Resized));
  EXPECT_EQ(window_->size(), (runtime::PictureSize{200, 120}));
}

TEST_F(SdlWindow, KeepsTime) {
  const double before = window_->seconds();
  window_->sleep(0.02);
  EXPECT_GE(window_->seconds() - before, 0.019);
}

TEST(OpenWindow, RefusesAnEmptyOne) {
  const auto window = openWindow({.size = {0, 100}});
  ASSERT_FALSE(window);
  EXPECT_EQ(window.error().message, "window size 0 x 100: both must be at least 1");
}

TEST(OpenWindow, SaysWhatIsWrongWithTheDisplay) {
  const char* old = std::getenv("SDL_VIDEODRIVER");
  const std::string saved = old != nullptr ? old : "";
  setenv("SDL_VIDEODRIVER", "nosuchdriver", 1);
  const auto window = openWindow({});
  ASSERT_FALSE(window);
  EXPECT_NE(window.error().message.find("SDL_VIDEODRIVER=offscreen"), std::string::npos) << window.error().message;
  if (saved.empty())
    unsetenv("SDL_VIDEODRIVER");
  else
    setenv("SDL_VIDEODRIVER", saved.c_str(), 1);
}

TEST(OpenWindow, DoesNotPlayWhereNobodyCanSee) {
  std::vector<std::pair<const char*, std::string>> saved;
  for (const char* name : {"SDL_VIDEODRIVER", "DISPLAY", "WAYLAND_DISPLAY"}) {
    const char* value = std::getenv(name);
    saved.push_back({name, value != nullptr ? value : ""});
    unsetenv(name);
  }
  setenv("DISPLAY", ":4711", 1);  // nobody's
  const auto window = openWindow({});
  ASSERT_FALSE(window);
  EXPECT_NE(window.error().message.find("no display: "), std::string::npos) << window.error().message;
  for (const auto& [name, value] : saved)
    if (value.empty())
      unsetenv(name);
    else
      setenv(name, value.c_str(), 1);
}

}  // namespace
}  // namespace brittle::platform
