// B11: half-edges are counted in 16 bits. Cylinders of 8000 sides get domes of planes that touch a sphere: each adds a
// face and takes none away, until the indices run out. The refusal is a typed outcome, of either side, the parent and
// the outputs stay as they were bit for bit, and nothing ever wraps around; a cut that makes both parts smaller still
// works, and so does breaking the thing.
#include <gtest/gtest.h>

#include "engine/core/hash.h"
#include "engine/fracture/fracture.h"
#include "tests/engine/geometry/mating.h"
#include "tests/hard_cases/case.h"

namespace brittle::geometry {
namespace {

std::uint64_t hashOf(const Convex& convex) {
  StateHash hash;
  for (const Vertex& vertex : convex.vertices)
    for (int i = 0; i < 3; ++i) hash.add(vertex.point[i]);
  for (const Edge& edge : convex.edges) {
    hash.add(std::uint32_t{edge.face} << 16 | edge.vertex);
    hash.add(std::uint32_t{edge.next} << 16 | edge.opposite);
  }
  return hash.value();
}

class B11 : public testing::Test {
 protected:
  SplitScratch scratch;
  Convex above, below;
  SplitOutcome cut(const Convex& parent, const Plane& plane) {
    return split<float>(parent.view(), plane, {}, scratch, above, below);
  }

  /// Grows a dome until a plane is refused, and returns that plane.
  Plane fill(Convex& body, int dome) {
    Random random(47, static_cast<std::uint64_t>(dome));
    for (int i = 0; i < 8000; ++i) {
      const float x = random.nextFloat(-1.0f, 1.0f);
      const float y = random.nextFloat(0.4f, 1.0f);
      const float z = random.nextFloat(-1.0f, 1.0f);
      const Plane plane{normalizedOr(Vec3(x, y, z), Vec3::UnitY()), 0.99f};
      const SplitOutcome outcome = cut(body, plane);
      if (outcome == SplitOutcome::TooManyIndices) return plane;
      if (outcome == SplitOutcome::Split) body.assign(below.view());
    }
    ADD_FAILURE() << "the indices never ran out";
    return {};
  }

  void expectRefusal(const Convex& body, const Plane& plane) {
    const std::uint64_t before = hashOf(body), outputs = hashOf(above) ^ hashOf(below);
    EXPECT_EQ(cut(body, plane), SplitOutcome::TooManyIndices);
    EXPECT_EQ(cut(body, plane.flipped()), SplitOutcome::TooManyIndices) << "the other side";
    EXPECT_EQ(hashOf(body), before);
    EXPECT_EQ(hashOf(above) ^ hashOf(below), outputs);
  }

  void expectSmallerPartsStillWork(const Convex& body) {
    const Plane plane{Vec3::UnitX(), 0.01f};
    ASSERT_EQ(cut(body, plane), SplitOutcome::Split);
    EXPECT_STREQ(findCutError(body, plane, above, below), nullptr);
    const double volume = volumeOf<double>(body);
    EXPECT_NEAR(volumeOf<double>(above) + volumeOf<double>(below), volume, 1e-6 * volume);
  }

  void expectBreaks(const Convex& body) {
    fracture::Part part;
    part.convex = body.view();
    fracture::FractureMaterial material;
    material.pattern = fracture::Pattern::Block;
    const fracture::Impact impact{Vec3(0.0f, 1.5f, 0.0f), -Vec3::UnitY(), 10.0f, 0.05f, Vec3::Zero()};
    fracture::Fracturer fracturer;
    const fracture::Fracture& made = fracturer.fracture({&part, 1}, {&impact, 1}, material, 1e-3f, 1);
    EXPECT_GT(made.pieces.size(), 1u);
    double volume = 0.0;
    for (const fracture::Piece& piece : made.pieces) {
      volume += piece.mass.volume;
      if (piece.isWhole) continue;
      EXPECT_STREQ(findTopologyError(made.convexes[piece.convex].view()), nullptr);
    }
    for (const fracture::Crumb& crumb : made.crumbs) volume += crumb.volume;
    EXPECT_NEAR(volume / volumeOf<double>(body), 1.0, 1e-6);
    hard::reportSum("cuts refused while breaking", made.refusedCuts);
  }
};

TEST_F(B11, RefusesAndLeavesAllAsItWas) {
  for (int dome = 0; dome < hard::counted(1, 20); ++dome) {
    Convex body = makeCylinder(1.0f, 1.5f, 8000);
    const Plane plane = fill(body, dome);
    ASSERT_STREQ(findTopologyError(body.view()), nullptr);
    EXPECT_GT(body.edges.size(), kMaxHalfEdges - 12);
    EXPECT_LE(body.edges.size(), kMaxHalfEdges);
    hard::reportWorst("most half-edges", static_cast<double>(body.edges.size()));
    expectRefusal(body, plane);
    expectSmallerPartsStillWork(body);
    expectBreaks(body);
  }
}

}  // namespace
}  // namespace brittle::geometry
