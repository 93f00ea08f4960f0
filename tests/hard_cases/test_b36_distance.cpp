// B36: distances of slivers of 1e-4, of neighbours that share a face, and of fresh shards deep in each other, within
// 1e-5 of the extent; normals unit within 1e-6; no search ends at its cap.
// (And the rounding of coordinates and of the answer, 2^-24 m here: it is more than that of specks of 0.2 mm.) Closest
// points are asked for beyond 1e-7 m: of what touches, the answer has an axis and a distance, and points of contact
// that need not be closest.
// Apart, the answer proves itself (duality of linear programs): two points, one in each body, that far apart, and a
// direction along which the bodies are that far apart; no unfinished search has both. In each other, the depth is the
// least over all axes, each face and pair of edges, tried one by one in double.
#include <gtest/gtest.h>

#include "engine/geometry/gjk.h"
#include "tests/engine/geometry/cutting.h"
#include "tests/engine/geometry/shapes.h"
#include "tests/hard_cases/case.h"

namespace brittle::geometry {
namespace {

struct Placed {
  const Convex& convex;
  Transform pose;
  std::vector<Vec3d> points = test::worldPoints(convex, pose);

  Proxy proxy() const { return {convex.view(), Vec3::Zero(), 0.0f}; }
  Vec3d normal(const Face& face) const {
    return pose.rotation.cast<double>().normalized() * face.plane.normal.cast<double>().normalized();
  }
  /// How far the point is outside. [m]
  double outside(const Vec3d& point) const {
    double most = -1e300;
    for (const Face& face : convex.faces) {
      const Vec3d n = normal(face);
      double offset = -1e300;  // of the vertices, which are what is measured
      for (const Vec3d& p : points) offset = maxOf(offset, n.dot(p));
      most = maxOf(most, n.dot(point) - offset);
    }
    return most;
  }
};

/// The largest separation over all axes: of the stored planes too, for faces whose first corners are all but one.
double separationOverAllAxes(const Placed& a, const Placed& b) {
  double best = test::slowSeparation(a.convex, a.points, b.convex, b.points);
  for (const Face& face : a.convex.faces) best = maxOf(best, test::widthAlong(a.points, b.points, a.normal(face)));
  for (const Face& face : b.convex.faces) best = maxOf(best, test::widthAlong(a.points, b.points, -b.normal(face)));
  return best;
}

void expectExact(const Placed& a, const Placed& b) {
  SimplexCache cache;
  const Separation found = separation(a.proxy(), a.pose, b.proxy(), b.pose, cache);
  ASSERT_TRUE(isFinite(found.distance) && isFinite(found.normal) && isFinite(found.pointA) && isFinite(found.pointB));
  const double extent = maxOf(extentOf(a.convex.view()), extentOf(b.convex.view()));
  const double tolerance = 1e-5 * extent + 0x1p-24 * (1.0 + maxOf(found.distance, 0.0f));
  const double length = found.normal.cast<double>().norm();
  EXPECT_NEAR(length, 1.0, 1e-6);
  hard::reportWorst("normal off unit by", std::abs(length - 1.0));
  const double along = test::widthAlong(a.points, b.points, found.normal.cast<double>() / length);
  double off = std::abs(along - found.distance);
  if (found.distance > 1e-7f) {
    // Points are floats in the world.
    const double rounding =
        0x1p-22 * (1.0 + a.pose.position.cast<double>().norm() + b.pose.position.cast<double>().norm());
    const Vec3d pointA = found.pointA.cast<double>(), pointB = found.pointB.cast<double>();
    EXPECT_NEAR((pointB - pointA).norm(), found.distance, tolerance + rounding);
    EXPECT_LE(maxOf(a.outside(pointA), b.outside(pointB)), tolerance + rounding);
    hard::reportSum("pairs apart", 1);
  } else {
    off = maxOf(off, std::abs(separationOverAllAxes(a, b) - found.distance));
    hard::reportSum("pairs in each other", 1);
  }
  EXPECT_LE(off, tolerance);
  if (extent > 0.01) hard::reportWorst("distance off by", off / extent, "of the extent");
}

/// Thin in one direction, or in two.
Vec3 sliverScale(Random& random) {
  Vec3 scale = Vec3::Constant(1e-4f);
  scale[random.nextBelow(3)] = 1.0f;
  scale[random.nextBelow(3)] = random.nextFloat(0.3f, 1.0f);
  return scale;
}

TEST(B36, SliversInAnyPose) {
  Random random(111);
  for (int i = 0; i < hard::counted(1500, 200000); ++i) {
    const Convex a = test::randomHull(random, 10, sliverScale(random));
    const Convex b = test::randomHull(random, 10, i % 2 == 0 ? sliverScale(random) : Vec3(Vec3::Ones()));
    const float reach = i % 3 == 0 ? 1e-3f : 0.6f;
    SCOPED_TRACE(i);
    expectExact({a, test::randomPose(random, reach)}, {b, test::randomPose(random, reach)});
  }
}

class B36Shards : public testing::TestWithParam<CutMode> {};

/// Shards of a cube where they were cut, turned and moved alike: the pairs that share a face touch.
TEST_P(B36Shards, NeighboursWhereTheyWereCut) {
  for (int round = 0; round < hard::counted(1, 50); ++round) {
    CutCube<float> cube(GetParam(), 112 + static_cast<std::uint64_t>(round), 48);
    while (!cube.isFull()) cube.step();
    Random random(113, static_cast<std::uint64_t>(round));
    const Transform pose = round == 0 ? Transform{} : test::randomPose(random, 1.0f);
    for (std::size_t i = 0; i < cube.count(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        SCOPED_TRACE(testing::Message() << "round " << round << ", pieces " << i << ", " << k);
        expectExact({cube.piece(i), pose}, {cube.piece(k), pose});
      }
  }
}

/// The same pushed into each other, up to their own size.
TEST_P(B36Shards, ShardsDeepInEachOther) {
  CutCube<float> cube(GetParam(), 114, 256);
  while (!cube.isFull()) cube.step();
  Random random(115);
  for (int i = 0; i < hard::counted(1000, 100000); ++i) {
    const Convex& a = cube.piece(random.nextBelow(256));
    const Convex& b = cube.piece(random.nextBelow(256));
    Transform pose = test::randomPose(random, 0.0f);
    const float depth = random.nextFloat(0.0f, 1.0f);
    const Vec3 centerA = a.vertices[0].point * 0.5f + a.vertices.back().point * 0.5f;
    const Vec3 centerB = b.vertices[0].point * 0.5f + b.vertices.back().point * 0.5f;
    pose.position = centerA - pose.rotate(centerB) + Vec3::UnitX() * (depth * extentOf(a.view()));
    SCOPED_TRACE(i);
    expectExact({a, {}}, {b, pose});
  }
}

INSTANTIATE_TEST_SUITE_P(AllModes, B36Shards, testing::ValuesIn(kCutModes), [](const auto& instance) {
  return std::string(kCutModeNames[static_cast<int>(instance.param)]);
});

}  // namespace
}  // namespace brittle::geometry
