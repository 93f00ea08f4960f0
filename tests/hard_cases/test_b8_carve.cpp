// B8: a hole of 8 to 14 walls is carved about the impact, and what was in it shatters. Hits: the middle, corners, an
// edge, on a face's diagonal, on the seam between two convexes and at its end, beside the body. What stays outside and
// the shards inside add up to the parent within 1e-6, and of 1e5 points of the parent each lies in exactly one piece.
#include <gtest/gtest.h>

#include <string>

#include "tests/engine/fracture/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::fracture {
namespace {

struct Hit {
  std::string name;
  Vec3 point;
};

std::vector<Hit> hitsOf(const Vec3& h) {
  return {{"middle", {0, 0, h.z()}},
          {"corner", h},
          {"other corner", -h},
          {"edge", {h.x(), 0.0f, h.z()}},
          {"face diagonal", {0.5f * h.x(), 0.5f * h.y(), h.z()}},
          {"seam", {0, 0.3f * h.y(), h.z()}},
          {"seam end", {0, h.y(), h.z()}},
          {"just outside", h * 1.001f},
          {"well outside", {h.x() + 0.1f, 0.0f, 0.0f}}};
}

/// A pane or a block, of two halves that meet at x = 0 or of one piece.
struct Target {
  Pattern pattern;
  Vec3 half;
  bool hasSeam;

  Scene scene() const {
    Scene scene;
    const float quarter = 0.5f * half.x();
    if (!hasSeam) scene.addBox(half, Vec3::Zero());
    for (const float side : {-quarter, quarter})
      if (hasSeam) scene.addBox({quarter, half.y(), half.z()}, {side, 0.0f, 0.0f});
    return scene;
  }
};
void PrintTo(const Target& target, std::ostream* out) {
  *out << "pattern " << static_cast<int>(target.pattern) << (target.hasSeam ? " with a seam" : "");
}

double volumeOf(const Scene& scene, const Fracture& made) {
  Scene pieces;
  for (const Piece& piece : made.pieces) {
    geometry::Convex copy;
    copy.assign(viewOf(scene, made, piece));
    pieces.add(std::move(copy));
  }
  double volume = pieces.volume();
  for (const Crumb& crumb : made.crumbs) volume += crumb.volume;
  return volume;
}

class B8 : public testing::TestWithParam<Target> {
 protected:
  Fracturer fracturer;
  FractureMaterial material;
  Scene scene = GetParam().scene();
  void SetUp() override { material.pattern = GetParam().pattern; }

  const Fracture& hit(const Vec3& point, int seed) {
    const Impact impact = straightAt(point, 12.0f);
    return fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, static_cast<std::uint64_t>(seed));
  }
};

TEST_P(B8, PiecesAddUpToTheParent) {
  for (const Hit& at : hitsOf(GetParam().half)) {
    SCOPED_TRACE(at.name);
    for (int seed = 0; seed < hard::counted(10, 1000); ++seed) {
      const Fracture& made = hit(at.point, seed);
      expectSound(scene, made);
      EXPECT_GT(made.pieces.size(), 1u);
      const double off = std::abs(volumeOf(scene, made) / scene.volume() - 1.0);
      EXPECT_LE(off, 1e-6);
      hard::reportWorst("volume off by", off);
      hard::reportSum("carvings", 1);
    }
  }
}

TEST_P(B8, EveryPointIsInOnePiece) {
  material.minVolume = 0.0f;  // crumbs have no shape to be in
  const int points = hard::counted(8000, 100000);
  for (const Hit& at : hitsOf(GetParam().half)) {
    SCOPED_TRACE(at.name);
    ASSERT_NO_FATAL_FAILURE(expectPartition(scene, hit(at.point, 3), GetParam().half, points));
    hard::reportSum("points, each in one piece", points);
  }
}

constexpr float kQuarter = 0.25f;
INSTANTIATE_TEST_SUITE_P(Targets, B8,
                         testing::Values(Target{Pattern::Pane, Vec3(0.5f, 0.5f, 0.01f), true},
                                         Target{Pattern::Pane, Vec3(0.5f, 0.5f, 0.01f), false},
                                         Target{Pattern::Laminated, Vec3(0.5f, 0.5f, 0.01f), true},
                                         Target{Pattern::Tempered, Vec3(0.5f, 0.5f, 0.01f), true},
                                         Target{Pattern::Block, Vec3(kQuarter, kQuarter, kQuarter), true},
                                         Target{Pattern::Block, Vec3(kQuarter, kQuarter, kQuarter), false}));

}  // namespace
}  // namespace brittle::fracture
