// B10: mass properties of every piece against exact integrals over the same corners. Volume to 1e-6; centre to 1e-6 of
// the piece's extent; inertia to 1e-5 (Frobenius); both children, joined about the parent's centre of mass (the theorem
// of parallel axes), have the parent's to 1e-5: of parents of 25 cm or more each way that fill a fifth of their bounds,
// since a cut's caps are off its plane by 2^-20 of the extent, which is more of the inertia of a thin parent.
//
// Centre: it is stored in floats in the frame of the body, where a coordinate below 1 m is known to 2^-25 m. For pieces
// smaller than 3 cm at half a metre from the frame's origin that is more than 1e-6 of the extent: the bound is the sum
// of both. Specks thinner than their caps are rough are partly inside out: no integral over them describes a body,
// their volume is exact and their inertia that of their bounds, so they count for the volume alone.
#include <gtest/gtest.h>

#include "engine/geometry/mass.h"
#include "tests/engine/geometry/cutting.h"
#include "tests/engine/geometry/exact.h"
#include "tests/hard_cases/case.h"

namespace brittle::geometry {
namespace {

struct Integrals {
  double volume;
  Vec3d center;
  Mat3d inertia;
};

Integrals exactIntegrals(const Convex& piece) {
  const MassPropertiesT<Exact> exact = massOf(exactOf(piece).view());
  Integrals found;
  found.volume = static_cast<double>(exact.volume);
  for (int i = 0; i < 3; ++i) {
    found.center[i] = static_cast<double>(exact.center[i]);
    for (int j = 0; j < 3; ++j) found.inertia(i, j) = static_cast<double>(exact.inertia(i, j));
  }
  return found;
}

double relativeError(const Mat3& found, const Mat3d& expected) {
  return (found.cast<double>() - expected).norm() / expected.norm();
}

/// Whether a body could have this inertia: no moment exceeds the sum of the others.
bool isOfABody(const Mat3d& inertia) {
  const Mat3d covariance = Mat3d::Identity() * (0.5 * inertia.trace()) - inertia;
  return mass_detail::smallestPivot(covariance) > 0.0;
}

/// Whether it fills a fifth of its bounding box and is at least 25 cm each way.
bool isCompact(const Convex& piece) {
  Vec3d low = Vec3d::Constant(1e9), high = -low;
  for (const Vertex& vertex : piece.vertices) {
    low = low.cwiseMin(vertex.point.cast<double>());
    high = high.cwiseMax(vertex.point.cast<double>());
  }
  const Vec3d size = high - low;
  return size.minCoeff() > 0.25 && volumeOf<double>(piece) > 0.2 * size.prod();
}

class B10 : public testing::TestWithParam<CutMode> {};

TEST_P(B10, AgreesWithExactIntegrals) {
  CutCube<float> cube(GetParam(), 61);
  for (int attempt = 0; attempt < hard::counted(2500, 250000); ++attempt) {
    if (cube.step() != SplitOutcome::Split) continue;
    const Convex& piece = attempt % 2 == 0 ? cube.above : cube.below;
    const MassProperties mass = massOf(piece.view());
    const Integrals exact = exactIntegrals(piece);
    ASSERT_NEAR(mass.volume / exact.volume, 1.0, 1e-6) << attempt;
    hard::reportWorst("volume off by", std::abs(mass.volume / exact.volume - 1.0));
    hard::reportSum("pieces", 1);
    if (!isOfABody(exact.inertia)) {
      hard::reportSum("specks", 1);
      continue;
    }
    const double extent = extentOf(piece.view());
    const double off = (mass.center.cast<double>() - exact.center).cwiseAbs().maxCoeff();
    ASSERT_LE(off, 1e-6 * extent + 0x1p-25) << attempt;
    if (extent > 0.03) hard::reportWorst("centre off by, of extents above 3 cm,", off / extent);
    ASSERT_LE(relativeError(mass.inertia, exact.inertia), 1e-5) << attempt;
    hard::reportWorst("inertia off by", relativeError(mass.inertia, exact.inertia));
  }
}

TEST_P(B10, ChildrenAddUpToTheParent) {
  CutCube<float> cube(GetParam(), 62);
  for (int attempt = 0; attempt < hard::counted(50000, 2000000); ++attempt) {
    if (cube.step() != SplitOutcome::Split || !isCompact(cube.parent)) continue;
    const MassProperties parent = massOf(cube.parent.view());
    const MassProperties sum = combined(massOf(cube.above.view()), massOf(cube.below.view()));
    const double off = relativeError(sum.inertia, parent.inertia.cast<double>());
    ASSERT_LE(off, 1e-5) << attempt;
    hard::reportWorst("children's sum off by", off);
    hard::reportSum("parents", 1);
  }
}

TEST_P(B10, AllPiecesAddUpToTheCube) {
  for (int round = 0; round < hard::counted(3, 200); ++round) {
    CutCube<float> cube(GetParam(), 63 + static_cast<std::uint64_t>(round));
    while (!cube.isFull()) cube.step();
    MassProperties sum;
    for (std::size_t i = 0; i < cube.count(); ++i) sum = combined(sum, massOf(cube.piece(i).view()));
    EXPECT_LT(relativeError(sum.inertia, Mat3d::Identity() / 6.0), 1e-5);
    hard::reportWorst("512 pieces' sum off by", relativeError(sum.inertia, Mat3d::Identity() / 6.0));
  }
}

INSTANTIATE_TEST_SUITE_P(AllModes, B10, testing::ValuesIn(kCutModes), [](const auto& instance) {
  return std::string(kCutModeNames[static_cast<int>(instance.param)]);
});

}  // namespace
}  // namespace brittle::geometry
