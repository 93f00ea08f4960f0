#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/render/gl_null.h"
#include "engine/render/renderer.h"

namespace brittle::render {
namespace {

class LasersOnNull : public ::testing::Test {
 protected:
  static void fill(Frame& frame) {
    frame.lasers.push_back({Vec3(-1.0f, 0.0f, -3.0f), Vec3(1.0f, 0.0f, -3.0f), 0.02f, kWhite});
  }
  void draw(const Frame& frame) {
    NullGl null;
    auto made = Renderer::create(null.table(), {.width = 320, .height = 180});
    ASSERT_TRUE(made) << made.error().message;
    const std::size_t before = null.liveObjects();
    null.clearRecord();
    (*made)->draw(frame);
    objects_ = null.liveObjects() - before;
    programs_ = null.calls("CreateProgram");
    blits_ = null.calls("BlitFramebuffer");
    draws_ = null.draws().size();
    EXPECT_THAT(null.complaints(), ::testing::IsEmpty());
    made->reset();
    EXPECT_EQ(null.liveObjects(), 0u);
  }
  std::size_t objects_ = 0, draws_ = 0;
  std::uint32_t programs_ = 0, blits_ = 0;
};

TEST_F(LasersOnNull, CostNothingWhereNobodyAsks) {
  draw(Frame{});
  EXPECT_EQ(programs_, 0u);
  EXPECT_EQ(objects_, 0u);
  EXPECT_EQ(blits_, 0u);
}

TEST_F(LasersOnNull, AreDrawnWhereTheyAre) {
  Frame frame;
  fill(frame);
  draw(frame);
  EXPECT_EQ(draws_, 3u);
  EXPECT_EQ(programs_, 1u);
  EXPECT_EQ(blits_, 0u);
}

TEST_F(LasersOnNull, AreSeenInTheMirrorToo) {
  Frame frame;
  fill(frame);
  frame.mirrorHeight = -1.0f;
  draw(frame);
  EXPECT_EQ(draws_, 4u);
}

}  // namespace
}  // namespace brittle::render
