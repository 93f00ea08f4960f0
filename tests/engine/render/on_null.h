// tests/engine/render/on_null.h - what one frame makes a fresh renderer ask of the null table.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/render/gl_null.h"
#include "engine/render/renderer.h"

namespace brittle::render {

class OnNull : public ::testing::Test {
 protected:
  /// Draws the frame; nothing is complained of, and nothing left behind.
  void draw(const Frame& frame, bool refraction = true) {
    NullGl null;
    auto made = Renderer::create(null.table(), {.width = 320, .height = 180, .refraction = refraction});
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
  /// A frame without the effect makes nothing.
  void expectNothingMade() {
    draw(Frame{});
    EXPECT_EQ(programs_, 0u);
    EXPECT_EQ(objects_, 0u);
    EXPECT_EQ(blits_, 0u);
  }
  std::size_t objects_ = 0, draws_ = 0;
  std::uint32_t programs_ = 0, blits_ = 0;
};

}  // namespace brittle::render
