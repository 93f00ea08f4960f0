// B6: vertices of high degree. A box of 2 m is cut by planes that all meet in a point: cones about the six axes, and
// cones about random directions, each plane right through the vertex that the ones before have made. No topology
// failure; vertices keep their order; as long as every sign agrees with the exact one, the same faces and half-edges as
// the exact cutter; volume and faces in the end as Voro++ cuts the same half-spaces, but for facets too thin to be cut.
// No cut is refused for its vertices' rounding: planes a degree apart through one vertex were, and half a percent of
// the volume stayed.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/math/trig.h"
#include "tests/engine/geometry/exact.h"
#include "tests/engine/geometry/mating.h"
#include "tests/hard_cases/case.h"
#include "tests/hard_cases/half_spaces.h"

namespace brittle::geometry {
namespace {

/// Planes about `axis` that all go through one point, `height` [m] from the origin, and slope by `opening` [rad].
void addCone(const Vec3& axis, float height, float opening, int count, std::vector<Plane>& planes) {
  const Vec3 right = perpendicular(axis), up = axis.cross(right), apex = axis * height;
  for (int i = 0; i < count; ++i) {
    const float turn = 2.0f * kPi * static_cast<float>(i) / static_cast<float>(count);
    const Vec3 outward = right * std::cos(turn) + up * std::sin(turn);
    planes.push_back(planeThrough(apex, (axis * std::cos(opening) + outward * std::sin(opening)).normalized()));
  }
}

/// The same cell twice: cut in floats, and exactly for as long as all signs agree.
class Twins {
 public:
  Twins() : cell_(makeBox<float>(Vec3::Ones())), exact_(exactOf(cell_)) {}

  void cut(const Plane& plane) {
    const bool agree = inStep_ && agreesOnSigns(cell_, exact_, plane);
    const SplitOutcome outcome = split<float>(cell_.view(), plane, {}, scratch_, above_, below_);
    inStep_ = agree;
    if (agree) cutExactly(plane, outcome);
    if (outcome == SplitOutcome::TooThin) ++tooThin_;
    ASSERT_NE(outcome, SplitOutcome::TooFarOff);
    if (outcome != SplitOutcome::Split) return;
    ASSERT_STREQ(findCutError(cell_, plane, above_, below_), nullptr);
    cell_.assign(below_.view());
  }
  const Convex& cell() const { return cell_; }
  /// Cuts that would have taken off less than the thinnest piece there is.
  int tooThin() const { return tooThin_; }

 private:
  void cutExactly(const Plane& plane, SplitOutcome outcome) {
    ConvexT<Exact> above, below;
    const SplitOutcome expected = split<Exact>(exact_.view(), exactOf(plane), {}, exactScratch_, above, below);
    if (outcome == SplitOutcome::TooThin) {  // exact pieces may be as thin as they come
      inStep_ = expected != SplitOutcome::Split;
      return;
    }
    ASSERT_EQ(outcome, expected);
    hard::reportSum("cuts compared with exact ones", 1);
    if (outcome != SplitOutcome::Split) return;
    ASSERT_EQ(below_.faces.size(), below.faces.size());
    ASSERT_TRUE(isSameTopology(above_, above));
    ASSERT_TRUE(isSameTopology(below_, below));
    exact_ = below;
  }

  Convex cell_, above_, below_;
  ConvexT<Exact> exact_;
  SplitScratch scratch_;
  SplitScratchT<Exact> exactScratch_;
  bool inStep_ = true;
  int tooThin_ = 0;
};

void expectCell(const std::vector<Plane>& planes) {
  Twins twins;
  for (const Plane& plane : planes) ASSERT_NO_FATAL_FAILURE(twins.cut(plane));
  std::vector<PlaneT<double>> same;
  for (const Plane& plane : planes) same.push_back({plane.normal.cast<double>(), static_cast<double>(plane.offset)});
  const OtherCell other = otherCell(Vec3d::Ones(), Vec3d::Zero(), same);
  const double off = std::abs(volumeOf<double>(twins.cell()) / other.volume - 1.0);
  EXPECT_LE(off, 2e-6);
  EXPECT_LE(facesOf(twins.cell()), other.faces);
  EXPECT_GE(facesOf(twins.cell()) + twins.tooThin(), other.faces);
  hard::reportSum("faces too thin to be cut", other.faces - facesOf(twins.cell()));
  hard::reportWorst("volume off Voro++'s by", off);
  hard::reportWorst("faces up to", other.faces);
  hard::reportSum("cells", 1);
}

void expectConesAboutTheAxes(int count) {
  SCOPED_TRACE(count);
  std::vector<Plane> planes;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) addCone(Vec3::Unit(axis) * side, 0.9f, 0.6f, count, planes);
  expectCell(planes);
}

TEST(B6, ConesAboutTheAxes) {
  for (int count = 3; count <= hard::counted(24, 100); ++count) expectConesAboutTheAxes(count);
}

TEST(B6, ConesWhoseLastThirdWasRefused) {
  for (const int count : {86, 94, 99}) expectConesAboutTheAxes(count);
}

TEST(B6, ConesAboutRandomDirections) {
  for (int seed = 0; seed < hard::counted(60, 5000); ++seed) {
    SCOPED_TRACE(seed);
    Random random(81, static_cast<std::uint64_t>(seed));
    std::vector<Plane> planes;
    for (std::uint32_t cones = 1 + random.nextBelow(4); cones > 0; --cones) {
      const Vec3 axis = normalizedOr(drawVector(random), Vec3::UnitX());
      const float height = random.nextFloat(0.6f, 0.95f);
      const float opening = random.nextFloat(0.3f, 1.1f);
      addCone(axis, height, opening, static_cast<int>(3 + random.nextBelow(40)), planes);
    }
    expectCell(planes);
  }
}

}  // namespace
}  // namespace brittle::geometry
