#include "on_null.h"

namespace brittle::render {
namespace {

class FocusOnNull : public OnNull {
 protected:
  static void fill(Frame& frame) { frame.focus = {4.0f, 6.0f, 0.8f}; }
};

TEST_F(FocusOnNull, CostNothingWhereNobodyAsks) {
  expectNothingMade();
}

TEST_F(FocusOnNull, AreDrawnWhereTheyAre) {
  Frame frame;
  fill(frame);
  draw(frame);
  EXPECT_EQ(draws_, 5u);
  EXPECT_EQ(programs_, 3u);
  EXPECT_EQ(blits_, 1u);
}

TEST_F(FocusOnNull, DrawWhatIsTranslucentBeforeAndAfter) {
  Frame frame;
  fill(frame);
  frame.beams.push_back({Vec3(0.0f, 0.0f, -3.0f), Vec3(0.0f, 1.0f, -9.0f)});
  draw(frame);
  EXPECT_EQ(draws_, 7u);
  EXPECT_EQ(programs_, 4u);
}

}  // namespace
}  // namespace brittle::render
