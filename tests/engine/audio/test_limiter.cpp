#include "engine/audio/limiter.h"

#include <gtest/gtest.h>

#include "engine/core/random.h"
#include "tests/engine/audio/measure.h"

namespace brittle::audio {
namespace {

std::vector<float> limited(Limiter& limiter, const std::vector<float>& in) {
  std::vector<float> out;
  for (std::size_t i = 0; i + kBlockFrames <= in.size(); i += kBlockFrames) {
    Block block;
    for (std::size_t k = 0; k < kBlockFrames; ++k) {
      block.left[k] = in[i + k];
      block.right[k] = -0.5f * in[i + k];
    }
    limiter.process(block);
    out.insert(out.end(), block.left, block.left + kBlockFrames);
  }
  return out;
}

TEST(Limiter, BelowTheCeilingItOnlyDelays) {
  Random random(3);
  std::vector<float> in(4800);
  for (float& sample : in) sample = random.nextFloat(-kCeiling, kCeiling);
  Limiter limiter;
  const std::vector<float> out = limited(limiter, in);
  for (std::size_t i = kBlockFrames; i < out.size(); ++i) ASSERT_EQ(out[i], in[i - kBlockFrames]);
}

TEST(Limiter, NothingIsAboveTheCeiling) {
  Random random(4);
  std::vector<float> in(480000);
  float level = 1.0f;
  for (std::size_t i = 0; i < in.size(); ++i) {
    if (i % 1000 == 0) level = random.nextFloat(0.0f, 6.0f) * random.nextFloat(0.0f, 10.0f);
    in[i] = random.nextFloat(-level, level);
  }
  Limiter limiter;
  EXPECT_LE(peakOf(limited(limiter, in)), static_cast<double>(kCeiling) * 1.000001);
}

TEST(Limiter, RecoversSlowlyAndWholly) {
  std::vector<float> in(96000, 0.5f);
  in[100] = 9.7f;
  Limiter limiter;
  const std::vector<float> out = limited(limiter, in);
  EXPECT_NEAR(out[100 + kBlockFrames], kCeiling, 0.05f);
  EXPECT_LT(out[1000], 0.2f);
  EXPECT_NEAR(out[8000], 0.5f * (1.0f - 0.9f * std::exp(-8000.0f / 5330.0f)), 0.02f);
  EXPECT_EQ(out.back(), 0.5f);
  EXPECT_EQ(limiter.gain(), 1.0f);
}

}  // namespace
}  // namespace brittle::audio
