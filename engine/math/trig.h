// math/trig.h - sine and its family from additions, multiplications and square roots only, so that they give the same
// bits with every compiler and C library. Evaluated in double, rounded once; errors below 1 ulp of float for |angle| <
// 1e5.
#pragma once

namespace brittle {

inline constexpr float kPi = 3.14159265358979f;

float sine(float angle);
float cosine(float angle);
float tangent(float angle);
/// In [-pi, pi]; 0 for (0, 0).
float arcTangent(float y, float x);
/// Arguments beyond [-1, 1] are clamped. In [0, pi].
float arcCosine(float x);
/// In [-pi/2, pi/2]; arguments beyond [-1, 1] are clamped.
float arcSine(float x);
/// e^x; 0 below -104, infinity above 88.73.
float exponential(float x);
/// Natural logarithm; -infinity for 0, NaN below.
float logarithm(float x);
/// x^y for x >= 0; for x < 0 only whole y, NaN otherwise.
double power(double x, double y);

double sineOf(double angle);
double cosineOf(double angle);
double arcTangentOf(double y, double x);
double exponentialOf(double x);
double logarithmOf(double x);

}  // namespace brittle
