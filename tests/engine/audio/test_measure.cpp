#include "tests/engine/audio/measure.h"

#include <gtest/gtest.h>

#include "engine/core/random.h"

namespace brittle::audio {
namespace {

Samples sine(double frequency, double seconds, double decay = 0.0) {
  Samples samples(samplesIn(static_cast<float>(seconds)));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = static_cast<double>(i) / kSampleRate;
    samples[i] = static_cast<float>(std::sin(2.0 * M_PI * frequency * t) *
                                    (decay > 0.0 ? std::pow(10.0, -3.0 * t / decay) : 1.0));
  }
  return samples;
}

TEST(Measure, LevelsOfASine) {
  EXPECT_NEAR(peakOf(sine(1000.0, 0.1)), 1.0, 1e-3);
  EXPECT_NEAR(rmsOf(sine(1000.0, 0.1)), std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(decibels(0.1), -20.0, 1e-9);
}

TEST(Measure, CentroidOfASineAndOfWhiteNoise) {
  EXPECT_NEAR(centroidOf(sine(5000.0, 0.2)), 5000.0, 10.0);
  Random random(1);
  Samples noise(4096);
  for (float& sample : noise) sample = random.nextFloat(-1.0f, 1.0f);
  EXPECT_NEAR(centroidOf(noise), 12000.0, 600.0);
}

TEST(Measure, SharesAndPeaksOfTwoSines) {
  Samples both = sine(700.0, 0.1);
  const Samples high = sine(6000.0, 0.1);
  for (std::size_t i = 0; i < both.size(); ++i) both[i] = 0.1f * both[i] + high[i];
  EXPECT_NEAR(shareBetween(both, 500.0, 900.0), 0.01 / 1.01, 1e-3);
  EXPECT_NEAR(shareBetween(both, 5000.0, 7000.0), 1.0 / 1.01, 1e-3);
  EXPECT_NEAR(decibels(std::sqrt(peakBetween(both, 500.0, 900.0) / peakBetween(both, 0.0, 24000.0))), -20.0, 1.5);
}

TEST(Measure, PitchAndDecay) {
  EXPECT_NEAR(centsOff(sine(440.0 * std::exp2(7.0 / 1200.0), 1.0), 440.0), 7.0, 0.26);
  EXPECT_NEAR(decayTimeOf(sine(800.0, 3.0, 0.7)), 0.7, 0.01);
}

}  // namespace
}  // namespace brittle::audio
