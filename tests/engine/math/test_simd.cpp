#include "engine/math/simd.h"

#include <gtest/gtest.h>

#include "engine/core/hash.h"
#include "engine/core/random.h"
#include "engine/math/types.h"

namespace brittle {
namespace {

float anyFloat(Random& random) {
  return __builtin_bit_cast(float, random.next());
}

// Every operation, lane by lane, gives the bits of the scalar one: also for NaN, infinity, denormals and signed zeros.
TEST(Simd, LanesGiveTheScalarBits) {
  Random random(12);
  for (int i = 0; i < 20000; ++i) {
    Float4 a, b;
    for (int lane = 0; lane < kLanes; ++lane) {
      a[lane] = anyFloat(random);
      b[lane] = lane == 3 ? -0.0f : anyFloat(random);
    }
    const Float4 sum = a + b, product = a * b, quotient = a / b, low = minOf(a, b), high = maxOf(a, b),
                 root = squareRoot(a);
    for (int lane = 0; lane < kLanes; ++lane) {
      const float x = a[lane], y = b[lane];
      ASSERT_EQ(canonicalBits(sum[lane]), canonicalBits(x + y));
      ASSERT_EQ(canonicalBits(product[lane]), canonicalBits(x * y));
      ASSERT_EQ(canonicalBits(quotient[lane]), canonicalBits(x / y));
      ASSERT_EQ(canonicalBits(low[lane]), canonicalBits(minOf(x, y)));
      ASSERT_EQ(canonicalBits(high[lane]), canonicalBits(maxOf(x, y)));
      ASSERT_EQ(canonicalBits(root[lane]), canonicalBits(std::sqrt(x)));
    }
  }
}

TEST(Simd, FourVectorsAreFourScalarVectors) {
  Random random(13);
  Wide3<Float4> a, b;
  Vec3 as[kLanes], bs[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    for (int i = 0; i < 3; ++i) {
      as[lane][i] = random.nextFloat(-5.0f, 5.0f);
      bs[lane][i] = random.nextFloat(-5.0f, 5.0f);
    }
    a.x[lane] = as[lane].x(), a.y[lane] = as[lane].y(), a.z[lane] = as[lane].z();
    b.x[lane] = bs[lane].x(), b.y[lane] = bs[lane].y(), b.z[lane] = bs[lane].z();
  }
  const Float4 products = dot(a, b);
  for (int lane = 0; lane < kLanes; ++lane) {
    EXPECT_EQ(products[lane],
              (as[lane].x() * bs[lane].x() + as[lane].y() * bs[lane].y()) + as[lane].z() * bs[lane].z());
  }
}

}  // namespace
}  // namespace brittle
