// A window on an X server, with a real mouse (XTest through xdotool), real focus and real sizes. Run by ctest under
// xvfb-run with SDL_VIDEODRIVER=x11 and skipped elsewhere: nobody's desktop gets clicked on. X servers without a screen
// have no touch device, so fingers are SDL's own events.
#include <SDL.h>

#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "engine/replay/input_frame.h"
#include "engine/runtime/loop.h"
#include "platform/sdl/window.h"

namespace brittle::platform {
namespace {

using runtime::PictureSize;

constexpr float kTanHalfWidth = 0.75f;

class ThrowingClient : public runtime::Client {
 public:
  void tick(const replay::InputFrame& input) override {
    ++ticks;
    throws.insert(throws.end(), input.throws.begin(), input.throws.end());
  }
  void draw(const runtime::Shown& now) override { shown = now; }
  float tanHalfWidth(runtime::PictureSize) const override { return kTanHalfWidth; }
  bool isDone() const override { return false; }

  int ticks = 0;
  std::vector<replay::Throw> throws;
  runtime::Shown shown;
};

class X11Window : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* driver = std::getenv("SDL_VIDEODRIVER");
    if (driver == nullptr || std::string_view(driver) != "x11") GTEST_SKIP() << "needs SDL_VIDEODRIVER=x11";
    open(false);
  }

  void open(bool verticalSync) {
    loop_.reset();
    window_.reset();
    auto window = openWindow({.title = "brittle test", .size = {320, 180}, .verticalSync = verticalSync});
    ASSERT_TRUE(window) << window.error().message;
    window_ = std::move(*window);
    sdl_ = SDL_GL_GetCurrentWindow();
    loop_.emplace(*window_, client_);
    SDL_SetWindowInputFocus(sdl_);  // there is no window manager to give it
    runUntil([&] { return (SDL_GetWindowFlags(sdl_) & SDL_WINDOW_INPUT_FOCUS) != 0 && !client_.shown.paused; });
  }

  /// Frames until it is so; the X server answers when it likes.
  bool runUntil(const std::function<bool()>& isSo) {
    for (const double end = window_->seconds() + 10.0; window_->seconds() < end;) {
      loop_->frame();
      if (isSo()) return true;
    }
    return false;
  }

  /// Clicks on a pixel of the window with the pointer itself.
  void click(int x, int y) {
    int left = 0, top = 0;
    SDL_GetWindowPosition(sdl_, &left, &top);
    const std::string at = std::to_string(left + x) + " " + std::to_string(top + y);
    ASSERT_EQ(std::system(("xdotool mousemove --sync " + at + " click 1").c_str()), 0);
  }

  void touch(float x, float y) {
    SDL_Event event{};
    event.type = SDL_FINGERDOWN;
    event.tfinger.fingerId = 7;
    event.tfinger.x = x;
    event.tfinger.y = y;
    SDL_PushEvent(&event);
    event.type = SDL_FINGERUP;
    SDL_PushEvent(&event);
  }

  void resize(PictureSize size) {
    SDL_SetWindowSize(sdl_, size.width, size.height);
    ASSERT_TRUE(runUntil([&] { return client_.shown.size == size; }));
  }

  std::unique_ptr<runtime::Platform> window_;
  SDL_Window* sdl_ = nullptr;
  ThrowingClient client_;
  std::optional<runtime::Loop> loop_;
};

TEST_F(X11Window, AClickOfTheMouseIsOneThrowToWhereItPoints) {
  click(240, 45);
  ASSERT_TRUE(runUntil([&] { return !client_.throws.empty(); }));
  const int before = client_.ticks;
  runUntil([&] { return client_.ticks > before + 3; });
  ASSERT_EQ(client_.throws.size(), 1u);
  EXPECT_EQ(client_.throws[0], replay::quantizeAim(0.5f * kTanHalfWidth, 45.0f / 160.0f * kTanHalfWidth));
}

TEST_F(X11Window, ATouchIsOneThrowToWhereItIs) {
  touch(0.25f, 0.5f);
  ASSERT_TRUE(runUntil([&] { return !client_.throws.empty(); }));
  EXPECT_EQ(client_.throws[0], replay::quantizeAim(-0.5f * kTanHalfWidth, 0.0f));
}

TEST_F(X11Window, PictureAndAimFollowTheWindowsSize) {
  resize({400, 300});
  click(300, 150);  // three quarters across, in the middle
  ASSERT_TRUE(runUntil([&] { return client_.throws.size() == 1; }));
  EXPECT_EQ(client_.throws[0], replay::quantizeAim(0.5f * kTanHalfWidth, 0.0f));
  touch(1.0f, 0.0f);
  ASSERT_TRUE(runUntil([&] { return client_.throws.size() == 2; }));
  EXPECT_EQ(client_.throws[1], replay::quantizeAim(kTanHalfWidth, 0.75f * kTanHalfWidth));
}

TEST_F(X11Window, PausesWhileTheFocusIsElsewhere) {
  ASSERT_EQ(std::system("xdotool search --maxdepth 0 --class '.*' windowfocus >/dev/null"), 0);  // to the desktop
  ASSERT_TRUE(runUntil([&] { return client_.shown.paused; }));
  const int before = client_.ticks;
  window_->sleep(0.05);
  loop_->frame();
  EXPECT_EQ(client_.ticks, before);
  SDL_SetWindowInputFocus(sdl_);
  ASSERT_TRUE(runUntil([&] { return !client_.shown.paused; }));
  EXPECT_TRUE(runUntil([&] { return client_.ticks > before; }));
}

TEST_F(X11Window, ShowsNoMorePicturesThanTheDisplayHasRefreshes) {
  open(true);
  SDL_DisplayMode display{};
  SDL_GetCurrentDisplayMode(SDL_GetWindowDisplayIndex(sdl_), &display);
  const double rate = display.refresh_rate > 0 ? display.refresh_rate : 60.0;
  loop_->frame();
  const double begin = window_->seconds();
  int frames = 0;
  for (; frames < 40; ++frames) loop_->frame();
  // Nothing is drawn here, so without a pace there would be thousands. How fast a busy machine gets at best is open.
  EXPECT_LE(frames / (window_->seconds() - begin), 1.15 * rate);
}

}  // namespace
}  // namespace brittle::platform
