#include "game/view/statics.h"

#include <gtest/gtest.h>

#include "engine/render/gl_null.h"
#include "packets.h"

namespace brittle::view {
namespace {

constexpr float kFarthest = 25.0f;

class StaticsOnNull : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = render::Renderer::create(null_.table(), {.width = 32, .height = 18});
    ASSERT_TRUE(made) << made.error().message;
    renderer_ = std::move(*made);
  }
  /// Segments of 8 m in a row, each with a look of its own.
  static sim::FramePacket row(int count) {
    sim::FramePacket packet = packetAt(0);
    const sim::SegmentLook first = *packet.rooms[0].segments[0].look;
    packet.rooms[0].segments.clear();
    for (int i = 0; i < count; ++i) {
      auto look = std::make_shared<sim::SegmentLook>(first);
      look->name = "look" + std::to_string(i);
      packet.rooms[0].segments.push_back({1, Vec3(0.0f, 0.0f, -8.0f * static_cast<float>(i)), look});
    }
    return packet;
  }
  std::size_t shownFrom(Statics& statics, const sim::FramePacket& packet, float cameraZ) {
    std::vector<render::VisibleStatic> seen;
    statics.show(packet.rooms, cameraZ, kFarthest, seen);
    return seen.size();
  }

  render::NullGl null_;
  std::unique_ptr<render::Renderer> renderer_;
};

TEST_F(StaticsOnNull, ShowWhatBeginsBeforeTheFogEnds) {
  Statics statics(*renderer_);
  const sim::FramePacket packet = row(8);
  EXPECT_EQ(shownFrom(statics, packet, 0.0f), 4u);   // 0, 8, 16 and 24 m ahead
  EXPECT_EQ(shownFrom(statics, packet, -8.0f), 5u);  // the one behind is the simulation's to drop
}

TEST_F(StaticsOnNull, BakeAheadAFaceACall) {
  Statics statics(*renderer_);
  const sim::FramePacket packet = row(6);
  shownFrom(statics, packet, 0.0f);
  EXPECT_EQ(statics.count(), 4u);
  int calls = 0;
  while (statics.count() < 6 && calls < 100) {
    shownFrom(statics, packet, 0.0f);
    ++calls;
  }
  EXPECT_GE(calls, 3);  // a floor's top and front, and a look at whether there is more
  EXPECT_LT(calls, 20);
}

TEST_F(StaticsOnNull, WhatComesIntoSightHalfBakedIsFinished) {
  Statics statics(*renderer_), once(*renderer_);
  const sim::FramePacket packet = row(6);
  shownFrom(statics, packet, 0.0f);
  shownFrom(statics, packet, 0.0f);
  EXPECT_EQ(shownFrom(statics, packet, -16.0f), 6u);
  EXPECT_EQ(shownFrom(once, packet, -16.0f), 6u);
  EXPECT_EQ(statics.count(), 6u);
}

}  // namespace
}  // namespace brittle::view
