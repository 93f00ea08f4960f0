#include "engine/core/hash.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <string>

namespace brittle {
namespace {

float floatOf(std::uint32_t bits) {
  return __builtin_bit_cast(float, bits);
}

template <class T>
std::uint64_t hashOf(T value) {
  StateHash hash;
  hash.add(value);
  return hash.value();
}

// Source: the xxHash specification's own test vectors (XXH64).
TEST(Hash, IsXxh64) {
  EXPECT_EQ(hashBytes("", 0), 0xef46db3751d8e999ull);
  EXPECT_EQ(hashBytes("abc", 3), 0x44bc2cf5ad770999ull);
}

TEST(Hash, HasOneZeroAndOneNan) {
  EXPECT_EQ(hashOf(-0.0f), hashOf(0.0f));
  EXPECT_EQ(hashOf(floatOf(0x7fc00001)), hashOf(floatOf(0xffc12345)));
  EXPECT_EQ(hashOf(floatOf(0x7f800001)), hashOf(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_NE(hashOf(std::numeric_limits<float>::denorm_min()), hashOf(0.0f));
  EXPECT_NE(hashOf(std::numeric_limits<float>::infinity()), hashOf(std::numeric_limits<float>::quiet_NaN()));
}

TEST(Hash, TheSameGoesForDouble) {
  const auto doubleOf = [](std::uint64_t bits) { return __builtin_bit_cast(double, bits); };
  EXPECT_EQ(hashOf(-0.0), hashOf(0.0));
  EXPECT_EQ(hashOf(doubleOf(0x7ff8000000000001)), hashOf(doubleOf(0xfff8123456789abc)));
  EXPECT_NE(hashOf(std::numeric_limits<double>::infinity()), hashOf(std::numeric_limits<double>::quiet_NaN()));
  for (int i = 0; i < 64; ++i) EXPECT_NE(hashOf(doubleOf(1ull << i)), hashOf(2.5)) << i;
}

TEST(Hash, EveryBitOfAFloatCounts) {
  const std::uint32_t bits = 0x3f9e3779;
  for (int i = 0; i < 32; ++i) EXPECT_NE(hashOf(floatOf(bits)), hashOf(floatOf(bits ^ (1u << i)))) << i;
}

TEST(Hash, OrderAndCountMatter) {
  StateHash ab, ba, a, none;
  ab.add(1u), ab.add(2u);
  ba.add(2u), ba.add(1u);
  a.add(1u);
  EXPECT_NE(ab.value(), ba.value());
  EXPECT_NE(ab.value(), a.value());
  EXPECT_NE(a.value(), none.value());
}

// Asking for the value in between, at any count, changes nothing that follows.
TEST(Hash, ValueIsARead) {
  StateHash asked, silent;
  for (std::uint32_t i = 0; i < 300; ++i) {
    asked.add(i), silent.add(i);
    asked.value();
  }
  EXPECT_EQ(asked.value(), silent.value());
}

TEST(Hash, GoldenValueOfAThousandWords) {
  StateHash hash;
  for (std::uint32_t i = 0; i < 1000; ++i) hash.add(i * 2654435761u);
  hash.add(std::uint64_t{1} << 40);
  hash.add(1.5f);
  hash.add(true);
  EXPECT_EQ(hash.value(), 12028411939672988428ull);
}

}  // namespace
}  // namespace brittle
