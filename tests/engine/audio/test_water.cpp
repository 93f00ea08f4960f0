// Splashes: four sizes, made when they are asked for.
#include <gtest/gtest.h>

#include "engine/audio/bank.h"
#include "engine/audio/synthesis.h"

namespace brittle::audio {
namespace {

constexpr Sound kSplashes[] = {Sound::SplashDrip, Sound::SplashSmall, Sound::SplashMedium, Sound::SplashLarge};

TEST(SplashSounds, AreComputedWhenTheyAreAskedFor) {
  const Bank bank;
  const std::size_t before = bank.bytes();
  const Clip& clip = bank.clip(Sound::SplashLarge, 0);
  EXPECT_GT(clip.size(), samplesIn(1.0f));
  EXPECT_GT(bank.bytes(), before);
  EXPECT_EQ(&bank.clip(Sound::SplashLarge, 0), &clip) << "once";
  EXPECT_EQ(bank.variations(Sound::SplashSmall), 4u);
}

TEST(SplashSounds, AreTheSameEveryTimeAndLongerTheLarger) {
  std::size_t last = 0;
  for (int size = 0; size < 4; ++size) {
    Random one(7), two(7);
    const Samples samples = splash(size, one);
    EXPECT_EQ(samples, splash(size, two));
    EXPECT_GT(samples.size(), last);
    last = samples.size();
  }
}

TEST(SplashSounds, BelongToWater) {
  for (const Sound sound : kSplashes) EXPECT_TRUE(isLate(sound)) << nameOf(sound);
  EXPECT_FALSE(isLate(Sound::Throw));
}

}  // namespace
}  // namespace brittle::audio
