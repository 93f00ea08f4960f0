#include "on_null.h"

namespace brittle::render {
namespace {

class LasersOnNull : public OnNull {
 protected:
  static void fill(Frame& frame) {
    frame.lasers.push_back({Vec3(-1.0f, 0.0f, -3.0f), Vec3(1.0f, 0.0f, -3.0f), 0.02f, kWhite});
  }
};

TEST_F(LasersOnNull, CostNothingWhereNobodyAsks) {
  expectNothingMade();
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
