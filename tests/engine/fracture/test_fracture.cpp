#include "engine/fracture/fracture.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/core/random.h"
#include "engine/geometry/make.h"
#include "tests/allocations.h"
#include "tests/engine/fracture/scene.h"

namespace brittle::fracture {
namespace {

std::size_t fragmentsOf(const Fracture& made) {
  std::size_t count = 0;
  for (const Piece& piece : made.pieces) count += piece.isFragment ? 1 : 0;
  return count;
}

TEST(Fracture, SameSeedSameBitsOtherSeedOtherBits) {
  Fracturer one, other;
  for (const Pattern pattern : {Pattern::Pane, Pattern::Block, Pattern::Tempered, Pattern::Laminated}) {
    FractureMaterial material;
    material.pattern = pattern;
    const Scene scene = pattern == Pattern::Block ? block() : panesWithSeam();
    const Impact impacts[2] = {straightAt({0.05f, 0.1f, 0.01f}), straightAt({0.2f, -0.2f, 0.01f}, 30.0f)};
    std::set<std::uint64_t> hashes;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const std::uint64_t hash = hashOf(one.fracture(scene.parts, impacts, material, kSlop, seed));
      EXPECT_EQ(hash, hashOf(other.fracture(scene.parts, impacts, material, kSlop, seed)));
      EXPECT_EQ(hash, hashOf(one.fracture(scene.parts, impacts, material, kSlop, seed)))
          << "no memory of the last call";
      hashes.insert(hash);
    }
    EXPECT_EQ(hashes.size(), 8u);
  }
}

TEST(Fracture, AFreePaneKeepsTheBodyWithItsLargestRest) {
  const Scene scene = pane();
  const Impact impact = straightAt({0.1f, 0.1f, 0.01f});
  Fracturer fracturer;
  const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, {}, kSlop, 2);
  std::size_t rests = 0;
  for (const Piece& piece : made.pieces) {
    if (piece.isFragment) continue;
    ++rests;
    EXPECT_TRUE(made.groups[piece.group].keepsBody) << "what surrounds the hole hangs together";
  }
  EXPECT_GE(rests, 4u);
  EXPECT_EQ(made.groups.size(), 1 + fragmentsOf(made)) << "every fragment for itself";
}

TEST(Fracture, AHoleAcrossAStripLeavesTwoBodies) {
  Scene scene;
  scene.addBox({0.5f, 0.1f, 0.01f}, Vec3::Zero(), true);
  // Held at its left end only: the right end falls.
  scene.anchors.push_back(
      {{{-0.5f, -0.1f, -0.01f}, {-0.5f, 0.1f, -0.01f}, {-0.5f, 0.1f, 0.01f}, {-0.5f, -0.1f, 0.01f}}, 4});
  scene.parts[0].anchors = {&scene.anchors[0], 1};
  FractureMaterial material;
  material.carveRadius = 0.25f;
  const Impact impact = straightAt({0.0f, 0.0f, 0.01f});
  Fracturer fracturer;
  const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, 2);
  expectSound(scene, made);
  std::set<std::uint32_t> left, right;
  for (const Piece& piece : made.pieces) {
    if (piece.isFragment) continue;
    (piece.mass.center.x() < 0.0f ? left : right).insert(piece.group);
  }
  ASSERT_EQ(left.size(), 1u);
  ASSERT_EQ(right.size(), 1u);
  EXPECT_TRUE(made.groups[*left.begin()].anchored);
  EXPECT_TRUE(made.groups[*left.begin()].keepsBody);
  EXPECT_FALSE(made.groups[*right.begin()].anchored);
}

TEST(Fracture, WithoutAnchorPlacesEveryRestStays) {
  Scene scene;
  scene.addBox({0.5f, 0.1f, 0.01f}, Vec3::Zero(), true);
  FractureMaterial material;
  material.carveRadius = 0.25f;
  const Impact impact = straightAt({0.0f, 0.0f, 0.01f});
  Fracturer fracturer;
  const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, 2);
  for (const Piece& piece : made.pieces) EXPECT_EQ(made.groups[piece.group].keepsBody, !piece.isFragment);
}

TEST(Fracture, RestsOfDifferentPartsHangTogetherAcrossTheSeam) {
  const Scene scene = panesWithSeam();
  const Impact impact = straightAt({0.0f, 0.0f, 0.01f}, 5.0f);
  Fracturer fracturer;
  const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, {}, kSlop, 2);
  std::set<std::uint32_t> groups;
  for (const Piece& piece : made.pieces) {
    if (!piece.isFragment) groups.insert(piece.group);
  }
  EXPECT_EQ(groups.size(), 1u);
}

TEST(Fracture, TemperedGlassTurnsToDice) {
  Scene scene;
  scene.addBox({0.025f, 0.025f, 0.002f}, Vec3::Zero(), true);
  FractureMaterial material;
  material.pattern = Pattern::Tempered;
  material.dieSize = 0.0075f;
  material.minVolume = 0.0f;
  const Impact impact = straightAt({0.02f, 0.0f, 0.002f});
  Fracturer fracturer;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, seed);
    // The standard for safety glass (EN 12150) asks for 40 in 50 x 50 mm.
    EXPECT_GE(made.pieces.size(), 40u);
    EXPECT_EQ(fragmentsOf(made), made.pieces.size()) << "the whole body";
    for (const Piece& piece : made.pieces) EXPECT_FALSE(piece.anchored);
  }
}

TEST(Fracture, DiceGrowInsteadOfNumberingThousands) {
  const Scene scene = pane();
  FractureMaterial material;
  material.pattern = Pattern::Tempered;
  const Impact impact = straightAt(Vec3::Zero());
  Fracturer fracturer;
  const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, 1);
  expectSound(scene, made);
  EXPECT_GT(made.pieces.size(), 350u);
  EXPECT_LE(made.pieces.size(), 400u);
}

TEST(Fracture, LaminatedGlassCracksAndHolds) {
  Scene scene;
  scene.addBox({0.5f, 0.5f, 0.01f}, Vec3::Zero(), true);
  FractureMaterial material;
  material.pattern = Pattern::Laminated;
  Fracturer fracturer;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Impact impact = straightAt({0.1f, 0.1f, 0.01f});
    const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, seed);
    expectSound(scene, made);
    std::size_t held = 0;
    float left = 0.0f;
    for (const Piece& piece : made.pieces) {
      if (made.groups[piece.group].keepsBody)
        held += piece.isFragment ? 1 : 0;
      else
        left += piece.mass.volume;
    }
    EXPECT_GT(held, 10u);
    // What leaves is a hole of little more than the striker's 5 cm: well below the 30 cm that crack.
    EXPECT_LT(left, 0.02f * 0.04f);
  }
}

TEST(Fracture, CrumbsAccountForWhatIsTooSmall) {
  const Scene scene = pane();
  FractureMaterial material;
  material.minVolume = 2e-4f;
  const Impact impact = straightAt({0.1f, 0.1f, 0.01f});
  Fracturer fracturer;
  const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, 2);
  expectSound(scene, made);
  EXPECT_GT(made.crumbs.size(), 5u);
  for (const Piece& piece : made.pieces) EXPECT_GE(piece.mass.volume, material.minVolume);
}

TEST(Fracture, DensityScalesTheCount) {
  const Scene scene = pane();
  Fracturer fracturer;
  FractureMaterial material;
  material.minVolume = 0.0f;
  std::size_t counts[3];
  const float densities[3] = {0.5f, 1.0f, 2.0f};
  for (int i = 0; i < 3; ++i) {
    material.density = densities[i];
    std::size_t sum = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Impact impact = straightAt({0.0f, 0.0f, 0.01f});
      sum += fragmentsOf(fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, seed));
    }
    counts[i] = sum;
  }
  EXPECT_GT(static_cast<double>(counts[1]), 1.3 * static_cast<double>(counts[0]));
  EXPECT_GT(static_cast<double>(counts[2]), 1.3 * static_cast<double>(counts[1]));
}

TEST(Fracture, AlwaysOpensAWay) {
  // Impacts of nothing: no speed, no size, no direction, far away.
  Fracturer fracturer;
  for (const Pattern pattern : {Pattern::Pane, Pattern::Block, Pattern::Tempered, Pattern::Laminated}) {
    FractureMaterial material;
    material.pattern = pattern;
    material.carveRadius = 0.0f;
    const Scene scene = panesWithSeam();
    for (const Vec3& point : {Vec3(0, 0, 0), Vec3(0.5f, 0.5f, 0.01f), Vec3(100.0f, 3.0f, 2.0f), Vec3(0, 0, -1.0f)}) {
      const Impact impact{point, Vec3::Zero(), 0.0f, 0.0f};
      const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, 1);
      EXPECT_GT(fragmentsOf(made) + made.crumbs.size(), 0u);
    }
  }
}

TEST(Fracture, BreaksWhatIsNearestWhenNothingCanBeCarved) {
  // Two rods, so long that a slice as thin as the hole cannot be cut out of them.
  Scene scene;
  scene.addBox({500.0f, 0.0005f, 0.0005f}, Vec3::Zero());
  scene.addBox({500.0f, 0.0005f, 0.0005f}, {0.0f, 0.0f, 0.1f});
  FractureMaterial material;
  material.carveRadius = 0.0f;
  const Impact impact{{3.0f, 0.0f, 0.1f}, -Vec3::UnitZ(), 10.0f, 0.0f, Vec3::Zero()};
  Fracturer fracturer;
  const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, 1);
  EXPECT_GT(made.refusedCuts, 0u);
  std::size_t count = 0;
  for (const Piece& piece : made.pieces) {
    EXPECT_EQ(piece.isFragment, piece.source == 101) << "the part that was hit, and it alone";
    count += piece.isFragment ? 1 : 0;
  }
  EXPECT_GT(count, 0u);
}

TEST(Fracture, BreaksItsOwnPiecesAgainAndAgain) {
  Scene scene = pane();
  Fracturer fracturer;
  FractureMaterial material;
  material.carveRadius = 0.1f;
  Random random(11);
  for (int round = 0; round < 20; ++round) {
    Impact impact = straightAt(Vec3::Zero(), 10.0f, 0.03f);
    impact.point.x() = random.nextFloat(-0.5f, 0.5f);
    impact.point.y() = random.nextFloat(-0.5f, 0.5f);
    const Fracture& made =
        fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, static_cast<std::uint64_t>(round));
    expectSound(scene, made);
    // Go on with the rest that keeps the body. Its faces carry the ids of earlier cuts.
    Scene next;
    for (const Piece& piece : made.pieces) {
      if (!made.groups[piece.group].keepsBody) continue;
      geometry::Convex copy;
      copy.assign(viewOf(scene, made, piece));
      next.add(std::move(copy));
    }
    ASSERT_FALSE(next.parts.empty());
    std::vector<std::uint32_t> groups;
    connectParts(next.parts, kSlop, groups);
    for (const std::uint32_t group : groups) EXPECT_EQ(group, 0u) << "one body hangs together, cut ids or not";
    scene = std::move(next);
  }
}

TEST(Fracture, CutsOfEarlierBreakingsMeanNothing) {
  FractureMaterial material;
  material.pattern = Pattern::Block;
  Fracturer fracturer;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = block();
    const Impact first = straightAt({0.2f, 0.1f, 0.5f});
    const Fracture& made = fracturer.fracture(scene.parts, {&first, 1}, material, kSlop, seed);
    Scene marked, blank;
    for (const Piece& piece : made.pieces) {
      if (!made.groups[piece.group].keepsBody) continue;
      geometry::Convex copy;
      copy.assign(viewOf(scene, made, piece));
      marked.add(copy);
      for (geometry::Face& face : copy.faces) face.cut = 0;
      blank.add(std::move(copy));
    }
    const Impact second = straightAt({-0.1f, 0.0f, 0.5f});
    const std::uint64_t hash = hashOf(fracturer.fracture(marked.parts, {&second, 1}, material, kSlop, seed));
    EXPECT_EQ(hash, hashOf(fracturer.fracture(blank.parts, {&second, 1}, material, kSlop, seed))) << "seed " << seed;
  }
}

TEST(Fracture, AWarmBreakingAllocatesNothing) {
  const Scene panes = panesWithSeam(), cube = block();
  Fracturer fracturer;
  const auto breakAll = [&](std::uint64_t seed) {
    for (const Pattern pattern : {Pattern::Pane, Pattern::Block, Pattern::Tempered, Pattern::Laminated}) {
      FractureMaterial material;
      material.pattern = pattern;
      const Scene& scene = pattern == Pattern::Block ? cube : panes;
      const Impact impacts[2] = {straightAt({0.05f, 0.1f, 0.01f}), straightAt({0.2f, -0.2f, 0.01f}, 30.0f)};
      fracturer.fracture(scene.parts, impacts, material, kSlop, seed);
    }
  };
  for (std::uint64_t seed = 0; seed < 40; ++seed) breakAll(seed);
  const std::size_t before = allocationCount();
  for (std::uint64_t seed = 0; seed < 40; ++seed) breakAll(seed);
  EXPECT_EQ(allocationCount(), before);
}

}  // namespace
}  // namespace brittle::fracture
