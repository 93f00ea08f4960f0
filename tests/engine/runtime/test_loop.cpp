#include "engine/runtime/loop.h"

#include <cmath>
#include <optional>

#include <gtest/gtest.h>

namespace brittle::runtime {
namespace {

class MadeUpPlatform : public Platform {
 public:
  PictureSize size() const override { return {640, 360}; }
  void pollEvents(std::vector<Event>& events) override {
    events.insert(events.end(), waiting.begin(), waiting.end());
    waiting.clear();
  }
  /// Holds the frame until the display's next refresh, if it has any.
  void swap() override {
    ++swaps;
    now += swapSeconds;
    if (refresh > 0.0) now = (std::floor(now / refresh + 1e-9) + 1.0) * refresh;
  }
  GlLoader glLoader() const override { return nullptr; }
  bool hasDefaultFramebuffer() const override { return true; }
  double seconds() const override { return now; }
  void sleep(double seconds) override {
    if (seconds > 0.0) slept += seconds;
  }

  std::vector<Event> waiting;
  double now = 100.0, slept = 0.0;
  double refresh = 0.0, swapSeconds = 0.0;  // [s]
  int swaps = 0;
};

class CountingClient : public Client {
 public:
  void tick(const replay::InputFrame& input) override {
    inputs.push_back(input);
    if (platform != nullptr) platform->now += 0.001;
  }
  void draw(const Shown& shown) override {
    alphas.push_back(shown.alpha);
    pausedWhenDrawn = shown.paused;
    timesWhenDrawn = shown.times != nullptr ? std::optional(*shown.times) : std::nullopt;
    if (platform != nullptr) platform->now += 0.004;
  }
  float tanHalfWidth(PictureSize) const override { return 1.0f; }
  Controls controls(PictureSize) const override { return shownControls; }
  bool isDone() const override { return done; }

  std::vector<replay::InputFrame> inputs;
  std::vector<float> alphas;
  Controls shownControls;
  bool pausedWhenDrawn = false;
  std::optional<FrameTimes> timesWhenDrawn;
  MadeUpPlatform* platform = nullptr;  // on which a tick takes 1 ms and a picture 4
  bool done = false;
};

Event pointerDown(float x, float y) {
  Event event;
  event.kind = EventKind::PointerDown;
  event.x = x, event.y = y;
  return event;
}
Event of(EventKind kind) {
  Event event;
  event.kind = kind;
  return event;
}
Event key(char character) {
  Event event;
  event.kind = EventKind::KeyDown;
  event.key = Key::Character;
  event.character = character;
  return event;
}

class LoopTest : public testing::Test {
 protected:
  /// A frame `ticks` [ticks] after the last one.
  bool frame(double ticks = 1.0) {
    platform.now += ticks * kTickSeconds;
    return loop.frame();
  }
  MadeUpPlatform platform;
  CountingClient client;
  Loop loop{platform, client};
};

TEST_F(LoopTest, OneTickAndOnePictureAFrame) {
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(frame());
  EXPECT_EQ(client.inputs.size(), 5u);
  EXPECT_EQ(client.alphas.size(), 5u);
  EXPECT_EQ(platform.swaps, 5);
}

TEST_F(LoopTest, ATouchIsOneThrowInOneTick) {
  platform.waiting = {pointerDown(640.0f, 180.0f)};
  frame(3.0);
  ASSERT_EQ(client.inputs.size(), 3u);
  ASSERT_EQ(client.inputs[0].throws.size(), 1u);
  EXPECT_EQ(client.inputs[0].throws[0], (replay::Throw{8192, 0})) << "the right border is the tangent 1";
  EXPECT_TRUE(client.inputs[1].throws.empty());
}

TEST_F(LoopTest, ATouchOfASignUsesItAndThrowsNothing) {
  client.shownControls.uses = {{10.0f, 300.0f, 50.0f, 340.0f}, {60.0f, 300.0f, 100.0f, 340.0f}};
  platform.waiting = {pointerDown(80.0f, 320.0f)};
  frame();
  platform.waiting = {pointerDown(55.0f, 320.0f)};
  frame();
  ASSERT_EQ(client.inputs.size(), 2u);
  EXPECT_TRUE(client.inputs[0].throws.empty());
  EXPECT_EQ(client.inputs[0].buttons, replay::useBit(1));
  EXPECT_EQ(client.inputs[1].throws.size(), 1u) << "between two signs";
  EXPECT_EQ(client.inputs[1].buttons, 0);
}

TEST_F(LoopTest, TheKeysOneToFourUseTheirPlaces) {
  for (int place = 0; place < replay::kUsePlaces; ++place) {
    platform.waiting = {key(static_cast<char>('1' + place))};
    frame();
    EXPECT_EQ(client.inputs.back().buttons, replay::useBit(place));
  }
  platform.waiting = {key('5'), key('0')};
  frame();
  EXPECT_EQ(client.inputs.back().buttons, 0);
}

/// Ticks in which something was thrown.
std::vector<std::size_t> throwsOf(const std::vector<replay::InputFrame>& inputs) {
  std::vector<std::size_t> ticks;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (!inputs[i].throws.empty()) ticks.push_back(i);
  return ticks;
}

TEST_F(LoopTest, AHeldPointerSpraysWhereItIsMovedTo) {
  client.shownControls.throwEvery = 6;
  platform.waiting = {pointerDown(320.0f, 180.0f)};
  for (int i = 0; i < 8; ++i) frame();
  Event moved = of(EventKind::PointerMoved);
  moved.x = 640.0f, moved.y = 180.0f;
  platform.waiting = {moved};
  for (int i = 0; i < 8; ++i) frame();
  platform.waiting = {of(EventKind::PointerUp)};
  for (int i = 0; i < 20; ++i) frame();
  EXPECT_EQ(throwsOf(client.inputs), (std::vector<std::size_t>{0, 6, 12}));
  EXPECT_EQ(client.inputs[6].throws[0], (replay::Throw{0, 0}));
  EXPECT_EQ(client.inputs[12].throws[0], (replay::Throw{8192, 0}));
}

TEST_F(LoopTest, WithoutSprayingAHeldPointerThrowsOnce) {
  platform.waiting = {pointerDown(320.0f, 180.0f)};
  for (int i = 0; i < 30; ++i) frame();
  EXPECT_EQ(throwsOf(client.inputs).size(), 1u);
}

TEST_F(LoopTest, ATouchInAFrameWithoutATickIsKept) {
  platform.waiting = {pointerDown(320.0f, 0.0f)};
  frame(0.25);
  EXPECT_TRUE(client.inputs.empty());
  frame(1.0);
  ASSERT_EQ(client.inputs.size(), 1u);
  ASSERT_EQ(client.inputs[0].throws.size(), 1u);
  EXPECT_EQ(client.inputs[0].throws[0], (replay::Throw{0, 4608})) << "up is 180 of 320 pixels";
}

TEST_F(LoopTest, MoreThrowsThanATickTakesWaitInOrder) {
  for (int i = 0; i < 10; ++i) platform.waiting.push_back(pointerDown(320.0f + static_cast<float>(i), 180.0f));
  frame();
  frame();
  ASSERT_EQ(client.inputs[0].throws.size(), static_cast<std::size_t>(replay::kMaxThrows));
  ASSERT_EQ(client.inputs[1].throws.size(), 2u);
  EXPECT_LT(client.inputs[0].throws.back().x, client.inputs[1].throws.front().x);
}

TEST_F(LoopTest, LosingFocusPausesWithoutATickAndWithAPicture) {
  frame();
  platform.waiting = {of(EventKind::FocusLost)};
  frame();
  frame(500.0);
  EXPECT_TRUE(client.pausedWhenDrawn);
  EXPECT_EQ(client.inputs.size(), 1u);
  EXPECT_EQ(client.alphas.size(), 3u);
  platform.waiting = {of(EventKind::FocusGained)};
  frame();
  EXPECT_EQ(client.inputs.size(), 2u) << "the time away is not made up for";
}

TEST_F(LoopTest, ComingBackDoesNotEndThePauseOfTheUser) {
  platform.waiting = {key('p'), of(EventKind::FocusLost), of(EventKind::FocusGained)};
  frame();
  EXPECT_TRUE(loop.isPaused());
  platform.waiting = {key('p')};
  frame();
  EXPECT_FALSE(loop.isPaused());
}

TEST_F(LoopTest, APictureForEachRefreshAndSixtyTicksASecond) {
  for (const int rate : {30, 60, 144}) {
    MadeUpPlatform display;
    CountingClient seen;
    display.refresh = 1.0 / rate;
    Loop onDisplay(display, seen);
    while (display.now < 102.0 - 1e-6) onDisplay.frame();
    EXPECT_NEAR(display.swaps, 2 * rate, 1) << rate;
    EXPECT_EQ(seen.alphas.size(), static_cast<std::size_t>(display.swaps));
    EXPECT_NEAR(static_cast<double>(seen.inputs.size()), 120.0, 2.0) << rate;
  }
}

TEST_F(LoopTest, F3ShowsWhatAFrameTakesAndHidesItAgain) {
  Event f3 = key(0);
  f3.key = Key::F3;
  client.platform = &platform;
  platform.swapSeconds = 0.008;
  frame();
  EXPECT_FALSE(client.timesWhenDrawn);
  platform.waiting = {f3};
  // Each frame begins a tick after the last one's end: 13 ms of work.
  for (int i = 0; i < 30; ++i) {
    frame();
    ASSERT_TRUE(client.timesWhenDrawn);
  }
  EXPECT_NEAR(client.timesWhenDrawn->frame, kTickSeconds + 0.013, 0.0011) << "some frames have two ticks";
  EXPECT_NEAR(client.timesWhenDrawn->longest, kTickSeconds + 0.014, 1e-6);
  EXPECT_NEAR(client.timesWhenDrawn->simulate, 0.0018, 0.0003);
  EXPECT_NEAR(client.timesWhenDrawn->draw, 0.004, 1e-6);
  EXPECT_NEAR(client.timesWhenDrawn->swap, 0.008, 1e-6);
  platform.waiting = {f3};
  frame();
  EXPECT_FALSE(client.timesWhenDrawn);
}

TEST_F(LoopTest, SleepsWhereTheDisplayDoesNotHoldFramesBack) {
  frame();
  EXPECT_NEAR(platform.slept, 1.0 / 250.0, 1e-9);
}

TEST_F(LoopTest, TheTouchThatEndsAPauseIsNotAThrow) {
  platform.waiting = {key('p')};
  frame();
  EXPECT_TRUE(loop.isPaused());
  platform.waiting = {pointerDown(1.0f, 1.0f)};
  frame();
  EXPECT_FALSE(loop.isPaused());
  EXPECT_TRUE(client.inputs.back().throws.empty());
}

TEST_F(LoopTest, RestartIsAButtonOfTheInputFrame) {
  platform.waiting = {key('r')};
  frame(2.0);
  EXPECT_EQ(client.inputs[0].buttons, static_cast<std::uint8_t>(replay::Button::Restart));
  EXPECT_EQ(client.inputs[1].buttons, 0);
}

TEST_F(LoopTest, EndsWhenClosedOrDone) {
  platform.waiting = {of(EventKind::Quit)};
  EXPECT_FALSE(frame());
  CountingClient finished;
  finished.done = true;
  EXPECT_FALSE(Loop(platform, finished).frame());
}

TEST_F(LoopTest, AWindowWithoutHeightThrowsNothing) {
  InputCollector collector;
  collector.setView({0, 0}, 1.0f);
  collector.add(pointerDown(5.0f, 5.0f));
  EXPECT_TRUE(collector.take().throws.empty());
}

}  // namespace
}  // namespace brittle::runtime
