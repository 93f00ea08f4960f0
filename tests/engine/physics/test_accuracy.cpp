#include "engine/physics/accuracy.h"

#include <gmock/gmock.h>

#include <limits>
#include <set>

#include "engine/core/byte_stream.h"
#include "engine/physics/state.h"
#include "engine/physics/world.h"

namespace brittle::physics {
namespace {

using Change = void (*)(Accuracy&);

TEST(Accuracy, TheDefaultAndTheEndsOfTheRangesAreUsable) {
  const Change usable[] = {
      [](Accuracy&) {},
      [](Accuracy& a) { a.fractureRounds = 0; },
      [](Accuracy& a) { a.fractureRounds = a.fastRounds = 64; },
      [](Accuracy& a) { a.fastRounds = 0; },
      [](Accuracy& a) { a.positionIterations = a.maxDebris = a.maxBodies = 0; },
      [](Accuracy& a) { a.speculativeMargin = a.minVolumeScale = a.directSolveMassRatio = a.blend = 0.0f; },
  };
  for (const Change& change : usable) {
    Accuracy accuracy;
    change(accuracy);
    EXPECT_TRUE(isWithinRange(accuracy)) << &change - usable;
  }
}

TEST(Accuracy, WhatIsBeyondARangeIsNot) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Change beyond[] = {
      [](Accuracy& a) { a.fractureMode = static_cast<FractureMode>(3); },
      [](Accuracy& a) { a.fractureRounds = 65; },
      [](Accuracy& a) { a.fastRounds = -1; },
      [](Accuracy& a) { a.fastRounds = 65; },
      [](Accuracy& a) { a.blend = 1.1f; },
      [](Accuracy& a) { a.iterations = 0; },
      [](Accuracy& a) { a.positionIterations = -1; },
      [](Accuracy& a) { a.substeps = 0; },
      [](Accuracy& a) { a.manifold.kind = static_cast<ManifoldKind>(2); },
      [](Accuracy& a) { a.manifold.recycleDistance = -0.1f; },
      [](Accuracy& a) { a.speculativeMargin = nan; },
      [](Accuracy& a) { a.patternDensity = 0.0f; },
      [](Accuracy& a) { a.minVolumeScale = nan; },
      [](Accuracy& a) { a.maxDebris = -1; },
      [](Accuracy& a) { a.maxBodies = 1'000'001; },
      [](Accuracy& a) { a.directSolveMassRatio = -1.0f; },
  };
  for (const Change& change : beyond) {
    Accuracy accuracy;
    change(accuracy);
    EXPECT_FALSE(isWithinRange(accuracy)) << &change - beyond;
  }
}

TEST(Accuracy, PresetsAreUsableAllDifferentAndBalancedIsTheDefault) {
  std::vector<std::string> written;
  for (const std::string_view name : presetNames()) {
    const std::optional<Accuracy> found = preset(name);
    ASSERT_TRUE(found) << name;
    EXPECT_TRUE(isWithinRange(*found)) << name;
    World world({.accuracy = *found});
    ByteWriter out;
    world.save(out);
    written.emplace_back(out.bytes().begin(), out.bytes().end());
  }
  World plain;
  ByteWriter out;
  plain.save(out);
  EXPECT_EQ(written[1], std::string(out.bytes().begin(), out.bytes().end()));
  EXPECT_THAT(presetNames(), testing::ElementsAre("phone", "balanced", "accurate", "reference"));
  EXPECT_EQ(std::set<std::string>(written.begin(), written.end()).size(), written.size());
  EXPECT_FALSE(preset("fast"));
}

TEST(Accuracy, BudgetsGrowFromPresetToPreset) {
  std::int32_t bodies = 0, debris = 0;
  for (const std::string_view name : presetNames()) {
    EXPECT_GT(preset(name)->maxBodies, bodies) << name;
    EXPECT_GT(preset(name)->maxDebris, debris) << name;
    bodies = preset(name)->maxBodies;
    debris = preset(name)->maxDebris;
  }
}

TEST(Accuracy, ASnapshotWithSettingsBeyondTheirRangeIsRefused) {
  World world, other;
  for (const std::int32_t iterations : {10, 0}) {
    world.state().accuracy.iterations = iterations;
    ByteWriter out;
    world.save(out);
    ByteReader in(out.bytes());
    EXPECT_EQ(other.restore(in), iterations == 10) << iterations;
  }
}

}  // namespace
}  // namespace brittle::physics
