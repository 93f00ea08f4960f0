// B13: from 1 mm to 100 m. All limits of a cut are relative, so powers of two change nothing but exponents: the same
// outcomes, the same half-edges, the same corners but for the factor, and no topology failure at any size. Breaking has
// two lengths of its own, a margin of 2 mm around the striker and the least volume of a piece; with both out of play
// (no striker, no least) it is the same at every size as well.
#include <gtest/gtest.h>

#include "tests/engine/fracture/scene.h"
#include "tests/engine/geometry/mating.h"
#include "tests/hard_cases/case.h"

namespace brittle::geometry {
namespace {

bool isScaled(const Convex& found, const Convex& expected, float scale) {
  if (found.vertices.size() != expected.vertices.size() || found.edges.size() != expected.edges.size()) return false;
  for (std::size_t i = 0; i < found.vertices.size(); ++i)
    if (!isSame(found.vertices[i].point, scale * expected.vertices[i].point)) return false;
  return std::memcmp(found.edges.data(), expected.edges.data(), found.edges.size() * sizeof(Edge)) == 0;
}

class B13 : public testing::TestWithParam<CutMode> {};

TEST_P(B13, CutsAreTheSameAtEverySize) {
  CutCube<float> cube(GetParam(), 44);
  SplitScratch scratch;
  Convex above, below;
  for (int attempt = 0; attempt < hard::counted(30000, 1000000); ++attempt) {
    const SplitOutcome outcome = cube.step();
    const float scale = std::ldexp(1.0f, attempt % 18 - 10);  // from 1 mm to 128 m
    Convex scaled = cube.parent;
    for (Vertex& vertex : scaled.vertices) vertex.point *= scale;
    const Plane plane = {cube.plane.normal, cube.plane.offset * scale};
    ASSERT_EQ(split<float>(scaled.view(), plane, {}, scratch, above, below), outcome) << attempt;
    hard::reportSum("cuts compared", 1);
    if (outcome != SplitOutcome::Split) continue;
    ASSERT_STREQ(findTopologyError(above.view()), nullptr);
    ASSERT_STREQ(findTopologyError(below.view()), nullptr);
    ASSERT_TRUE(isScaled(above, cube.above, scale)) << attempt << " at " << scale;
    ASSERT_TRUE(isScaled(below, cube.below, scale)) << attempt << " at " << scale;
  }
}

INSTANTIATE_TEST_SUITE_P(AllModes, B13, testing::ValuesIn(kCutModes), [](const auto& instance) {
  return std::string(kCutModeNames[static_cast<int>(instance.param)]);
});

using namespace fracture;

/// A pane or a block of so many metres, struck off its middle by something without a size.
const Fracture& strike(Fracturer& fracturer, Scene& scene, Pattern pattern, float scale, int seed) {
  FractureMaterial material;
  material.pattern = pattern;
  material.minVolume = 0.0f;
  material.carveRadius = 0.25f * scale;
  material.dieSize = 0.125f * scale;
  const float depth = pattern == Pattern::Block ? 0.5f : 0.0625f;
  scene.addBox(Vec3(0.5f, 0.5f, depth) * scale, Vec3::Zero());
  const Impact impact = straightAt(Vec3(0.125f, 0.0625f, depth) * scale, 10.0f, 0.0f);
  return fracturer.fracture(scene.parts, {&impact, 1}, material, 0x1p-10f * scale, static_cast<std::uint64_t>(seed));
}

TEST(B13Breaking, PiecesAreTheSameAtEverySize) {
  Fracturer fracturer, other;
  for (const Pattern pattern : {Pattern::Pane, Pattern::Block, Pattern::Tempered}) {
    for (int seed = 0; seed < hard::counted(4, 200); ++seed) {
      Scene scene;
      const Fracture& expected = strike(fracturer, scene, pattern, 1.0f, seed);
      for (int power = -5; power <= 7; ++power) {
        const float scale = std::ldexp(1.0f, power);
        Scene scaled;
        const Fracture& made = strike(other, scaled, pattern, scale, seed);
        ASSERT_EQ(made.pieces.size(), expected.pieces.size()) << "at " << scale << " m";
        for (std::size_t i = 0; i < made.pieces.size(); ++i) {
          Convex one, two;
          one.assign(viewOf(scaled, made, made.pieces[i]));
          two.assign(viewOf(scene, expected, expected.pieces[i]));
          ASSERT_STREQ(findTopologyError(one.view()), nullptr);
          ASSERT_TRUE(isScaled(one, two, scale)) << "at " << scale << " m, piece " << i;
        }
        hard::reportSum("breakings compared", 1);
      }
    }
  }
}

}  // namespace
}  // namespace brittle::geometry
