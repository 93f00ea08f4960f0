#include "engine/fracture/pattern.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/fracture/chunk.h"
#include "engine/geometry/make.h"
#include "engine/math/trig.h"
#include "tests/engine/fracture/scene.h"

namespace brittle::fracture {
namespace {

TEST(Pattern, RadialCracksGrowWithTheRootOfSpeed) {
  // Least squares of log(count) against log(speed), 5 to 120 m/s.
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (float speed = 5.0f; speed <= 120.0f; speed += 1.0f) {
    const double x = std::log(speed), y = std::log(static_cast<double>(radialCount({}, speed)));
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  EXPECT_NEAR((n * sxy - sx * sy) / (n * sxx - sx * sx), 0.5, 0.1);
  FractureMaterial dense;
  dense.density = 2.0f;
  EXPECT_EQ(radialCount(dense, 10.0f), 2 * radialCount({}, 10.0f));
}

/// A cell is closed if it cuts a bounded piece out of a huge box.
float widestReach(const Cell& cell, const Vec3& center) {
  Scene scene;
  scene.addBox(Vec3::Constant(64.0f), center);
  std::vector<geometry::Convex> made;
  ChunkStore store;
  store.begin(scene.parts, made);
  Chunk inside;
  for (std::uint32_t i = 0; i < cell.count; ++i) {
    Chunk above, below;
    if (store.cut(inside, cell.walls[i], above, below) == CutResult::Split) inside = below;
  }
  float reach = 0.0f;
  for (const geometry::Vertex& vertex : store.view(inside).vertices)
    reach = maxOf(reach, (vertex.point - center).norm());
  return reach;
}

TEST(Pattern, BlockCellsAreClosedAndHoldTheStriker) {
  const Scene scene = block();
  const Strike strike = strikeOf(scene.parts, straightAt({0.0f, 0.0f, 0.25f}, 10.0f, 0.1f), {});
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    const Cell cell = blockCell(strike, random);
    ASSERT_GE(cell.count, kMinWalls);
    ASSERT_LE(cell.count, kMaxWalls);
    for (std::uint32_t i = 0; i < cell.count; ++i) EXPECT_LE(cell.walls[i].distance(strike.center), -0.1f);
    EXPECT_LT(widestReach(cell, strike.center), 4.0f * strike.radius) << seed;
  }
}

TEST(Pattern, SheetCellsAreClosedAroundTheStrikerWhateverTheSlant) {
  const Scene scene = pane();
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random random(seed);
    Impact impact = straightAt({0.1f, 0.2f, 0.01f}, 3.0f, 0.06f);
    const float slant = random.nextFloat(0.0f, 1.0472f);
    impact.direction = Vec3(sine(slant), 0.0f, -cosine(slant));
    const Strike strike = strikeOf(scene.parts, impact, {});
    const Cell cell = sheetCell(strike, random);
    ASSERT_GE(cell.count, kMinWalls);
    EXPECT_LT(cell.walls[0].distance(Vec3(0.0f, 0.0f, 0.01f)), 0.0f);
    EXPECT_LT(cell.walls[1].distance(Vec3(0.0f, 0.0f, 0.01f)), 0.0f);
    for (std::uint32_t i = 2; i < cell.count; ++i) {
      EXPECT_NEAR(cell.walls[i].normal.dot(strike.normal), 0.0f, 1e-6f);
      EXPECT_LE(cell.walls[i].distance(strike.passage) + reachWithinSheet(strike, 0.06f, cell.walls[i].normal), 1e-6f);
      // Neighbouring walls turn by less than a right angle somewhere on both sides: the polygon is closed.
      float leastTurn = 4.0f;
      for (std::uint32_t k = 2; k < cell.count; ++k) {
        const float turn = arcTangent(cell.walls[i].normal.cross(cell.walls[k].normal).dot(strike.normal),
                                      cell.walls[i].normal.dot(cell.walls[k].normal));
        if (k != i && turn > 0.0f) leastTurn = minOf(leastTurn, turn);
      }
      EXPECT_LT(leastTurn, 0.5f * kPi);
    }
  }
}

TEST(Pattern, SheetCracksAreATree) {
  const Scene scene = pane();
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const float speed = random.nextFloat(0.0f, 120.0f);
    const Strike strike = strikeOf(scene.parts, straightAt(Vec3::Zero(), speed), {});
    CrackTree tree;
    growSheetCracks(strike, {}, speed, random, tree);
    ASSERT_FALSE(tree.cracks.empty());
    std::vector<int> parents(tree.cracks.size(), 0);
    for (const Crack& crack : tree.cracks) {
      EXPECT_NEAR(crack.plane.normal.norm(), 1.0f, 1e-6f);
      EXPECT_NEAR(crack.plane.normal.dot(strike.normal), 0.0f, 1e-6f);
      for (const std::int32_t child : {crack.above, crack.below}) {
        if (child != kNoCrack) ++parents[static_cast<std::size_t>(child)];
      }
    }
    EXPECT_EQ(parents[0], 0);
    for (std::size_t i = 1; i < parents.size(); ++i) EXPECT_EQ(parents[i], 1);
  }
}

}  // namespace
}  // namespace brittle::fracture
