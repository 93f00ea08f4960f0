// B5: slivers of 1 x 1 x 1e-4 m and 1 x 1 x 1e-6 m, cut a thousand times, each time afresh in another direction, and
// one piece after another. No topology failure; the inertia of every piece is positive definite; what is kept and what
// becomes debris add up to the sliver within 1e-6. A piece thinner than the least thickness is not made in the first
// place: the cut is refused, and counted.
#include <gtest/gtest.h>

#include "engine/fracture/fracture.h"
#include "engine/geometry/mass_impl.h"
#include "tests/engine/geometry/mating.h"
#include "tests/hard_cases/case.h"

namespace brittle::geometry {
namespace {

Vec3 drawDirection(Random& random) {
  return normalizedOr(drawVector(random), Vec3::UnitX());
}

class B5 : public testing::TestWithParam<float> {
 protected:
  const Convex sliver = makeBox<float>(Vec3(0.5f, 0.5f, 0.5f * GetParam()));
  const double volume = volumeOf<double>(sliver);
  SplitScratch scratch;
  Convex above, below;

  /// Whether it was cut; the pieces are then `above` and `below`.
  bool cut(const Convex& parent, const Plane& plane) {
    if (split<float>(parent.view(), plane, {}, scratch, above, below) != SplitOutcome::Split) {
      hard::reportSum("cuts refused", 1);
      return false;
    }
    hard::reportSum("cuts", 1);
    EXPECT_STREQ(findCutError(parent, plane, above, below), nullptr);
    for (const Convex* piece : {&above, &below}) expectInertia(*piece);
    return true;
  }

  static void expectInertia(const Convex& piece) {
    const MassProperties mass = massOf(piece.view());
    EXPECT_GT(mass.volume, 0.0f);
    EXPECT_GT(mass_detail::smallestPivot(mass.inertia.cast<double>()), 0.0);
  }
};

TEST_P(B5, OneCutInEveryDirection) {
  Random random(48);
  int splits = 0;
  for (int i = 0; i < hard::counted(1000, 100000); ++i) {
    const Vec3 normal = drawDirection(random);
    if (!cut(sliver, {normal, random.nextFloat(-0.4f, 0.4f)})) continue;
    ++splits;
    const double lost = std::abs((volumeOf<double>(above) + volumeOf<double>(below)) / volume - 1.0);
    EXPECT_LE(lost, 1e-6) << i;
    hard::reportWorst("one cut's volume off by", lost);
  }
  EXPECT_GT(splits, hard::counted(500, 50000));
}

TEST_P(B5, PieceAfterPiece) {
  for (int round = 0; round < hard::counted(2, 100); ++round) {
    Random random(49, static_cast<std::uint64_t>(round));
    std::vector<Convex> pieces = {sliver};
    for (int i = 0; i < 1000; ++i) {
      Convex& chosen = pieces[random.nextBelow(static_cast<std::uint32_t>(pieces.size()))];
      const Vec3 through = chosen.vertices[random.nextBelow(static_cast<std::uint32_t>(chosen.vertices.size()))].point;
      const Vec3 center = massOf(chosen.view()).center;
      const Vec3 at = center + (through - center) * random.nextFloat(0.0f, 1.0f);
      if (!cut(chosen, planeThrough(at, drawDirection(random)))) continue;
      chosen.assign(above.view());
      pieces.push_back(below);
    }
    EXPECT_GT(pieces.size(), 200u);
    double total = 0.0;
    for (const Convex& piece : pieces) total += volumeOf<double>(piece);
    EXPECT_NEAR(total / volume, 1.0, 1e-6);
    hard::reportWorst("a thousand cuts' by", std::abs(total / volume - 1.0));
  }
}

TEST_P(B5, KeptPiecesAndDebrisAddUp) {
  fracture::Fracturer fracturer;
  fracture::Part part;
  part.convex = sliver.view();
  for (const auto pattern : {fracture::Pattern::Pane, fracture::Pattern::Block, fracture::Pattern::Tempered}) {
    fracture::FractureMaterial material;
    material.pattern = pattern;
    material.minVolume = static_cast<float>(1e-3 * volume);
    for (int seed = 0; seed < hard::counted(40, 2000); ++seed) {
      Random random(50, static_cast<std::uint64_t>(seed));
      fracture::Impact impact;
      for (int k = 0; k < 3; ++k) impact.point[k] = random.nextFloat(-0.5f, 0.5f);
      impact.direction = drawDirection(random);
      impact.speed = 10.0f;
      const fracture::Fracture& made =
          fracturer.fracture({&part, 1}, {&impact, 1}, material, 1e-3f, static_cast<std::uint64_t>(seed));
      double kept = 0.0, debris = 0.0;
      for (const fracture::Piece& piece : made.pieces) kept += piece.mass.volume;
      for (const fracture::Crumb& crumb : made.crumbs) debris += crumb.volume;
      EXPECT_NEAR((kept + debris) / volume, 1.0, 1e-6) << seed;
      hard::reportWorst("pieces and debris by", std::abs((kept + debris) / volume - 1.0));
      hard::reportSum("breakings", 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Thickness, B5, testing::Values(1e-4f, 1e-6f));

}  // namespace
}  // namespace brittle::geometry
