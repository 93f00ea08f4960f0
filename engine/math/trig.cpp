// Source: Cody and Waite, Software Manual for the Elementary Functions, 1980 (argument reduction); the kernels are
// Taylor expansions carried to where the next term lies below 2^-54 of the result on the reduced interval.
#include "engine/math/trig.h"

#include <cstdint>
#include <cmath>  // sqrt only: correctly rounded everywhere

namespace brittle {
namespace {

constexpr double kHalfPi = 1.57079632679489661923;
// pi/2 in three parts of 33 bits, so that k * part is exact for |k| < 2^20.
constexpr double kHalfPi1 = 1.57079632673412561417e+00;
constexpr double kHalfPi2 = 6.07710050630396597660e-11;
constexpr double kHalfPi3 = 2.02226624879595063154e-21;
constexpr double kLn2High = 6.93147180369123816490e-01;
constexpr double kLn2Low = 1.90821492927058770002e-10;

double nearestWhole(double x) {  // round half to even by the 2^52 trick; |x| < 2^51
  constexpr double shift = 6755399441055744.0;
  return (x + shift) - shift;
}

double sineKernel(double r) {  // |r| <= pi/4
  const double z = r * r;
  double sum = -1.0 / 1307674368000.0;
  sum = sum * z + 1.0 / 6227020800.0;
  sum = sum * z - 1.0 / 39916800.0;
  sum = sum * z + 1.0 / 362880.0;
  sum = sum * z - 1.0 / 5040.0;
  sum = sum * z + 1.0 / 120.0;
  sum = sum * z - 1.0 / 6.0;
  return r + r * z * sum;
}

double cosineKernel(double r) {
  const double z = r * r;
  double sum = 1.0 / 20922789888000.0;
  sum = sum * z - 1.0 / 87178291200.0;
  sum = sum * z + 1.0 / 479001600.0;
  sum = sum * z - 1.0 / 3628800.0;
  sum = sum * z + 1.0 / 40320.0;
  sum = sum * z - 1.0 / 720.0;
  sum = sum * z + 1.0 / 24.0;
  return 1.0 - 0.5 * z + z * z * sum;
}

struct Reduced {
  double r;
  int quadrant;
};

Reduced reduce(double angle) {
  const double k = nearestWhole(angle / kHalfPi);
  const double r = ((angle - k * kHalfPi1) - k * kHalfPi2) - k * kHalfPi3;
  return {r, static_cast<int>(static_cast<std::int64_t>(k) & 3)};
}

bool isUsable(double angle) {
  return angle - angle == 0.0 && angle < 1e9 && angle > -1e9;
}

double quarterTurns(double angle, int offset) {
  if (!isUsable(angle)) return __builtin_nan("");
  const Reduced reduced = reduce(angle);
  switch ((reduced.quadrant + offset) & 3) {
    case 0:
      return sineKernel(reduced.r);
    case 1:
      return cosineKernel(reduced.r);
    case 2:
      return -sineKernel(reduced.r);
    default:
      return -cosineKernel(reduced.r);
  }
}

double arcTangentKernel(double t) {  // 0 <= t <= 1; two halvings bring |t| below 0.2
  const double once = t / (1.0 + std::sqrt(1.0 + t * t));
  const double u = once / (1.0 + std::sqrt(1.0 + once * once));
  const double z = u * u;
  double sum = 0.0;
  for (int n = 23; n >= 1; n -= 2) sum = sum * -z + 1.0 / n;
  return 4.0 * u * sum;
}

double scaleByPowerOfTwo(double x, int exponent) {
  while (exponent > 1000) {
    x *= 0x1p1000;
    exponent -= 1000;
  }
  while (exponent < -1000) {
    x *= 0x1p-1000;
    exponent += 1000;
  }
  return x * __builtin_bit_cast(double, static_cast<std::uint64_t>(1023 + exponent) << 52);
}

bool isWhole(double x) {
  return (x < 0x1p51 && x > -0x1p51) ? nearestWhole(x) == x : true;
}
bool isOdd(double x) {
  return x < 0x1p51 && x > -0x1p51 && (static_cast<std::int64_t>(x) & 1) != 0;
}

}  // namespace

double sineOf(double angle) {
  return quarterTurns(angle, 0);
}
double cosineOf(double angle) {
  return quarterTurns(angle, 1);
}

double arcTangentOf(double y, double x) {
  if (x != x || y != y) return __builtin_nan("");
  const double absX = x < 0.0 ? -x : x;
  const double absY = y < 0.0 ? -y : y;
  if (absX == 0.0 && absY == 0.0) return 0.0;
  double angle = absY <= absX ? arcTangentKernel(absY / absX) : kHalfPi - arcTangentKernel(absX / absY);
  if (x < 0.0) angle = 2.0 * kHalfPi - angle;
  return y < 0.0 ? -angle : angle;
}

double exponentialOf(double x) {
  if (x != x) return x;
  if (x > 709.7) return __builtin_inf();
  if (x < -745.0) return 0.0;
  const double k = nearestWhole(x / (kLn2High + kLn2Low));
  const double r = (x - k * kLn2High) - k * kLn2Low;
  double sum = 1.0;
  for (int n = 16; n >= 1; --n) sum = 1.0 + sum * (r / n);
  return scaleByPowerOfTwo(sum, static_cast<int>(k));
}

double logarithmOf(double x) {
  if (x != x || x < 0.0) return __builtin_nan("");
  if (x == 0.0) return -__builtin_inf();
  if (x - x != 0.0) return x;
  int exponent = 0;
  if (x < 0x1p-1000) {
    x *= 0x1p60;
    exponent = -60;
  }
  const auto bits = __builtin_bit_cast(std::uint64_t, x);
  exponent += static_cast<int>(bits >> 52) - 1023;
  double m = __builtin_bit_cast(double, (bits & 0x000fffffffffffffull) | 0x3ff0000000000000ull);
  if (m > 1.41421356237309505) {
    m *= 0.5;
    ++exponent;
  }
  const double s = (m - 1.0) / (m + 1.0);
  const double z = s * s;
  double sum = 0.0;
  for (int n = 23; n >= 1; n -= 2) sum = sum * z + 1.0 / n;
  const double k = exponent;
  return k * kLn2High + (2.0 * s * sum + k * kLn2Low);
}

double power(double x, double y) {
  if (y == 0.0 || x == 1.0) return 1.0;
  if (x != x || y != y) return __builtin_nan("");
  if (isWhole(y) && y <= 64.0 && y >= -64.0) {  // exact where a product is exact: levels count on 2^10 == 1024
    double product = 1.0;
    for (int n = static_cast<int>(y < 0.0 ? -y : y); n > 0; --n) product *= x;
    return y < 0.0 ? 1.0 / product : product;
  }
  if (y == 0.5 && x >= 0.0) return std::sqrt(x);
  if (x == 0.0) return y > 0.0 ? 0.0 : __builtin_inf();
  if (x < 0.0) {
    if (!isWhole(y)) return __builtin_nan("");
    const double magnitude = exponentialOf(y * logarithmOf(-x));
    return isOdd(y) ? -magnitude : magnitude;
  }
  return exponentialOf(y * logarithmOf(x));
}

float sine(float angle) {
  return static_cast<float>(sineOf(angle));
}
float cosine(float angle) {
  return static_cast<float>(cosineOf(angle));
}
float tangent(float angle) {
  return static_cast<float>(sineOf(angle) / cosineOf(angle));
}
float arcTangent(float y, float x) {
  return static_cast<float>(arcTangentOf(y, x));
}
float exponential(float x) {
  return static_cast<float>(exponentialOf(x));
}
float logarithm(float x) {
  return static_cast<float>(logarithmOf(x));
}

float arcCosine(float x) {
  const double c = x < -1.0f ? -1.0 : (x > 1.0f ? 1.0 : static_cast<double>(x));
  return static_cast<float>(arcTangentOf(std::sqrt((1.0 - c) * (1.0 + c)), c));
}

float arcSine(float x) {
  const double s = x < -1.0f ? -1.0 : (x > 1.0f ? 1.0 : static_cast<double>(x));
  return static_cast<float>(arcTangentOf(s, std::sqrt((1.0 - s) * (1.0 + s))));
}

}  // namespace brittle
