#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/render/gl_null.h"
#include "engine/render/renderer.h"

namespace brittle::render {
namespace {

class FocusOnNull : public ::testing::Test {
 protected:
  static void fill(Frame& frame) { frame.focus = {4.0f, 6.0f, 0.8f}; }
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

TEST_F(FocusOnNull, CostNothingWhereNobodyAsks) {
  draw(Frame{});
  EXPECT_EQ(programs_, 0u);
  EXPECT_EQ(objects_, 0u);
  EXPECT_EQ(blits_, 0u);
}

TEST_F(FocusOnNull, AreDrawnWhereTheyAre) {
  Frame frame;
  fill(frame);
  draw(frame);
  EXPECT_EQ(draws_, 5u);
  EXPECT_EQ(programs_, 3u);
  EXPECT_EQ(blits_, 1u);
}

}  // namespace
}  // namespace brittle::render
