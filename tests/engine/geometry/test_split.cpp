#include "engine/geometry/split.h"

#include <gtest/gtest.h>

#include "tests/engine/geometry/cutting.h"

namespace brittle::geometry {
namespace {

struct Cutting {
  SplitScratch scratch;
  Convex above, below;
  SplitOutcome cut(const Convex& parent, const Plane& plane, CutMark mark = {}) {
    return split<float>(parent.view(), plane, mark, scratch, above, below);
  }
};

TEST(Split, HalvesABox) {
  const Convex box = makeBox<float>(Vec3(1.0f, 2.0f, 3.0f));
  Cutting c;
  ASSERT_EQ(c.cut(box, {Vec3::UnitY(), 0.5f}, {7, FaceKind::Cut}), SplitOutcome::Split);
  EXPECT_EQ(volumeOf<double>(c.above), 2.0 * 1.5 * 6.0);
  EXPECT_EQ(volumeOf<double>(c.below), 2.0 * 2.5 * 6.0);
  for (const Convex* piece : {&c.above, &c.below}) {
    EXPECT_STREQ(findTopologyError(piece->view()), nullptr);
    ASSERT_EQ(piece->faces.size(), 6u);
    EXPECT_EQ(convexityError(*piece), 0.0f);
    EXPECT_EQ(piece->faces.back().cut, 7u);
    EXPECT_EQ(piece->faces.back().kind, FaceKind::Cut);
    for (std::size_t i = 0; i + 1 < piece->faces.size(); ++i) {
      EXPECT_EQ(piece->faces[i].cut, 0u);
      EXPECT_EQ(piece->faces[i].kind, FaceKind::Surface);
    }
  }
}

TEST(Split, RefusalsSayWhyAndWriteNothing) {
  const Convex box = makeBox<float>(Vec3::Ones());
  Cutting c;
  const auto expect = [&](SplitOutcome outcome, float offset) {
    EXPECT_EQ(c.cut(box, {Vec3::UnitX(), offset}), outcome) << offset;
    EXPECT_EQ(c.cut(box, {-Vec3::UnitX(), -offset}), outcome == SplitOutcome::AllAbove ? SplitOutcome::AllBelow
                                                     : outcome == SplitOutcome::AllBelow && offset > 1.0f
                                                         ? SplitOutcome::AllAbove
                                                         : outcome);
  };
  expect(SplitOutcome::AllBelow, 2.0f);
  expect(SplitOutcome::AllBelow, std::nextafter(1.0f, 2.0f));
  expect(SplitOutcome::TooThin, std::nextafter(1.0f, 0.0f));
  expect(SplitOutcome::TooThin, 1.0f - 2.0f * kMinThickness);
  EXPECT_EQ(c.cut(box, {Vec3::UnitX(), -2.0f}), SplitOutcome::AllAbove);
  EXPECT_TRUE(c.above.vertices.empty() && c.above.faces.empty() && c.above.edges.empty());
  EXPECT_TRUE(c.below.vertices.empty() && c.below.faces.empty() && c.below.edges.empty());
  EXPECT_EQ(c.cut(box, {Vec3::UnitX(), 1.0f - 2.1f * kMinThickness}), SplitOutcome::Split);
}

TEST(Split, PlanesOfItsOwnFacesMakeNoEmptyPiece) {
  const Convex cylinder = makeCylinder(0.37f, 0.11f, 29);
  Cutting c;
  for (const Face& face : cylinder.faces) {
    for (const Plane& plane : {face.plane, face.plane.flipped()}) {
      EXPECT_NE(c.cut(cylinder, plane), SplitOutcome::Split);
    }
  }
}

TEST(Split, MirroredPlanesGiveTheSamePieces) {
  CutCube<float> cube(CutMode::AtRandom, 46);
  Cutting c;
  for (int i = 0; i < 20000; ++i) {
    if (cube.step() != SplitOutcome::Split) continue;
    bool isTouching = false;  // a vertex in the plane is above, whichever side that is
    for (const Vertex& vertex : cube.parent.vertices) {
      isTouching = isTouching || cube.plane.distance(vertex.point) == 0.0f;
    }
    if (isTouching) continue;
    ASSERT_EQ(c.cut(cube.parent, cube.plane.flipped()), SplitOutcome::Split);
    ASSERT_EQ(c.above.vertices.size(), cube.below.vertices.size());
    for (const Vertex& vertex : c.above.vertices) {
      bool isFound = false;
      for (const Vertex& other : cube.below.vertices) isFound = isFound || isSame(vertex.point, other.point);
      ASSERT_TRUE(isFound) << i;
    }
  }
}

TEST(Split, ShadesCutVerticesBetweenTheirEnds) {
  Convex box = makeBox<float>(Vec3::Ones());
  for (Vertex& vertex : box.vertices) {
    const bool isRight = vertex.point.x() > 0.0f;
    vertex.color = isRight ? 0xff4080c0u : 0xff000000u;
    vertex.normal = packNormal(isRight ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY()));
  }
  Cutting c;
  ASSERT_EQ(c.cut(box, {Vec3::UnitX(), 0.0f}), SplitOutcome::Split);
  const float half = 0.70710678f;
  for (std::size_t i = 4; i < 8; ++i) {
    EXPECT_EQ(c.above.vertices[i].color, 0xff204060u);
    EXPECT_LT((unpackNormal(c.above.vertices[i].normal) - Vec3(half, half, 0.0f)).norm(), 0.01f);
  }
  ASSERT_EQ(c.cut(box, {Vec3::UnitX(), 0.5f}), SplitOutcome::Split);
  for (std::size_t i = 4; i < 8; ++i) EXPECT_EQ(c.above.vertices[i].color, 0xff306090u);
  box.vertices[0].normal = 0;
  ASSERT_EQ(c.cut(box, {Vec3::UnitX(), 0.0f}), SplitOutcome::Split);
  int unshaded = 0;
  for (std::size_t i = 4; i < 8; ++i) unshaded += c.above.vertices[i].normal == 0 ? 1 : 0;
  EXPECT_EQ(unshaded, 1);
}

TEST(Split, SliversCutInEveryDirectionKeepTheirVolume) {
  for (const float thickness : {1e-4f, 1e-6f}) {
    const Convex sliver = makeBox<float>(Vec3(0.5f, 0.5f, 0.5f * thickness));
    Random random(48);
    Cutting c;
    int splits = 0;
    for (int i = 0; i < 100; ++i) {
      const float x = random.nextFloat(-1.0f, 1.0f);
      const float y = random.nextFloat(-1.0f, 1.0f);
      const float z = random.nextFloat(-1.0f, 1.0f);
      const Vec3 normal = normalizedOr(Vec3(x, y, z), Vec3::UnitX());
      if (c.cut(sliver, {normal, random.nextFloat(-0.4f, 0.4f)}) != SplitOutcome::Split) continue;
      ++splits;
      ASSERT_STREQ(findTopologyError(c.above.view()), nullptr);
      ASSERT_STREQ(findTopologyError(c.below.view()), nullptr);
      ASSERT_NEAR((volumeOf<double>(c.above) + volumeOf<double>(c.below)) / volumeOf<double>(sliver), 1.0, 1e-6);
    }
    EXPECT_GT(splits, 50);
  }
}

// A cut vertex keeps its distance from the end of its edge: 2^-20 of the extent.
TEST(Split, MovesCutVerticesAwayFromVertices) {
  const Vec3 corners[] = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  const Convex tetrahedron = *makeHull(corners);
  Cutting c;
  for (const float offset : {0.0f, 1e-9f, -1e-9f}) {
    ASSERT_EQ(c.cut(tetrahedron, {normalizedOr(Vec3(-1.0f, 1.0f, 0.0f), Vec3::UnitX()), offset}), SplitOutcome::Split);
    float nearest = 1.0f;
    for (const Vec3& cap : capOf(c.below)) {
      for (const Vertex& vertex : tetrahedron.vertices) nearest = minOf(nearest, (cap - vertex.point).norm());
    }
    EXPECT_NEAR(nearest, 0x1p-20f, 0x1p-24f);
  }
}

// Cones: a vertex where many faces meet, cut right through it.
TEST(Split, VerticesOfHighDegreeAreCutThrough) {
  Random random(49);
  Cutting c;
  for (int sides = 3; sides <= 100; sides += 7) {
    std::vector<Vec3> points = {Vec3::Zero()};
    for (const Vertex& vertex : makeCylinder(1.0f, 1.0f, sides).vertices) {
      if (vertex.point.y() > 0.0f) points.push_back(vertex.point);
    }
    const Result<Convex> cone = makeHull(points);
    ASSERT_TRUE(cone);
    ASSERT_EQ(cone->faces.size(), static_cast<std::size_t>(sides) + 1);
    for (int i = 0; i < 100; ++i) {
      const float x = random.nextFloat(-1.0f, 1.0f);
      const float z = random.nextFloat(-1.0f, 1.0f);
      const float y = random.nextFloat(-0.3f, 0.3f);
      const float offset = i % 4 == 0 ? 1e-7f : i % 4 == 1 ? -1e-7f : 0.0f;
      if (c.cut(*cone, {normalizedOr(Vec3(x, y, z), Vec3::UnitX()), offset}) != SplitOutcome::Split) continue;
      ASSERT_STREQ(findTopologyError(c.above.view()), nullptr);
      ASSERT_STREQ(findTopologyError(c.below.view()), nullptr);
      ASSERT_NEAR(volumeOf<double>(c.above) + volumeOf<double>(c.below), volumeOf<double>(*cone), 2e-6);
    }
  }
}

TEST(Split, AllocatesNothingWhenWarm) {
  CutCube<float> cube(CutMode::AtRandom, 50);
  Cutting c;
  c.cut(makeCylinder(1.0f, 1.0f, 100), {Vec3::UnitY(), 0.0f});
  const void* const before[] = {c.above.vertices.data(),  c.above.faces.data(),   c.above.edges.data(),
                                c.scratch.indices.data(), c.scratch.sides.data(), c.scratch.caps.data()};
  for (int i = 0; i < 1000; ++i) {
    cube.step();
    c.cut(cube.parent, cube.plane);
  }
  const void* const after[] = {c.above.vertices.data(),  c.above.faces.data(),   c.above.edges.data(),
                               c.scratch.indices.data(), c.scratch.sides.data(), c.scratch.caps.data()};
  for (std::size_t i = 0; i < std::size(before); ++i) EXPECT_EQ(before[i], after[i]);
}

}  // namespace
}  // namespace brittle::geometry
