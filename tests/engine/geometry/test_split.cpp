#include "engine/geometry/split.h"

#include <gtest/gtest.h>

#include <cstring>

#include "engine/core/hash.h"
#include "engine/geometry/mass.h"
#include "tests/engine/geometry/cutting.h"

namespace brittle::geometry {
namespace {

bool isSame(const Vec3& a, const Vec3& b) {
  return std::memcmp(a.data(), b.data(), sizeof(float) * 3) == 0;
}
bool isSame(const Plane& a, const Plane& b) {
  return isSame(a.normal, b.normal) && a.offset == b.offset;
}

/// The corners of the last face, in loop order.
std::vector<Vec3> capOf(const Convex& piece) {
  std::vector<Vec3> corners;
  const std::uint32_t first = piece.faces.back().edge;
  std::uint32_t edge = first;
  do {
    corners.push_back(piece.view().startOf(edge));
    edge = piece.edges[edge].next;
  } while (edge != first);
  return corners;
}

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

// A cylinder of many sides gets a dome of planes that touch a sphere: each adds a face and takes none away, until 16
// bits no longer count the half-edges.
TEST(Split, RefusesWhenIndicesRunOut) {
  Convex body = makeCylinder(1.0f, 1.5f, 8000);
  Random random(47);
  Cutting c;
  SplitOutcome outcome = SplitOutcome::Split;
  Plane plane;
  for (int i = 0; i < 6000 && outcome != SplitOutcome::TooManyIndices; ++i) {
    const float x = random.nextFloat(-1.0f, 1.0f);
    const float y = random.nextFloat(0.4f, 1.0f);
    const float z = random.nextFloat(-1.0f, 1.0f);
    plane = {normalizedOr(Vec3(x, y, z), Vec3::UnitY()), 0.99f};
    outcome = c.cut(body, plane);
    if (outcome == SplitOutcome::Split) body.assign(c.below.view());
    ASSERT_LE(body.edges.size(), kMaxHalfEdges);
  }
  EXPECT_EQ(outcome, SplitOutcome::TooManyIndices);
  EXPECT_GT(body.edges.size(), kMaxHalfEdges - 12);
  EXPECT_STREQ(findTopologyError(body.view()), nullptr);
  // Refused for one side, and nothing written for the other.
  c.above.clear();
  EXPECT_EQ(c.cut(body, plane), SplitOutcome::TooManyIndices);
  EXPECT_TRUE(c.above.edges.empty());
  // A cut that makes both parts smaller still works.
  ASSERT_EQ(c.cut(body, {Vec3::UnitX(), 0.01f}), SplitOutcome::Split);
  EXPECT_STREQ(findTopologyError(c.above.view()), nullptr);
  EXPECT_STREQ(findTopologyError(c.below.view()), nullptr);
}

TEST(Split, SliversCutInEveryDirectionKeepTheirVolume) {
  for (const float thickness : {1e-4f, 1e-6f}) {
    const Convex sliver = makeBox<float>(Vec3(0.5f, 0.5f, 0.5f * thickness));
    Random random(48);
    Cutting c;
    int splits = 0;
    for (int i = 0; i < 1000; ++i) {
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
    EXPECT_GT(splits, 500);
  }
}

// Cones: a vertex where many faces meet, cut right through it.
TEST(Split, VerticesOfHighDegreeAreCutThrough) {
  Random random(49);
  Cutting c;
  for (int sides = 3; sides <= 200; sides += 7) {
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
