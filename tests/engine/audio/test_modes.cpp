#include "engine/audio/modes.h"

#include <gtest/gtest.h>

#include "tests/engine/audio/measure.h"

namespace brittle::audio {
namespace {

TEST(Modes, AModeHasItsPitchItsDecayAndItsHeight) {
  Samples samples(samplesIn(2.0f), 0.0f);
  addMode(samples, 0, {1234.0f, 0.8f, 0.5f});
  EXPECT_NEAR(centsOff(part(samples, 0.0, 0.5), 1234.0), 0.0, 0.5);
  EXPECT_NEAR(decayTimeOf(samples), 0.8, 0.01);
  EXPECT_NEAR(peakOf(samples), 0.5, 0.01);
  EXPECT_EQ(samples[0], 0.0f) << "a sine begins at zero: no click";
}

TEST(Modes, EndsEightyDecibelsDown) {
  Samples samples(samplesIn(1.0f), 0.0f);
  addMode(samples, 100, {1000.0f, 0.3f, 1.0f});
  EXPECT_EQ(peakOf(part(samples, 0.0, 0.002)), 0.0);
  EXPECT_LT(peakOf(part(samples, 0.39, 0.01)), 2e-4);
  EXPECT_GT(peakOf(part(samples, 0.39, 0.01)), 5e-5);
  EXPECT_EQ(peakOf(part(samples, 0.41, 0.5)), 0.0);
}

TEST(Modes, WhatCannotBeHeardOrSampledIsLeftOut) {
  Samples samples(1000, 0.0f);
  addMode(samples, 0, {23000.0f, 0.5f, 1.0f});
  addMode(samples, 0, {0.0f, 0.5f, 1.0f});
  addMode(samples, 0, {-100.0f, 0.5f, 1.0f});
  addMode(samples, 0, {100.0f, 0.0f, 1.0f});
  addMode(samples, 5000, {100.0f, 0.5f, 1.0f});
  EXPECT_EQ(peakOf(samples), 0.0);
}

TEST(Modes, APlateOfTwiceTheSideRingsTwoOctavesLower) {
  Ring exact;
  exact.spread = 0.0f;
  Random random(1);
  const Modes small = plateModes(0.05f, 0.004f, exact, random), large = plateModes(0.10f, 0.004f, exact, random);
  for (std::size_t i = 0; i < small.size(); ++i) EXPECT_NEAR(small[i].frequency / large[i].frequency, 4.0f, 1e-4f);
  // 13.47 / (2 pi side^2) * speed thickness / sqrt(12)
  EXPECT_NEAR(large[0].frequency, 1361.0f, 1.0f);
}

TEST(Modes, ASoftStrikeExcitesTheLowModes) {
  const Modes modes = {{500.0f, 0.5f, 1.0f}, {8000.0f, 0.5f, 1.0f}};
  Samples hard(24000, 0.0f), soft(24000, 0.0f);
  addStrike(hard, modes, {0, 1.0f, 2e-5f});
  addStrike(soft, modes, {0, 1.0f, 1e-3f});
  EXPECT_GT(energyAt(hard, 8000.0), 0.8 * energyAt(hard, 500.0));
  EXPECT_LT(energyAt(soft, 8000.0), 0.01 * energyAt(soft, 500.0));
}

TEST(Modes, AStrikeIsAsStrongAsItIs) {
  Samples samples(24000, 0.0f);
  addStrike(samples, {{500.0f, 1.0f, 0.8f}}, {0, 0.5f, 1e-6f});
  EXPECT_NEAR(peakOf(samples), 0.4, 0.01);
}

TEST(Modes, BouncesGetWeakerAndFollowCloser) {
  Samples samples(samplesIn(1.0f), 0.0f);
  addBounces(samples, {{3000.0f, 0.01f, 1.0f}}, {0, 1.0f, 2e-5f}, 0.2f, 0.5f, 3);
  const double first = peakOf(part(samples, 0.0, 0.05));
  EXPECT_NEAR(peakOf(part(samples, 0.19, 0.05)), 0.5 * first, 0.02);
  EXPECT_NEAR(peakOf(part(samples, 0.29, 0.05)), 0.25 * first, 0.02);
  EXPECT_EQ(peakOf(part(samples, 0.35, 0.5)), 0.0);
}

}  // namespace
}  // namespace brittle::audio
