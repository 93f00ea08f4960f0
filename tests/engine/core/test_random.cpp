#include "engine/core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace brittle {
namespace {

// Source: the demo of the PCG minimal C library (pcg32 seeded with 42, stream 54).
TEST(Random, GivesThePublishedSequence) {
  Random random(42, 54);
  for (const std::uint32_t expected : {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu})
    EXPECT_EQ(random.next(), expected);
}

TEST(Random, FloatsLieInTheirRange) {
  Random random(1);
  double sum = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const float x = random.nextFloat();
    ASSERT_GE(x, 0.0f);
    ASSERT_LT(x, 1.0f);
    sum += x;
  }
  EXPECT_NEAR(sum / 100000.0, 0.5, 0.005);
}

TEST(Random, NextBelowReachesEveryValueEvenly) {
  Random random(2);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(random.nextBelow(7));
  for (const int count : counts) EXPECT_NEAR(count, 10000, 400);  // four standard deviations
}

TEST(Random, StreamsOfOneSeedDiffer) {
  Random a(5, 1), b(5, 2);
  int equal = 0;
  for (int i = 0; i < 1000; ++i) equal += a.next() == b.next() ? 1 : 0;
  EXPECT_LE(equal, 1);
}

TEST(Random, ARestoredStreamContinues) {
  Random random(9, 3);
  for (int i = 0; i < 17; ++i) random.next();
  Random copy;
  copy.restore(random.state(), random.increment());
  for (int i = 0; i < 100; ++i) ASSERT_EQ(copy.next(), random.next());
}

TEST(Random, MixedSeedsDoNotCollideOnSmallNumbers) {
  std::vector<std::uint64_t> seeds;
  for (std::uint64_t a = 0; a < 64; ++a)
    for (std::uint64_t b = 0; b < 64; ++b) seeds.push_back(mixSeed(a, b));
  std::sort(seeds.begin(), seeds.end());
  EXPECT_EQ(std::adjacent_find(seeds.begin(), seeds.end()), seeds.end());
}

}  // namespace
}  // namespace brittle
