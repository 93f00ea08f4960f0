#include "engine/audio/clip.h"

#include <gtest/gtest.h>

namespace brittle::audio {
namespace {

TEST(Clip, IsScaledToItsPeakAndFadesOut) {
  const Clip clip(Samples(4800, -0.25f), 0.5f);
  ASSERT_EQ(clip.size(), 4800u);
  EXPECT_EQ(*clip.at(0), -0.5f);
  EXPECT_EQ(*clip.at(4800 - 240 - 1), -0.5f);
  EXPECT_NEAR(*clip.at(4800 - 120), -0.25f, 0.003f);
  EXPECT_EQ(*clip.at(4799), 0.0f);
}

TEST(Clip, MayBeReadAroundItsEnds) {
  const Clip clip(Samples(1000, 1.0f));
  EXPECT_EQ(clip.at(0)[-1], 0.0f);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(clip.at(999)[1 + i], 0.0f);
}

TEST(Clip, KnowsHowLoudItWillStillGet) {
  Samples samples(10000, 0.1f);
  samples[100] = 1.0f;
  samples[5000] = -0.5f;
  const Clip clip(samples);
  EXPECT_EQ(clip.loudestFrom(0), 1.0f);
  EXPECT_EQ(clip.loudestFrom(256), 0.5f);
  EXPECT_NEAR(clip.loudestFrom(5120 + 1), 0.1f, 1e-6f);
  EXPECT_EQ(clip.loudestFrom(20000), 0.0f);
}

TEST(Clip, OfSilenceIsSilent) {
  const Clip clip(Samples(100, 0.0f));
  EXPECT_EQ(clip.loudestFrom(0), 0.0f);
  EXPECT_EQ(*clip.at(50), 0.0f);
  EXPECT_EQ(Clip({}).size(), 0u);
}

}  // namespace
}  // namespace brittle::audio
