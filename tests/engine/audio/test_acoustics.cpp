#include "engine/audio/acoustics.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/core/random.h"
#include "tests/engine/audio/measure.h"

namespace brittle::audio {
namespace {

/// What comes back of a click of one sample at the start of the left side.
template <class Effect>
std::vector<float> answerOf(Effect& effect, double seconds, std::vector<float>* right = nullptr) {
  std::vector<float> left;
  const int blocks = static_cast<int>(seconds * kSampleRate / kBlockFrames);
  for (int i = 0; i < blocks; ++i) {
    Block in, out;
    in.left[0] = i == 0 ? 1.0f : 0.0f;
    effect.process(in, out);
    left.insert(left.end(), out.left, out.left + kBlockFrames);
    if (right != nullptr) right->insert(right->end(), out.right, out.right + kBlockFrames);
  }
  return left;
}

/// Only what is near a frequency.
std::vector<float> band(const std::vector<float>& in, float frequency) {
  StateVariable filter;
  filter.tune(frequency, 0.7f);
  std::vector<float> out;
  for (const float sample : in) out.push_back(filter.process(sample).band);
  return out;
}

TEST(Reverb, DecaysInTheTimeItIsGiven) {
  for (const float time : {0.1f, 0.2f, 0.5f, 0.7f, 1.0f, 1.1f, 3.0f})
    for (const float lowPass : {0.0f, 0.3f, 0.7f}) {
      Reverb reverb({0.5f, time, lowPass});
      const std::vector<float> answer = answerOf(reverb, 2.0 * static_cast<double>(time) + 0.5);
      EXPECT_NEAR(decayTimeOf(band(answer, 600.0f)) / static_cast<double>(time), 1.0, 0.1)
          << time << " s, low-pass " << lowPass;
    }
}

TEST(Reverb, HighFrequenciesAreGoneInHalfTheTime) {
  Reverb reverb({0.5f, 1.0f, 0.0f});
  const std::vector<float> answer = answerOf(reverb, 2.0);
  EXPECT_NEAR(decayTimeOf(band(answer, 18000.0f)), 0.55, 0.12);
}

TEST(Reverb, ItsEnergyIsItsVolume) {
  for (const float time : {0.2f, 0.6f, 1.1f}) {
    Reverb reverb({0.5f, time, 0.0f});
    std::vector<float> right;
    const std::vector<float> left = answerOf(reverb, 3.0, &right);
    double energy = 0.0;
    for (std::size_t i = 0; i < left.size(); ++i)
      energy += static_cast<double>(left[i]) * static_cast<double>(left[i]) +
                static_cast<double>(right[i]) * static_cast<double>(right[i]);
    EXPECT_NEAR(decibels(std::sqrt(energy) / 0.5), 0.0, 4.0) << time;
  }
}

TEST(Reverb, BothSidesHearItDifferentlyAndNotAtOnce) {
  Reverb reverb({0.5f, 1.0f, 0.0f});
  std::vector<float> right;
  const std::vector<float> left = answerOf(reverb, 1.0, &right);
  EXPECT_EQ(peakOf(part(left, 0.0, 0.020)), 0.0) << "the first wall is 7 m away";
  const double balance = decibels(rmsOf(left) / rmsOf(right));
  EXPECT_NEAR(balance, 0.0, 3.0);
  double product = 0.0;
  for (std::size_t i = 0; i < left.size(); ++i) product += static_cast<double>(left[i]) * static_cast<double>(right[i]);
  EXPECT_LT(std::fabs(product) / (rmsOf(left) * rmsOf(right) * static_cast<double>(left.size())), 0.3);
}

TEST(Reverb, IsDenseWithoutLoudEchoes) {
  Reverb reverb({1.0f, 1.0f, 0.0f});
  const std::vector<float> answer = answerOf(reverb, 1.0);
  // Gaussian noise has a crest of about 4 within 50 ms; single echoes would stand out far more.
  for (const double from : {0.1, 0.2, 0.3, 0.4})
    EXPECT_LT(peakOf(part(answer, from, 0.05)) / rmsOf(part(answer, from, 0.05)), 6.0) << from;
}

TEST(Reverb, BecomesExactlySilentAndThenCostsNothing) {
  Reverb reverb({0.7f, 0.5f, 0.2f});
  EXPECT_TRUE(reverb.isSilent());
  const std::vector<float> answer = answerOf(reverb, 3.0);
  EXPECT_TRUE(reverb.isSilent());
  EXPECT_EQ(peakOf(part(answer, 2.0, 1.0)), 0.0);
  const std::vector<float> again = answerOf(reverb, 3.0);
  EXPECT_EQ(answer, again) << "something was left of the first click";
}

TEST(Reverb, LowPassShuts) {
  Reverb open({0.5f, 0.5f, 0.0f}), shut({0.5f, 0.5f, 0.7f});
  EXPECT_LT(centroidOf(part(answerOf(shut, 1.0), 0.02, 0.1)), 0.3 * centroidOf(part(answerOf(open, 1.0), 0.02, 0.1)));
}

TEST(Echo, RepeatsToTheSample) {
  for (const float delay : {0.001f, 0.04f, 0.25f, 0.3337f, 0.8f}) {
    Echo echo({0.5f, delay, 0.5f, 0.0f});
    const std::size_t step = samplesIn(delay);
    const std::vector<float> answer = answerOf(echo, 3.0 * static_cast<double>(delay) + 0.1);
    for (std::size_t i = 0; i < answer.size(); ++i) {
      const std::size_t repeat = i / step;
      const float expected = i % step == 0 && repeat > 0 ? std::pow(0.5f, static_cast<float>(repeat)) : 0.0f;
      ASSERT_NEAR(answer[i], expected, 1e-6f) << "delay " << delay << " sample " << i;
    }
  }
}

TEST(Echo, EachRepeatIsDuller) {
  Echo echo({1.0f, 0.1f, 0.9f, 0.5f});
  const std::vector<float> answer = answerOf(echo, 0.5);
  const double first = centroidOf(part(answer, 0.09, 0.05)), third = centroidOf(part(answer, 0.29, 0.05));
  EXPECT_LT(first, 6000.0);
  EXPECT_LT(third, 0.75 * first);
  EXPECT_EQ(placeOfPeak(answer), samplesIn(0.1f));
}

TEST(Echo, StaysOnItsSide) {
  Echo echo({1.0f, 0.1f, 0.5f, 0.0f});
  std::vector<float> right;
  answerOf(echo, 0.5, &right);
  EXPECT_EQ(peakOf(right), 0.0);
}

TEST(Echo, BecomesExactlySilent) {
  Echo echo({0.9f, 0.25f, 0.6f, 0.1f});
  const std::vector<float> answer = answerOf(echo, 12.0);
  EXPECT_TRUE(echo.isSilent());
  EXPECT_EQ(peakOf(part(answer, 11.0, 1.0)), 0.0);
  EXPECT_EQ(answerOf(echo, 12.0), answer);
}

TEST(Space, ARoomThatAsksForNothingHoldsNothing) {
  const Acoustics none;
  EXPECT_FALSE(none.hasSpace());
  Space space(none);
  EXPECT_EQ(space.bytes(), 0u);
  EXPECT_TRUE(space.isSilent());
  const std::vector<float> answer = answerOf(space, 0.1);
  EXPECT_EQ(peakOf(answer), 0.0);
  Acoustics echoOnly;
  echoOnly.echo = {0.5f, 0.1f, 0.0f, 0.0f};
  EXPECT_EQ(Space(echoOnly).bytes(), 2 * samplesIn(0.1f) * sizeof(float));
}

TEST(Acoustics, AnyNumbersAreBroughtWithinLimits) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, infinite, -infinite, 1e30f, -1e30f, 0.0f}) {
    const Acoustics asked{{bad, bad, bad}, {bad, bad, bad, bad}, bad};
    Acoustics limited = withinLimits(asked);
    limited.reverb.volume = limited.echo.volume = 0.5f;
    Space space(limited);
    const std::vector<float> answer = answerOf(space, 1.0);
    for (const float sample : answer) ASSERT_TRUE(isFinite(sample));
    EXPECT_LE(peakOf(answer), 1.0);
  }
  const Acoustics fine{{0.35f, 0.7f, 0.3f}, {0.4f, 0.2f, 0.5f, 0.1f}, 0.2f};
  const Acoustics same = withinLimits(fine);
  EXPECT_EQ(same.reverb.time, 0.7f);
  EXPECT_EQ(same.echo.feedback, 0.5f);
  EXPECT_EQ(same.lowPass, 0.2f);
}

}  // namespace
}  // namespace brittle::audio
