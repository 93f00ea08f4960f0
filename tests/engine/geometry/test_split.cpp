#include "engine/geometry/split.h"

#include <gtest/gtest.h>

#include "tests/engine/geometry/cutting.h"

namespace brittle::geometry {
namespace {

class SplitModes : public ::testing::TestWithParam<CutMode> {};

TEST_P(SplitModes, NeverBreaksTopology) {
  CutCube<float> cube(GetParam(), 42);
  int splits = 0;
  for (int attempt = 0; attempt < 1000000; ++attempt) {
    if (cube.step() != SplitOutcome::Split) continue;
    ++splits;
    ASSERT_STREQ(findTopologyError(cube.above.view()), nullptr) << "attempt " << attempt;
    ASSERT_STREQ(findTopologyError(cube.below.view()), nullptr) << "attempt " << attempt;
    const double before = volumeOf<double>(cube.parent);
    const double after = volumeOf<double>(cube.above) + volumeOf<double>(cube.below);
    ASSERT_NEAR(before, after, 4e-6) << "attempt " << attempt;
  }
  EXPECT_GT(splits, 300000);
}

INSTANTIATE_TEST_SUITE_P(AllModes, SplitModes, ::testing::ValuesIn(kCutModes), [](const auto& instance) {
  return std::string(kCutModeNames[static_cast<int>(instance.param)]);
});

}  // namespace
}  // namespace brittle::geometry
