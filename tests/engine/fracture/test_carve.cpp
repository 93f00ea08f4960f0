#include "engine/fracture/carve.h"

#include <gtest/gtest.h>

#include "engine/core/random.h"
#include "engine/geometry/make.h"
#include "engine/math/transform.h"
#include "tests/engine/fracture/scene.h"

namespace brittle::fracture {
namespace {

// The hard case B8 hits corners, edges, diagonals and seams.
TEST(Carve, KeepsTheVolumeAndEveryPointInOnePiece) {
  Fracturer fracturer;
  FractureMaterial material;
  material.minVolume = 0.0f;
  for (const Pattern pattern : {Pattern::Pane, Pattern::Block, Pattern::Tempered, Pattern::Laminated}) {
    SCOPED_TRACE(static_cast<int>(pattern));
    material.pattern = pattern;
    const bool isThick = pattern == Pattern::Block;
    const Scene scene = isThick ? block() : panesWithSeam();
    const Vec3 half = isThick ? Vec3::Constant(0.25f) : Vec3(0.5f, 0.5f, 0.01f);
    const Impact centre = straightAt({0.1f, 0.05f, half.z()}, 12.0f);
    const Fracture& made = fracturer.fracture(scene.parts, {&centre, 1}, material, kSlop, 4);
    expectSound(scene, made);
    EXPECT_GT(made.pieces.size(), 1u);
    expectPartition(scene, made, half, 5000);
  }
}

TEST(Carve, TheHoleLetsTheStrikerThroughWhateverTheSlant) {
  Fracturer fracturer;
  FractureMaterial material;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const Scene scene = seed % 2 == 0 ? pane() : panesWithSeam();
    material.pattern = seed % 3 == 0 ? Pattern::Laminated : Pattern::Pane;
    material.carveRadius = random.nextFloat(0.0f, 0.3f);
    Impact impact;
    impact.point.x() = random.nextFloat(-0.5f, 0.5f);
    impact.point.y() = random.nextFloat(-0.5f, 0.5f);
    impact.point.z() = 0.01f;
    impact.speed = random.nextFloat(0.0f, 60.0f);
    impact.strikerRadius = random.nextFloat(0.005f, 0.15f);
    const float slant = random.nextFloat(0.0f, 1.0472f);
    const float turn = random.nextFloat(0.0f, 6.2832f);
    impact.direction = Vec3(sine(slant) * cosine(turn), sine(slant) * sine(turn), -cosine(slant));
    // A ball touches beside the line on which its centre goes.
    impact.toCenter = Vec3::UnitZ() * (seed % 5 < 3 ? impact.strikerRadius : 0.0f);
    const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, seed);
    for (const Piece& piece : made.pieces) {
      const bool stays = !piece.isFragment || made.groups[piece.group].keepsBody;
      if (!stays) continue;
      EXPECT_GE(distanceFromLine(viewOf(scene, made, piece), impact.point + impact.toCenter, impact.direction),
                impact.strikerRadius)
          << "seed " << seed;
    }
  }
}

TEST(Carve, OnlyTheSideThatIsHitBreaks) {
  Scene scene;  // a glass box of six panes
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-0.5f, 0.5f}) {
      Vec3 half = Vec3::Constant(0.49f), center = Vec3::Zero();
      half[axis] = 0.01f;
      center[axis] = side;
      scene.addBox(half, center);
    }
  }
  const Impact impact = straightAt({0.0f, 0.0f, 0.51f});
  Fracturer fracturer;
  const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, {}, kSlop, 1);
  expectSound(scene, made);
  for (const Piece& piece : made.pieces) EXPECT_EQ(piece.isWhole, piece.source != 105);
}

TEST(Carve, AVolumeThatMissesLeavesThePartWhole) {
  Scene scene = pane();
  scene.addBox({0.5f, 0.5f, 0.01f}, {1.0f, 0.0f, 0.0f});
  FractureMaterial material;
  material.carveRadius = 0.1f;
  const Impact impact = straightAt({-0.2f, 0.0f, 0.01f});
  Fracturer fracturer;
  const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, 1);
  int whole = 0;
  for (const Piece& piece : made.pieces) {
    if (piece.source != 101) continue;
    EXPECT_TRUE(piece.isWhole);
    ++whole;
  }
  EXPECT_EQ(whole, 1);
}

TEST(Carve, SeveralImpactsCarveOneAfterAnother) {
  const Scene scene = panesWithSeam();
  Fracturer fracturer;
  FractureMaterial material;
  material.carveRadius = 0.15f;
  const Impact impacts[3] = {straightAt({-0.2f, 0.1f, 0.01f}), straightAt({0.25f, 0.2f, 0.01f}),
                             straightAt({-0.1f, 0.1f, 0.01f})};
  const std::size_t first = fracturer.fracture(scene.parts, {impacts, 1}, material, kSlop, 5).pieces.size();
  const std::uint64_t hashOfFragments = [&] {
    Fracture fragments;
    for (const Piece& piece : fracturer.fracture(scene.parts, {impacts, 1}, material, kSlop, 5).pieces) {
      if (piece.isFragment) fragments.crumbs.push_back({piece.mass.center, piece.mass.volume});
    }
    return hashOf(fragments);
  }();
  const Fracture& all = fracturer.fracture(scene.parts, impacts, material, kSlop, 5);
  expectSound(scene, all);
  EXPECT_GT(all.pieces.size(), first + 10);
  // The fragments of the first impact are still there, uncut by the third that overlaps it.
  Fracture kept;
  const Fracture& one = all;
  Fracturer other;
  for (const Piece& piece : other.fracture(scene.parts, {impacts, 1}, material, kSlop, 5).pieces) {
    if (!piece.isFragment) continue;
    for (const Piece& candidate : one.pieces) {
      if (candidate.mass.center == piece.mass.center && candidate.mass.volume == piece.mass.volume) {
        kept.crumbs.push_back({piece.mass.center, piece.mass.volume});
      }
    }
  }
  EXPECT_EQ(hashOf(kept), hashOfFragments);
}

TEST(Carve, SliversAreCutOrRefusedButNeverLost) {
  Fracturer fracturer;
  FractureMaterial material;
  for (const float thickness : {1e-4f, 1e-5f, 1e-6f}) {
    Scene scene;
    scene.addBox({0.5f, 0.5f, 0.5f * thickness}, Vec3::Zero());
    for (const Pattern pattern : {Pattern::Pane, Pattern::Block, Pattern::Tempered}) {
      material.pattern = pattern;
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random(seed);
        Impact impact;
        for (int k = 0; k < 3; ++k) impact.point[k] = random.nextFloat(-0.5f, 0.5f);
        for (int k = 0; k < 3; ++k) impact.direction[k] = random.nextFloat(-1.0f, 1.0f);
        impact.direction.normalize();
        impact.speed = 10.0f;
        const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop, seed);
        double volume = 0.0;
        for (const Piece& piece : made.pieces) volume += piece.mass.volume;
        for (const Crumb& crumb : made.crumbs) volume += crumb.volume;
        EXPECT_NEAR(volume / scene.volume(), 1.0, 2e-6);
      }
    }
  }
}

/// A box, cylinder or hull of a quarter to one metre, turned anyhow, that touches or overlaps its neighbours now and
/// then.
geometry::Convex randomConvex(Random& random) {
  const auto vector = [&](float low, float high) {
    Vec3 v;
    for (int k = 0; k < 3; ++k) v[k] = random.nextFloat(low, high);
    return v;
  };
  const std::uint32_t kind = random.nextBelow(3);
  geometry::Convex convex;
  if (kind == 0) convex = geometry::makeBox<float>(vector(0.02f, 0.4f));
  if (kind == 1) {
    const float radius = random.nextFloat(0.05f, 0.3f);
    const float half = random.nextFloat(0.01f, 0.4f);
    convex = geometry::makeCylinder(radius, half, static_cast<int>(3 + random.nextBelow(30)));
  }
  if (kind == 2) {
    std::vector<Vec3> points;
    for (int i = 0; i < 14; ++i) points.push_back(vector(-0.3f, 0.3f));
    convex = geometry::makeHull(points).value();
  }
  const Vec3 angles = random.nextBelow(2) == 0 ? vector(-3.0f, 3.0f) : Vec3(Vec3::Zero());
  return geometry::transformed(convex, rotationXyz(angles), vector(-0.5f, 0.5f));
}

TEST(Carve, RandomCompoundsStaySound) {
  Fracturer fracturer;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed, 5);
    Scene scene;
    const std::uint32_t count = 1 + random.nextBelow(5);
    for (std::uint32_t i = 0; i < count; ++i) scene.add(randomConvex(random), random.nextBelow(4) == 0);
    FractureMaterial material;
    material.pattern = static_cast<Pattern>(random.nextBelow(4));
    material.carveRadius = random.nextFloat(0.01f, 0.5f);
    material.dieSize = random.nextFloat(0.03f, 0.2f);
    Impact impacts[3];
    for (Impact& impact : impacts) {
      for (int k = 0; k < 3; ++k) impact.point[k] = random.nextFloat(-0.8f, 0.8f);
      for (int k = 0; k < 3; ++k) impact.direction[k] = random.nextFloat(-1.0f, 1.0f);
      impact.direction = normalizedOr(impact.direction, Vec3::UnitX());
      impact.speed = random.nextFloat(0.0f, 60.0f);
      impact.strikerRadius = random.nextFloat(0.0f, 0.1f);
    }
    const Fracture& made = fracturer.fracture(scene.parts, {impacts, 1 + random.nextBelow(3)}, material, kSlop, seed);
    expectSound(scene, made);
    bool breaks = !made.crumbs.empty();
    for (const Piece& piece : made.pieces) breaks = breaks || piece.isFragment;
    EXPECT_TRUE(breaks);
  }
}

TEST(Carve, ScalesFromAMillimetreToAHundredMetres) {
  Fracturer fracturer;
  FractureMaterial material;
  material.minVolume = 0.0f;
  std::size_t pieces = 0;
  for (const float scale : {0x1p-10f, 0x1p-5f, 1.0f, 0x1p6f}) {
    Scene scene;
    scene.addBox(Vec3(0.5f, 0.5f, 0.02f) * scale, Vec3::Zero());
    material.carveRadius = 0.25f * scale;
    const Impact impact = straightAt(Vec3(0.1f, 0.1f, 0.02f) * scale, 10.0f, 0.0f);
    const Fracture& made = fracturer.fracture(scene.parts, {&impact, 1}, material, kSlop * scale, 9);
    for (const Piece& piece : made.pieces) {
      EXPECT_EQ(geometry::findTopologyError<float>(viewOf(scene, made, piece)), nullptr);
    }
    // The striker's margin counts below a few centimetres; from there on the pattern is the same.
    if (scale < 0.02f) continue;
    EXPECT_TRUE(pieces == 0 || pieces == made.pieces.size());
    pieces = made.pieces.size();
  }
}

}  // namespace
}  // namespace brittle::fracture
