// B7: both children of a cut mate. Their caps are the same corners bit for bit, and together they are the parent: as
// volumes summed without rounding, one cut at a time; as a set, by points of a sequence that fills a cut-up cube, each
// of which lies in exactly one piece; in one component, because the pieces of a cut share a cap with an area.
// (A boolean union by another library would say the same; none is packaged, so it is points and exact sums.)
//
// Volume: cut vertices may lie off the plane of a neighbouring face by what split.h says: they are moved away from
// vertices by up to 2^-20 of the extent, and rounding is worth 8 units in the last place of the largest coordinate,
// 2^-21 m here. What a piece may lose is that times its surface, more than 1e-6 of a thin piece (1.2e-6 of one of 8e-3
// m3 was seen). So a cut is held to 1e-6 of the cube, and to 1e-6 of the piece and that much of its surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/engine/geometry/exact.h"
#include "tests/engine/geometry/mating.h"
#include "tests/hard_cases/case.h"

namespace brittle::geometry {
namespace {

/// Of the whole surface. [m2]
double areaOf(const Convex& piece) {
  double sum = 0.0;
  for (const Face& face : piece.faces) sum += areaOf(piece, face);
  return sum;
}

class B7 : public testing::TestWithParam<CutMode> {};

TEST_P(B7, ChildrenAreTheParentCapForCap) {
  CutCube<float> cube(GetParam(), 71);
  for (int attempt = 0; attempt < hard::counted(4000, 400000); ++attempt) {
    if (cube.step() != SplitOutcome::Split) continue;
    ASSERT_STREQ(findSharingError(cube.parent, cube.above, cube.below), nullptr);
    const Exact parent = volumeOf<Exact>(cube.parent);
    const auto off = static_cast<double>(abs(volumeOf<Exact>(cube.above) + volumeOf<Exact>(cube.below) - parent));
    const auto volume = static_cast<double>(parent);
    const double rough = (0x1p-20 * extentOf(cube.parent.view()) + 0x1p-21) * areaOf(cube.parent);
    ASSERT_LE(off, 1e-6 * volume + rough) << attempt;
    hard::reportWorst("volume off by", off, "m3");
    EXPECT_LE(off, 1e-6) << "of the cube";
    hard::reportSum("cuts", 1);
  }
}

/// The i-th number of the sequence of van der Corput: the digits of i mirrored at the point.
double mirrored(std::uint32_t i, std::uint32_t base) {
  double value = 0.0, place = 1.0;
  for (; i > 0; i /= base) {
    place /= base;
    value += place * (i % base);
  }
  return value;
}

bool contains(const Convex& piece, const Vec3& point, float margin) {
  for (const Face& face : piece.faces)
    if (face.plane.distance(point) > margin) return false;
  return true;
}

TEST_P(B7, EveryPointOfTheCubeIsInOnePiece) {
  CutCube<float> cube(GetParam(), 72);
  while (!cube.isFull()) cube.step();
  const int points = hard::counted(10000, 1000000);
  int onBorders = 0;
  for (int i = 1; i <= points; ++i) {
    const auto n = static_cast<std::uint32_t>(i);
    const Vec3 point = Vec3d(mirrored(n, 2) - 0.5, mirrored(n, 3) - 0.5, mirrored(n, 5) - 0.5).cast<float>();
    int inside = 0, near = 0;
    for (std::size_t k = 0; k < cube.count(); ++k) {
      if (!contains(cube.piece(k), point, 2e-6f)) continue;
      ++near;
      inside += contains(cube.piece(k), point, -2e-6f) ? 1 : 0;
    }
    ASSERT_LE(inside, 1) << "two pieces overlap at " << point.transpose();
    ASSERT_GE(near, 1) << "a gap at " << point.transpose();
    onBorders += inside == 0 ? 1 : 0;
  }
  EXPECT_LT(onBorders, points / 100);
  hard::reportSum("points, each in one piece", points);
}

/// Places that are corners of one and lie on the other: of pieces that meet in an edge two, in an area three or more.
std::size_t sharedCorners(const Convex& a, const Convex& b) {
  std::vector<Vec3> places;
  const auto add = [&](const Convex& of, const Convex& on) {
    for (const Vertex& vertex : of.vertices) {
      const auto isSamePlace = [&](const Vec3& place) { return (place - vertex.point).norm() < 4e-6f; };
      if (contains(on, vertex.point, 2e-6f) && std::none_of(places.begin(), places.end(), isSamePlace))
        places.push_back(vertex.point);
    }
  };
  add(a, b);
  add(b, a);
  return places.size();
}

/// Whose caps came from one cut share some of it: pieces of a cut cube make one component.
TEST_P(B7, PiecesMakeOneComponent) {
  CutCube<float> cube(GetParam(), 73, 64);
  while (!cube.isFull()) cube.step();
  std::vector<std::size_t> root(cube.count());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  for (std::size_t a = 0; a < cube.count(); ++a)
    for (std::size_t b = a + 1; b < cube.count(); ++b) {
      if (sharedCorners(cube.piece(a), cube.piece(b)) >= 3) root[find(a)] = find(b);
    }
  std::size_t components = 0;
  for (std::size_t i = 0; i < cube.count(); ++i) components += find(i) == i ? 1 : 0;
  EXPECT_EQ(components, 1u);
}

INSTANTIATE_TEST_SUITE_P(AllModes, B7, testing::ValuesIn(kCutModes), [](const auto& instance) {
  return std::string(kCutModeNames[static_cast<int>(instance.param)]);
});

}  // namespace
}  // namespace brittle::geometry
