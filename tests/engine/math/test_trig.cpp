#include "engine/math/trig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/core/hash.h"
#include "engine/core/random.h"

namespace brittle {
namespace {

// Distance from the true value in units of the last place of float at that value.
double errorInUlp(float value, long double truth) {
  const float rounded = static_cast<float>(truth);
  const float next = std::nextafter(std::fabs(rounded), std::numeric_limits<float>::infinity());
  const double ulp = static_cast<double>(next) - static_cast<double>(std::fabs(rounded));
  return static_cast<double>(std::fabs(static_cast<long double>(value) - truth)) / ulp;
}

template <class Ours, class Truth>
double worstError(Ours ours, Truth truth, float low, float high) {
  Random random(11);
  double worst = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const float x = random.nextFloat(low, high);
    worst = std::max(worst, errorInUlp(ours(x), truth(static_cast<long double>(x))));
  }
  return worst;
}

// The oracle: long double libm of the build machine (64-bit significand on x86-64).
TEST(Trig, StaysWithinOneUlpOfTheTruth) {
  const auto sin = [](long double x) { return std::sin(x); };
  const auto cos = [](long double x) { return std::cos(x); };
  EXPECT_LT(worstError(sine, sin, -7.0f, 7.0f), 1.0);
  EXPECT_LT(worstError(sine, sin, -1e5f, 1e5f), 1.0);
  EXPECT_LT(worstError(cosine, cos, -1e5f, 1e5f), 1.0);
  EXPECT_LT(worstError(
                tangent, [](long double x) { return std::tan(x); }, -1.5f, 1.5f),
            1.0);
  EXPECT_LT(worstError(
                exponential, [](long double x) { return std::exp(x); }, -80.0f, 88.0f),
            1.0);
  EXPECT_LT(worstError(
                logarithm, [](long double x) { return std::log(x); }, 1e-6f, 1e6f),
            1.0);
  EXPECT_LT(worstError(
                arcSine, [](long double x) { return std::asin(x); }, -1.0f, 1.0f),
            1.0);
  EXPECT_LT(worstError(
                arcCosine, [](long double x) { return std::acos(x); }, -1.0f, 1.0f),
            1.0);
  EXPECT_LT(worstError([](float x) { return arcTangent(x, -0.7f); }, [](long double x) { return std::atan2(x, -0.7f); },
                       -50.0f, 50.0f),
            1.0);
}

TEST(Trig, SpecialValues) {
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(sine(0.0f), 0.0f);
  EXPECT_EQ(cosine(0.0f), 1.0f);
  EXPECT_TRUE(std::isnan(sine(infinity)));
  EXPECT_TRUE(std::isnan(sine(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_EQ(arcTangent(0.0f, 0.0f), 0.0f);
  EXPECT_EQ(arcTangent(0.0f, -1.0f), kPi);
  EXPECT_EQ(arcTangent(1.0f, 0.0f), kPi / 2);
  EXPECT_EQ(arcCosine(2.0f), 0.0f);
  EXPECT_EQ(arcCosine(-2.0f), kPi);
  EXPECT_EQ(exponential(0.0f), 1.0f);
  EXPECT_EQ(exponential(100.0f), infinity);
  EXPECT_EQ(exponential(-200.0f), 0.0f);
  EXPECT_EQ(logarithm(1.0f), 0.0f);
  EXPECT_EQ(logarithm(0.0f), -infinity);
  EXPECT_TRUE(std::isnan(logarithm(-1.0f)));
}

TEST(Trig, PowersOfWholeNumbersAreExact) {
  EXPECT_EQ(power(2.0, 10.0), 1024.0);
  EXPECT_EQ(power(-3.0, 3.0), -27.0);
  EXPECT_EQ(power(10.0, -2.0), 1.0 / 100.0);
  EXPECT_EQ(power(9.0, 0.5), 3.0);
  EXPECT_EQ(power(0.0, 0.0), 1.0);
  EXPECT_TRUE(std::isnan(power(-8.0, 1.0 / 3.0)));
  EXPECT_NEAR(power(1.5, 2.5), std::pow(1.5, 2.5), 1e-14);
}

// A property libm does not promise and a simulation likes: symmetric to the bit.
TEST(Trig, SineIsOddAndCosineEven) {
  Random random(3);
  for (int i = 0; i < 10000; ++i) {
    const float x = random.nextFloat(0.0f, 1000.0f);
    ASSERT_EQ(sine(-x), -sine(x)) << x;
    ASSERT_EQ(cosine(-x), cosine(x)) << x;
  }
}

// The same on every compiler and processor; tools/cross_hash runs it there too.
TEST(Trig, GoldenHashOfAHundredThousandValues) {
  StateHash hash;
  Random random(5);
  for (int i = 0; i < 100000; ++i) {
    const float x = random.nextFloat(-1e4f, 1e4f);
    const float unit = random.nextFloat(-1.0f, 1.0f);
    hash.add(sine(x));
    hash.add(cosine(x));
    hash.add(tangent(unit));
    hash.add(arcTangent(x, unit));
    hash.add(arcSine(unit));
    hash.add(arcCosine(unit));
    hash.add(exponential(20.0f * unit));
    hash.add(logarithm(x * x));
    hash.add(static_cast<float>(power(1.0 + unit, x * 1e-3)));
  }
  EXPECT_EQ(hash.value(), 14089730084706496906ull);
}

}  // namespace
}  // namespace brittle
