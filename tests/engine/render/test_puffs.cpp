#include "on_null.h"

namespace brittle::render {
namespace {

class PuffsOnNull : public OnNull {
 protected:
  static void fill(Frame& frame) { frame.puffs.push_back({Vec3(0.0f, 0.0f, -3.0f), 0.5f, kWhite, 0.0f, 1.0f}); }
};

TEST_F(PuffsOnNull, CostNothingWhereNobodyAsks) {
  expectNothingMade();
}

TEST_F(PuffsOnNull, AreDrawnWhereTheyAre) {
  Frame frame;
  fill(frame);
  draw(frame);
  EXPECT_EQ(draws_, 3u);
  EXPECT_EQ(programs_, 1u);
  EXPECT_EQ(blits_, 1u);
}

}  // namespace
}  // namespace brittle::render
