// The split under stress: a million cuts of each kind.
#include "engine/geometry/split.h"

#include <gtest/gtest.h>

#include <cstring>

#include "engine/core/hash.h"
#include "tests/engine/geometry/cutting.h"

namespace brittle::geometry {
namespace {

/// Every vertex of the parent stands in one child, bit for bit, and both caps have the same corners, once round each
/// way.
void expectSharedVertices(const Convex& parent, const Convex& above, const Convex& below) {
  std::vector<Vec3> capAbove = capOf(above);
  const std::vector<Vec3> capBelow = capOf(below);
  ASSERT_EQ(capAbove.size(), capBelow.size());
  ASSERT_EQ(above.vertices.size() + below.vertices.size(), parent.vertices.size() + 2 * capAbove.size());
  for (std::size_t i = 0; i < capAbove.size(); ++i) {
    const std::size_t mirrored = i == 0 ? 0 : capAbove.size() - i;
    ASSERT_TRUE(isSame(capAbove[i], capBelow[mirrored]));
  }
  std::size_t nextAbove = 0;
  std::size_t nextBelow = 0;
  for (const Vertex& vertex : parent.vertices) {
    const bool isLeft = nextAbove + capAbove.size() < above.vertices.size();
    if (isLeft && isSame(vertex.point, above.vertices[nextAbove].point)) {
      ++nextAbove;
    } else {
      ASSERT_TRUE(isSame(vertex.point, below.vertices[nextBelow].point));
      ++nextBelow;
    }
  }
  ASSERT_EQ(nextAbove + capAbove.size(), above.vertices.size());
}

/// Other faces keep the parent's planes bit for bit; the caps have the cutting plane, facing out.
void expectInheritedPlanes(const Convex& parent, const Plane& plane, const Convex& above, const Convex& below) {
  ASSERT_TRUE(isSame(above.faces.back().plane, plane.flipped()));
  ASSERT_TRUE(isSame(below.faces.back().plane, plane));
  for (const Convex* child : {&above, &below}) {
    std::size_t next = 0;
    for (const Face& face : parent.faces) {
      if (next + 1 < child->faces.size() && isSame(face.plane, child->faces[next].plane)) ++next;
    }
    ASSERT_EQ(next + 1, child->faces.size());
  }
}

class SplitModes : public ::testing::TestWithParam<CutMode> {};

// A million cuts of each kind. Where planes go through what is there already, a splitter that trusts its signs fails on
// 0.4 to 0.6 %.
TEST_P(SplitModes, NeverBreaksAPiece) {
  CutCube<float> cube(GetParam(), 42);
  int splits = 0;
  float mostConvexityError = 0.0f;
  for (int attempt = 0; attempt < 1000000; ++attempt) {
    if (cube.isFull()) {
      double total = 0.0;
      for (std::size_t i = 0; i < cube.count(); ++i) total += volumeOf<double>(cube.piece(i));
      ASSERT_NEAR(total, 1.0, 1e-6) << attempt;
    }
    if (cube.step() != SplitOutcome::Split) continue;
    ++splits;
    ASSERT_STREQ(findTopologyError(cube.above.view()), nullptr) << attempt;
    ASSERT_STREQ(findTopologyError(cube.below.view()), nullptr) << attempt;
    const double above = volumeOf<double>(cube.above);
    const double below = volumeOf<double>(cube.below);
    ASSERT_GT(above, 0.0) << attempt;
    ASSERT_GT(below, 0.0) << attempt;
    ASSERT_NEAR(above + below, volumeOf<double>(cube.parent), 1e-6) << attempt;
    mostConvexityError = maxOf(mostConvexityError, maxOf(convexityError(cube.above), convexityError(cube.below)));
    if (attempt % 16 != 0) continue;
    ASSERT_NO_FATAL_FAILURE(expectSharedVertices(cube.parent, cube.above, cube.below)) << attempt;
    ASSERT_NO_FATAL_FAILURE(expectInheritedPlanes(cube.parent, cube.plane, cube.above, cube.below)) << attempt;
  }
  EXPECT_GT(splits, 300000);
  // Either bound of split.h for the cube itself (extent 1, largest coordinate 1/2), plus rounding of the distance.
  EXPECT_LT(mostConvexityError, 0x1p-20f + 0x1p-22f);
}

TEST_P(SplitModes, NeverBreaksAPieceInDouble) {
  CutCube<double> cube(GetParam(), 43);
  for (int attempt = 0; attempt < 100000; ++attempt) {
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
  for (int attempt = 0; attempt < 20000; ++attempt) {
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
