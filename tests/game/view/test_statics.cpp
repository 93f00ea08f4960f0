#include "game/view/statics.h"

#include <gtest/gtest.h>

#include "engine/core/log.h"
#include "engine/render/gl_null.h"
#include "packets.h"
#include "tests/game/content/mesh_baker.h"

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

/// Segments of which one may carry a mesh.
class CarriedMesh : public StaticsOnNull {
 protected:
  static constexpr const char* kFile = "segments/look0.mesh.mp3";

  void SetUp() override {
    StaticsOnNull::SetUp();
    old_ = setLogSink([this](LogLevel, std::string_view line) { logged_.emplace_back(line); });
  }
  void TearDown() override { setLogSink(std::move(old_)); }

  /// One triangle, which no box of the look has.
  static content::BakedMesh triangle() {
    content::BakedMesh mesh;
    for (const float x : {0.0f, 1.0f, 2.0f}) mesh.vertices.push_back({Vec3(x, x * x, -1.0f), 0.0f, 0.0f, ~0u});
    mesh.indices = {0, 1, 2};
    return mesh;
  }
  /// Indices that go to the GPU when these are first shown.
  std::size_t indicesOf(Statics& statics, const sim::FramePacket& packet) {
    null_.clearRecord();
    shownFrom(statics, packet, 0.0f);
    return null_.bytesTo(GL_ELEMENT_ARRAY_BUFFER) / sizeof(std::uint32_t);
  }

  content::MemorySource assets_;
  std::vector<std::string> logged_;
  LogSink old_;
};

TEST_F(CarriedMesh, IsDrawnInPlaceOfTheBoxes) {
  assets_.add(kFile, content::meshFile(triangle()));
  Statics carried(*renderer_, &assets_), without(*renderer_);
  EXPECT_EQ(indicesOf(carried, row(1)), 3u);
  EXPECT_GT(indicesOf(without, row(1)), 3u);
  EXPECT_EQ(logged_, std::vector<std::string>());
}

TEST_F(CarriedMesh, IsReadAheadAndThenShown) {
  assets_.add("segments/look5.mesh", content::meshFile(triangle()));
  Statics statics(*renderer_, &assets_);
  const sim::FramePacket packet = row(6);
  for (int i = 0; i < 30; ++i) shownFrom(statics, packet, 0.0f);
  EXPECT_EQ(statics.count(), 6u);
  null_.clearRecord();
  EXPECT_EQ(shownFrom(statics, packet, -24.0f), 6u);
  EXPECT_EQ(null_.bytesTo(GL_ELEMENT_ARRAY_BUFFER), 0u);
}

TEST_F(CarriedMesh, OneWithAFaultIsNamedOnceAndTheBoxesAreDrawn) {
  assets_.add(kFile, "damaged");
  Statics statics(*renderer_, &assets_), without(*renderer_);
  const std::size_t boxes = indicesOf(without, row(1));
  EXPECT_EQ(indicesOf(statics, row(1)), boxes);
  statics.clear();
  EXPECT_EQ(indicesOf(statics, row(1)), boxes);
  ASSERT_EQ(logged_.size(), 1u);
  EXPECT_NE(logged_[0].find("content: segments/look0.mesh: baked mesh: a damaged"), std::string::npos) << logged_[0];
}

TEST_F(CarriedMesh, StonesAreDrawnBesideIt) {
  assets_.add(kFile, content::meshFile(triangle()));
  sim::FramePacket packet = row(1);
  auto look = std::make_shared<sim::SegmentLook>(*packet.rooms[0].segments[0].look);
  look->boxes.push_back(look->boxes[0]);
  look->boxes[1].center.y() = 0.5f;
  look->boxes[1].isStone = true;
  packet.rooms[0].segments[0].look = look;
  Statics statics(*renderer_, &assets_);
  EXPECT_GE(indicesOf(statics, packet), 3u + 2u * 6u);  // its top and its front at least
}

TEST_F(CarriedMesh, LargeOnesAreNotKeptWhenNobodySeesThem) {
  content::BakedMesh large = triangle();
  large.vertices.resize(300'000, large.vertices[0]);  // 7 MB
  for (int i = 0; i < 8; ++i) assets_.add("segments/look" + std::to_string(i) + ".mesh", content::meshFile(large));
  Statics statics(*renderer_, &assets_);
  sim::FramePacket packet = row(8);
  for (int i = 0; i < 8; ++i) {
    sim::FramePacket one = row(8);
    one.rooms[0].segments = {packet.rooms[0].segments[static_cast<std::size_t>(i)]};
    one.rooms[0].segments[0].origin = Vec3::Zero();
    EXPECT_EQ(shownFrom(statics, one, 0.0f), 1u);
  }
  EXPECT_EQ(statics.count(), 4u);  // of 32 MB
  EXPECT_GT(statics.dropped(), 0u);
}

}  // namespace
}  // namespace brittle::view
