// The splitter against itself with exact rationals: the same code, with no rounding to blame.
#include <gtest/gtest.h>

#include "tests/engine/geometry/cutting.h"
#include "tests/engine/geometry/exact.h"

namespace brittle::geometry {
namespace {

class SplitExactly : public ::testing::TestWithParam<CutMode> {};

TEST_P(SplitExactly, LosesNothingAtAll) {
  CutCube<Exact> cube(GetParam(), 51, 64);
  for (int attempt = 0; attempt < 800; ++attempt) {
    if (cube.step() != SplitOutcome::Split) continue;
    ASSERT_STREQ(findTopologyError(cube.above.view()), nullptr);
    ASSERT_STREQ(findTopologyError(cube.below.view()), nullptr);
    const Exact above = volumeOf<Exact>(cube.above);
    const Exact below = volumeOf<Exact>(cube.below);
    ASSERT_GT(above, 0);
    ASSERT_GT(below, 0);
    ASSERT_EQ(volumeOf<Exact>(cube.parent) - above - below, 0);
    if (attempt % 8 != 0) continue;
    for (const ConvexT<Exact>* piece : {&cube.above, &cube.below}) {
      for (const FaceT<Exact>& face : piece->faces) {
        for (const VertexT<Exact>& vertex : piece->vertices) ASSERT_LE(face.plane.distance(vertex.point), 0);
      }
    }
  }
}

// Every sign the float splitter computes, computed again without rounding.
TEST_P(SplitExactly, SignsAreWrongOnlyWithinRounding) {
  CutCube<float> cube(GetParam(), 52);
  int wrong = 0;
  for (int attempt = 0; attempt < 5000; ++attempt) {
    cube.step();
    const PlaneT<Exact> plane = exactOf(cube.plane);
    for (const Vertex& vertex : cube.parent.vertices) {
      const Exact distance = plane.distance(exactOf(vertex.point));
      if ((distance < 0) == (cube.plane.distance(vertex.point) < 0.0f)) continue;
      ++wrong;
      ASSERT_LE(abs(distance), Exact(8 * 0x1p-24));  // 8 units of rounding of a number below 1
    }
  }
  if (GetParam() == CutMode::ThroughEdge) {
    EXPECT_GT(wrong, 100);
  }
}

// Both are cut by the same planes, float corners against exact ones: same signs, same mesh, nearly the same corners.
TEST_P(SplitExactly, FloatPiecesAreThoseOfTheExactSplitter) {
  CutCube<float> cube(GetParam(), 53, 48);
  SplitScratchT<Exact> scratch;
  std::vector<ConvexT<Exact>> mirrors(48);
  ConvexT<Exact> above, below;
  int compared = 0;
  int same = 0;
  for (int attempt = 0; attempt < 6000; ++attempt) {
    if (cube.count() == 1 || cube.isFull()) {
      mirrors.assign(mirrors.size(), {});
      mirrors[0] = makeBox<Exact>(Vec3T<Exact>(Exact(0.5), Exact(0.5), Exact(0.5)));
    }
    const SplitOutcome outcome = cube.step();
    ConvexT<Exact>& mirror = mirrors[cube.chosen];
    if (mirror.vertices.empty() || outcome != SplitOutcome::Split) continue;
    ++compared;
    if (agreesOnSigns(cube.parent, mirror, cube.plane)) {
      ASSERT_EQ(split<Exact>(mirror.view(), exactOf(cube.plane), {}, scratch, above, below), SplitOutcome::Split);
      ASSERT_TRUE(isSameTopology(cube.above, above)) << attempt;
      ASSERT_TRUE(isSameTopology(cube.below, below)) << attempt;
      ++same;
      mirror = above;
      mirrors[cube.count() - 1] = below;
    } else {
      mirror.clear();
      mirrors[cube.count() - 1].clear();
    }
  }
  EXPECT_GT(compared, 400);
  EXPECT_GT(same, compared / 2);
  if (GetParam() == CutMode::AtRandom) {
    EXPECT_GE(same, compared - 2);
  }
}

INSTANTIATE_TEST_SUITE_P(AllModes, SplitExactly, ::testing::ValuesIn(kCutModes), [](const auto& instance) {
  return std::string(kCutModeNames[static_cast<int>(instance.param)]);
});

}  // namespace
}  // namespace brittle::geometry
