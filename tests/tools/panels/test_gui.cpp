// The widgets under a made-up mouse, and what they draw.
#include "tools/panels/gui.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "tools/panels/knobs.h"
#include "tools/panels/listening_platform.h"

namespace brittle::panels {
namespace {

using runtime::Event;
using runtime::EventKind;

constexpr runtime::PictureSize kSize = {640, 480};

Event pointer(EventKind kind, float x, float y) {
  Event event;
  event.kind = kind;
  event.x = x;
  event.y = y;
  return event;
}

/// A window at (100, 100), 200 pixels wide and high, with a button over all of it.
class WindowWithButton : public ::testing::Test {
 protected:
  WindowWithButton() {
    frame();
    frame();  // a window knows what it holds from its second frame on
  }
  bool frame() {
    gui_.begin(kSize, seconds_ += 1.0 / 60.0);
    ImGui::SetNextWindowPos(ImVec2(100.0f, 100.0f));
    ImGui::SetNextWindowSize(ImVec2(200.0f, 200.0f));
    ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoDecoration);
    const bool isPressed = ImGui::Button("button", ImVec2(180.0f, 180.0f));
    ImGui::End();
    overlay_ = &gui_.end();
    return isPressed;
  }

  Gui gui_;
  double seconds_ = 0.0;
  const render::Overlay* overlay_ = nullptr;
};

TEST_F(WindowWithButton, TakesThePointerOverItAndLeavesItElsewhere) {
  gui_.take(pointer(EventKind::PointerMoved, 200.0f, 200.0f));
  frame();
  EXPECT_TRUE(gui_.take(pointer(EventKind::PointerDown, 200.0f, 200.0f)));
  gui_.take(pointer(EventKind::PointerUp, 200.0f, 200.0f));
  frame();
  gui_.take(pointer(EventKind::PointerMoved, 20.0f, 20.0f));
  frame();
  EXPECT_FALSE(gui_.take(pointer(EventKind::PointerDown, 20.0f, 20.0f)));
}

TEST_F(WindowWithButton, IsPressedByAClickWithinOneFrame) {
  gui_.take(pointer(EventKind::PointerMoved, 200.0f, 200.0f));
  frame();
  gui_.take(pointer(EventKind::PointerDown, 200.0f, 200.0f));
  gui_.take(pointer(EventKind::PointerUp, 200.0f, 200.0f));
  const bool whileDown = frame(), afterwards = frame();
  EXPECT_TRUE(whileDown || afterwards);
  EXPECT_FALSE(frame());
}

TEST_F(WindowWithButton, TakesATouchThatNoMouseCameBefore) {
  EXPECT_TRUE(gui_.take(pointer(EventKind::PointerDown, 200.0f, 200.0f)));
  const bool first = frame(), second = frame();
  gui_.take(pointer(EventKind::PointerUp, 200.0f, 200.0f));
  EXPECT_TRUE(first || second || frame());
}

TEST_F(WindowWithButton, LeavesTheTouchAfterOneOfItsOwn) {
  gui_.take(pointer(EventKind::PointerDown, 200.0f, 200.0f));
  gui_.take(pointer(EventKind::PointerUp, 200.0f, 200.0f));
  frame();
  frame();
  EXPECT_FALSE(gui_.take(pointer(EventKind::PointerDown, 20.0f, 20.0f)));
  EXPECT_FALSE(gui_.take(pointer(EventKind::PointerMoved, 200.0f, 200.0f)));  // dragged over it
  EXPECT_FALSE(gui_.take(pointer(EventKind::PointerUp, 200.0f, 200.0f)));
}

TEST_F(WindowWithButton, DrawsTrianglesThatHangTogether) {
  ASSERT_FALSE(overlay_->parts.empty());
  std::uint32_t next = 0;
  for (const render::OverlayPart& part : overlay_->parts) {
    EXPECT_EQ(part.first, next);
    EXPECT_EQ(part.count % 3, 0u);
    next = part.first + part.count;
  }
  EXPECT_EQ(next, overlay_->indices.size());
  for (const std::uint32_t index : overlay_->indices) ASSERT_LT(index, overlay_->points.size());
}

TEST(Knobs, AreWithinTheirRangeWhereverTheyAreDragged) {
  Gui gui;
  physics::Accuracy accuracy;
  double seconds = 0.0;
  bool wasChanged = false;
  const auto frame = [&] {
    gui.begin(kSize, seconds += 1.0 / 60.0);
    ImGui::SetNextWindowPos(ImVec2(0.0f, 0.0f));
    ImGui::Begin("knobs", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    wasChanged |= showKnobs(accuracy);
    ImGui::End();
    gui.end();
    ASSERT_TRUE(physics::isWithinRange(accuracy));
  };
  frame();
  frame();
  EXPECT_FALSE(wasChanged);  // by being shown
  for (float y = 20.0f; y < 470.0f; y += 11.0f) {
    gui.take(pointer(EventKind::PointerMoved, 40.0f, y));
    frame();
    gui.take(pointer(EventKind::PointerDown, 40.0f, y));
    frame();
    for (const float x : {200.0f, -500.0f, 5000.0f}) {
      gui.take(pointer(EventKind::PointerMoved, x, y));
      frame();
    }
    gui.take(pointer(EventKind::PointerUp, 40.0f, y));
    frame();
  }
  EXPECT_TRUE(wasChanged);
  EXPECT_NE(accuracy.iterations, physics::Accuracy{}.iterations);
}

/// Sends what it is given.
class Script : public runtime::Platform {
 public:
  std::vector<Event> next;
  runtime::PictureSize size() const override { return kSize; }
  void pollEvents(std::vector<Event>& events) override { events.swap(next); }
  void swap() override {}
  runtime::GlLoader glLoader() const override { return nullptr; }
  bool hasDefaultFramebuffer() const override { return false; }
  double seconds() const override { return 0.0; }
  void sleep(double) override {}
};

TEST(ListeningPlatform, PassesOnWhatTheListenerLeavesInOrder) {
  Script script;
  ListeningPlatform listening(script, [](const Event& event) { return event.kind == EventKind::PointerDown; });
  script.next = {pointer(EventKind::PointerMoved, 1, 1), pointer(EventKind::PointerDown, 2, 2),
                 pointer(EventKind::PointerUp, 3, 3)};
  std::vector<Event> events;
  listening.pollEvents(events);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].kind, EventKind::PointerMoved);
  EXPECT_EQ(events[1].kind, EventKind::PointerUp);
}

}  // namespace
}  // namespace brittle::panels
