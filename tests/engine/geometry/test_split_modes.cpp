// The split under stress. The hard cases B1 to B4 go on to millions of cuts of each kind.
#include "engine/geometry/split.h"

#include <gtest/gtest.h>

#include <cstring>

#include "engine/core/hash.h"
#include "tests/engine/geometry/mating.h"

namespace brittle::geometry {
namespace {

class SplitModes : public ::testing::TestWithParam<CutMode> {};

TEST_P(SplitModes, NeverBreaksAPiece) {
  CutCube<float> cube(GetParam(), 42);
  int splits = 0;
  for (int attempt = 0; attempt < 20000; ++attempt) {
    if (cube.step() != SplitOutcome::Split) continue;
    ++splits;
    ASSERT_STREQ(findCutError(cube.parent, cube.plane, cube.above, cube.below), nullptr) << attempt;
    const double above = volumeOf<double>(cube.above);
    const double below = volumeOf<double>(cube.below);
    ASSERT_GT(above, 0.0) << attempt;
    ASSERT_GT(below, 0.0) << attempt;
    ASSERT_NEAR(above + below, volumeOf<double>(cube.parent), 1e-6) << attempt;
  }
  EXPECT_GT(splits, 5000);
}

TEST_P(SplitModes, NeverBreaksAPieceInDouble) {
  CutCube<double> cube(GetParam(), 43);
  for (int attempt = 0; attempt < 20000; ++attempt) {
    if (cube.step() != SplitOutcome::Split) continue;
    ASSERT_STREQ(findTopologyError(cube.above.view()), nullptr) << attempt;
    ASSERT_STREQ(findTopologyError(cube.below.view()), nullptr) << attempt;
    ASSERT_NEAR(volumeOf<double>(cube.above) + volumeOf<double>(cube.below), volumeOf<double>(cube.parent), 1e-6);
  }
}

// All limits are relative, so powers of two change nothing but exponents.
TEST_P(SplitModes, DoesNotDependOnScale) {
  CutCube<float> cube(GetParam(), 44);
  SplitScratch scratch;
  Convex above, below;
  for (int attempt = 0; attempt < 2000; ++attempt) {
    const SplitOutcome outcome = cube.step();
    const float scale = attempt % 2 == 0 ? 0x1p-10f : 0x1p7f;
    Convex scaled = cube.parent;
    for (Vertex& vertex : scaled.vertices) vertex.point *= scale;
    const Plane plane = {cube.plane.normal, cube.plane.offset * scale};
    ASSERT_EQ(split<float>(scaled.view(), plane, {}, scratch, above, below), outcome);
    if (outcome != SplitOutcome::Split) continue;
    ASSERT_EQ(above.vertices.size(), cube.above.vertices.size());
    for (std::size_t i = 0; i < above.vertices.size(); ++i) {
      ASSERT_TRUE(isSame(above.vertices[i].point, scale * cube.above.vertices[i].point));
    }
    for (std::size_t i = 0; i < above.edges.size(); ++i) {
      ASSERT_EQ(std::memcmp(&above.edges[i], &cube.above.edges[i], sizeof(Edge)), 0);
    }
  }
}

// The same bits from every compiler and at every optimisation: replays rely on them.
TEST_P(SplitModes, GivesTheBitsItAlwaysGave) {
  CutCube<float> cube(GetParam(), 45);
  StateHash hash;
  for (int attempt = 0; attempt < 5000; ++attempt) {
    hash.add(static_cast<std::uint32_t>(cube.step()));
    for (const Convex* piece : {&cube.above, &cube.below}) {
      for (const Vertex& vertex : piece->vertices) {
        for (int i = 0; i < 3; ++i) hash.add(vertex.point[i]);
      }
      for (const Edge& edge : piece->edges) {
        hash.add(std::uint32_t{edge.face} << 16 | edge.vertex);
        hash.add(std::uint32_t{edge.next} << 16 | edge.opposite);
      }
    }
  }
  constexpr std::uint64_t golden[] = {0x065fb2586b6107b6, 0xe11de32e1940fc2c, 0x15bda0d84475b319, 0x6feaa2d9846dd187};
  EXPECT_EQ(hash.value(), golden[static_cast<int>(GetParam())]) << std::hex << "0x" << hash.value();
}

INSTANTIATE_TEST_SUITE_P(AllModes, SplitModes, ::testing::ValuesIn(kCutModes), [](const auto& instance) {
  return std::string(kCutModeNames[static_cast<int>(instance.param)]);
});

}  // namespace
}  // namespace brittle::geometry
