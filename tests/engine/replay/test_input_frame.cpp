#include "engine/replay/input_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brittle::replay {
namespace {

TEST(InputFrame, AimIsTheNearestStep) {
  EXPECT_EQ(quantizeAim(0.0f, 0.0f), (Throw{0, 0}));
  EXPECT_EQ(quantizeAim(1.0f, -1.0f), (Throw{8192, -8192}));
  EXPECT_EQ(quantizeAim(1.4f * kAimStep, -1.6f * kAimStep), (Throw{1, -2}));
}

TEST(InputFrame, AimBeyondTheRangeIsClampedAndNothingIsUndefined) {
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(quantizeAim(1e9f, -infinity), (Throw{32767, -32767}));
  EXPECT_EQ(quantizeAim(std::nanf(""), 0.5f), (Throw{0, 4096}));
}

TEST(InputFrame, EachPlaceHasABitOfItsOwn) {
  unsigned all = static_cast<unsigned>(Button::Restart) | static_cast<unsigned>(Button::Pause);
  for (int place = 0; place < kUsePlaces; ++place) {
    EXPECT_NE(useBit(place), 0);
    EXPECT_EQ(all & useBit(place), 0u);
    all |= useBit(place);
  }
}

// The same point of the view, reached from two picture sizes, is the same throw, but for points on the border of two
// steps.
TEST(InputFrame, ThePicturesSizeDoesNotMatter) {
  int different = 0;
  for (int i = 0; i < 1000; ++i) {
    const float part = static_cast<float>(i) / 1000.0f;
    const float small = (part * 640.0f) / 640.0f * 2.0f - 1.0f;
    const float large = (part * 3840.0f) / 3840.0f * 2.0f - 1.0f;
    different += quantizeAim(small, 0.0f) == quantizeAim(large, 0.0f) ? 0 : 1;
  }
  EXPECT_LE(different, 1);
}

}  // namespace
}  // namespace brittle::replay
