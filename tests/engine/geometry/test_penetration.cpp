// The depth of an overlap against brute force: the largest separation over every face normal and every pair of edges.
#include "engine/geometry/penetration.h"

#include <gtest/gtest.h>

#include "tests/engine/geometry/shapes.h"

namespace brittle::geometry {
namespace {

using test::box;
using test::randomPose;
using test::worldPoints;

/// Four points in a box 0.01 to 2 mm thin and 2 m long: most edges lie between nearly opposite faces.
Convex randomSliver(Random& random) {
  const float thin = random.nextBelow(2) == 0 ? 1e-4f : 1e-5f;
  const Vec3 scale(thin * random.nextFloat(0.5f, 10.0f), random.nextFloat(0.2f, 1.0f), 1.0f);
  std::vector<Vec3> points;
  for (int i = 0; i < 4; ++i) {
    Vec3 point;
    for (int k = 0; k < 3; ++k) point[k] = scale[k] * random.nextFloat(-1.0f, 1.0f);
    points.push_back(point);
  }
  const bool isLeft = (points[1] - points[0]).cross(points[2] - points[0]).dot(points[3] - points[0]) < 0.0f;
  if (isLeft) std::swap(points[0], points[1]);
  return test::fromFaces(points, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
}

Convex randomPlate(Random& random) {
  return box(Vec3(random.nextFloat(0.02f, 0.1f), random.nextFloat(5e-4f, 5e-3f), random.nextFloat(0.02f, 1.0f)));
}

/// Half of the poses are nearly upright: then the least depth is across a sliver, along an axis next to its faces'.
Transform choosePose(Random& random) {
  Transform pose = randomPose(random, 0.05f);
  const bool isUpright = random.nextBelow(2) == 0;
  const Vec3 turn(random.nextFloat(-1e-3f, 1e-3f), random.nextFloat(-1e-3f, 1e-3f), random.nextFloat(-1e-3f, 1e-3f));
  if (isUpright) pose.rotation = integrateRotation(Quat::Identity(), turn, 1.0f);
  return pose;
}

/// Of the pairs that overlap, in both orders.
void expectTheLeastDepth(const Convex& a, const Transform& poseA, const Convex& b, const Transform& poseB,
                         int& overlapping) {
  const double expected = test::slowSeparation(a, worldPoints(a, poseA), b, worldPoints(b, poseB));
  if (expected > -1e-5) return;
  ++overlapping;
  const Penetration ab = leastPenetration(a.view(), b.view(), relativePose(poseA, poseB), 0, 0, 0);
  const Penetration ba = leastPenetration(b.view(), a.view(), relativePose(poseB, poseA), 0, 0, 0);
  EXPECT_NEAR(ab.separation, expected, 1e-6);
  EXPECT_NEAR(ba.separation, expected, 1e-6);
}

TEST(Penetration, OfSliversAndPlatesIsTheLeastOverFacesAndPairsOfEdges) {
  Random random(31);
  int overlapping = 0;
  for (int i = 0; i < 5000; ++i) {
    const Convex sliver = randomSliver(random), plate = randomPlate(random), other = randomSliver(random);
    const Transform pose = choosePose(random), otherPose = choosePose(random);
    expectTheLeastDepth(sliver, pose, plate, otherPose, overlapping);
    expectTheLeastDepth(sliver, pose, other, otherPose, overlapping);
  }
  EXPECT_GT(overlapping, 1000);
}

}  // namespace
}  // namespace brittle::geometry
