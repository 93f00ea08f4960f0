#include "engine/geometry/make.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/geometry/mass.h"
#include "engine/math/transform.h"
#include "tests/engine/geometry/cutting.h"

namespace brittle::geometry {
namespace {

std::vector<Vec3> pointsOf(const Convex& convex) {
  std::vector<Vec3> points;
  for (const Vertex& vertex : convex.vertices) points.push_back(vertex.point);
  return points;
}

TEST(Make, BoxHasItsPlanesThroughItsCorners) {
  const Convex box = makeBox<float>(Vec3(0.1f, 0.2f, 0.3f), Vec3(1.0f, 2.0f, 3.0f));
  ASSERT_STREQ(findTopologyError(box.view()), nullptr);
  EXPECT_EQ(convexityError(box), 0.0f);
  for (std::uint32_t i = 0; i < 6; ++i) {
    const Edge& edge = box.edges[box.faces[i].edge];
    EXPECT_EQ(box.faces[i].plane.distance(box.vertices[edge.vertex].point), 0.0f);
  }
  EXPECT_NEAR(massOf(box.view()).volume, 8 * 0.1f * 0.2f * 0.3f, 1e-7);
}

TEST(Make, CylinderHasTheVolumeOfItsPolygon) {
  for (const int sides : {3, 4, 5, 8, 32, 1000, 10000}) {
    const Convex cylinder = makeCylinder(0.5f, 1.0f, sides);
    ASSERT_STREQ(findTopologyError(cylinder.view()), nullptr) << sides;
    const double area = 0.5 * sides * 0.25 * std::sin(2.0 * 3.14159265358979 / sides);
    EXPECT_NEAR(massOf(cylinder.view()).volume, 2.0 * area, 2e-6) << sides;
    if (sides <= 1000) {
      EXPECT_LT(convexityError(cylinder), 2e-7f) << sides;
    }
  }
}

TEST(Make, SmoothCylinderShadesOutwards) {
  for (const Vertex& vertex : makeCylinder(2.0f, 1.0f, 16).vertices) {
    const Vec3 radial(vertex.point.x() / 2.0f, 0.0f, vertex.point.z() / 2.0f);
    EXPECT_LT((unpackNormal(vertex.normal) - radial).norm(), 0.01f);
  }
  for (const Vertex& vertex : makeCylinder(2.0f, 1.0f, 16, false).vertices) EXPECT_EQ(vertex.normal, 0u);
}

TEST(Make, PrismHasTheVolumeOfItsPolygon) {
  const Vec2 pentagon[] = {{0.0f, 0.0f}, {2.0f, 0.0f}, {3.0f, 1.0f}, {2.0f, 2.0f}, {0.0f, 2.0f}};
  const Result<Convex> prism = makePrism(pentagon, 0.25f);
  ASSERT_TRUE(prism) << prism.error().message;
  EXPECT_STREQ(findTopologyError(prism->view()), nullptr);
  EXPECT_NEAR(massOf(prism->view()).volume, 5.0f * 0.5f, 1e-6);
  EXPECT_LT(convexityError(*prism), 3e-7f);
}

TEST(Make, PrismRefusesPolygonsThatAreNotConvex) {
  const Vec2 two[] = {{0.0f, 0.0f}, {1.0f, 0.0f}};
  const Vec2 clockwise[] = {{0.0f, 0.0f}, {0.0f, 1.0f}, {1.0f, 0.0f}};
  const Vec2 inLine[] = {{0.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.0f}, {1.0f, 1.0f}};
  const Vec2 dent[] = {{0.0f, 0.0f}, {2.0f, 0.0f}, {1.0f, 0.5f}, {1.0f, 2.0f}};
  const Vec2 star[] = {{0.0f, 1.0f}, {-0.588f, -0.809f}, {0.951f, 0.309f}, {-0.951f, 0.309f}, {0.588f, -0.809f}};
  EXPECT_EQ(makePrism(two, 1.0f).error().message, "a prism needs at least 3 corners (2 given)");
  EXPECT_EQ(makePrism(star, 1.0f).error().message, "a prism's corners must go round once (5 given)");
  const std::string turns = "a prism's corners must turn left, no three in a line";
  EXPECT_EQ(makePrism(clockwise, 1.0f).error().message, turns + " (3 given)");
  EXPECT_EQ(makePrism(inLine, 1.0f).error().message, turns + " (4 given)");
  EXPECT_EQ(makePrism(dent, 1.0f).error().message, turns + " (4 given)");
  EXPECT_FALSE(makePrism(clockwise, 0.0f));
}

TEST(Make, HullOfABoxIsTheBox) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const float x = random.nextFloat(0.01f, 1.0f);
    const float y = random.nextFloat(0.01f, 1.0f);
    const float z = random.nextFloat(0.01f, 1.0f);
    const Quat rotation = drawRotation(random);
    const Vec3 translation = 3.0f * drawVector(random);
    const Convex box = transformed(makeBox<float>(Vec3(x, y, z)), rotation, translation);
    std::vector<Vec3> points = pointsOf(box);
    for (int k = 0; k < 4; ++k) points.push_back(0.5f * (points[0] + points[static_cast<std::size_t>(k) + 1]));
    const Result<Convex> hull = makeHull(points);
    ASSERT_TRUE(hull) << hull.error().message;
    EXPECT_EQ(hull->faces.size(), 6u) << i;
    EXPECT_EQ(hull->vertices.size(), 8u) << i;
    EXPECT_STREQ(findTopologyError(hull->view()), nullptr);
    EXPECT_NEAR(massOf(hull->view()).volume / (8.0f * x * y * z), 1.0f, 1e-4f);
  }
}

TEST(Make, HullOfRandomPointsHoldsThemAll) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    std::vector<Vec3> points;
    const std::uint32_t count = 4 + random.nextBelow(60);
    const bool onSphere = random.nextBelow(2) == 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      const Vec3 drawn = drawVector(random);
      points.push_back(onSphere ? normalizedOr(drawn, Vec3::UnitX()) : drawn);
    }
    const Result<Convex> hull = makeHull(points);
    ASSERT_TRUE(hull) << hull.error().message;
    ASSERT_STREQ(findTopologyError(hull->view()), nullptr);
    for (const Face& face : hull->faces) {
      for (const Vec3& point : points) ASSERT_LT(face.plane.distance(point), 2e-5f) << i;
    }
  }
}

// Cubes of grid points: every face full of coplanar points, every edge of points in a line, every corner of one kind.
TEST(Make, HullOfGridsMergesWhatLiesInOnePlane) {
  for (int size = 1; size <= 5; ++size) {
    std::vector<Vec3> points;
    for (int x = 0; x <= size; ++x) {
      for (int y = 0; y <= size; ++y) {
        for (int z = 0; z <= size; ++z) points.push_back(0.1f * Vec3(Vec3(x, y, z)));
      }
    }
    const Result<Convex> hull = makeHull(points);
    ASSERT_TRUE(hull) << hull.error().message;
    EXPECT_EQ(hull->faces.size(), 6u);
    EXPECT_EQ(hull->vertices.size(), 8u);
  }
}

TEST(Make, HullDoesNotDependOnTheOrderOfPoints) {
  Random random(3);
  const Convex cylinder = transformed(makeCylinder(0.3f, 0.2f, 24), drawRotation(random), Vec3(1.0f, 0.0f, 0.0f));
  std::vector<Vec3> points = pointsOf(cylinder);
  for (int i = 0; i < 50; ++i) {
    for (std::size_t k = points.size() - 1; k > 0; --k) {
      std::swap(points[k], points[random.nextBelow(static_cast<std::uint32_t>(k + 1))]);
    }
    const Result<Convex> hull = makeHull(points);
    ASSERT_TRUE(hull);
    EXPECT_EQ(hull->faces.size(), 26u);
    EXPECT_EQ(hull->vertices.size(), 48u);
  }
}

TEST(Make, HullRefusesFlatAndBrokenInput) {
  const Vec3 square[] = {
      {0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.5f, 0.5f, 0.0f}};
  EXPECT_EQ(makeHull(square).error().message, "a hull's points must not lie in one plane (5 points given)");
  EXPECT_EQ(makeHull(std::span(square, 3)).error().message, "a hull needs at least 4 points (3 points given)");
  const Vec3 same[] = {square[0], square[0], square[0], square[0]};
  EXPECT_FALSE(makeHull(same));
  const Vec3 nearlyFlat[] = {square[0], square[1], square[2], square[3], {0.5f, 0.5f, 1e-6f}};
  EXPECT_FALSE(makeHull(nearlyFlat));
  const Vec3 broken[] = {square[0], square[1], square[2], {0.0f, 0.0f, std::nanf("")}};
  EXPECT_EQ(makeHull(broken).error().message, "a hull's points must be finite (4 points given)");
}

TEST(Make, TransformedKeepsPlanesOnTheFaces) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Vec3 scale = 1.5f * Vec3::Ones() + drawVector(random);
    const Convex moved = transformed(makeCylinder(0.5f, 0.5f, 12), drawRotation(random), drawVector(random), scale);
    EXPECT_LT(convexityError(moved), 1e-6f);
    const float factor = scale.x() * scale.y() * scale.z();
    EXPECT_NEAR(massOf(moved.view()).volume, factor * 12 * 0.5f * 0.25f * 0.5f, 1e-5f * factor);
  }
}

}  // namespace
}  // namespace brittle::geometry
