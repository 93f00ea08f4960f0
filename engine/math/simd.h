// math/simd.h - four floats at once, element-wise only: +, -, *, /, square root, compare and select. No horizontal sums
// and no estimates, so every width and every instruction set gives the bits of the scalar code. GCC and clang vector
// extensions compile to SSE, NEON, WebAssembly SIMD or plain scalar code.
#pragma once

#include <cmath>
#include <cstdint>

namespace brittle {

typedef float Float4 __attribute__((vector_size(16)));
typedef std::int32_t Mask4 __attribute__((vector_size(16)));  // 0 or -1 per lane, as comparisons give

inline constexpr int kLanes = 4;

inline Float4 splat(float value) {
  return Float4{value, value, value, value};
}
inline Float4 select(Mask4 mask, Float4 ifTrue, Float4 ifFalse) {
  const auto a = __builtin_bit_cast(Mask4, ifTrue);
  const auto b = __builtin_bit_cast(Mask4, ifFalse);
  return __builtin_bit_cast(Float4, (a & mask) | (b & ~mask));
}
inline Float4 minOf(Float4 a, Float4 b) {
  return select(b < a, b, a);
}
inline Float4 maxOf(Float4 a, Float4 b) {
  return select(a < b, b, a);
}
/// The four become columns of what they are rows of.
inline void transpose(Float4& a, Float4& b, Float4& c, Float4& d) {
  const Float4 lowAb = __builtin_shufflevector(a, b, 0, 4, 1, 5), highAb = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Float4 lowCd = __builtin_shufflevector(c, d, 0, 4, 1, 5), highCd = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  a = __builtin_shufflevector(lowAb, lowCd, 0, 1, 4, 5);
  b = __builtin_shufflevector(lowAb, lowCd, 2, 3, 6, 7);
  c = __builtin_shufflevector(highAb, highCd, 0, 1, 4, 5);
  d = __builtin_shufflevector(highAb, highCd, 2, 3, 6, 7);
}
inline Float4 squareRoot(Float4 v) {
  return Float4{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
}

inline float select(bool mask, float ifTrue, float ifFalse) {
  return mask ? ifTrue : ifFalse;
}
inline float squareRoot(float v) {
  return std::sqrt(v);
}

/// A vector of N, where N is float or Float4 (one vector per lane): the same code serves both.
template <class N>
struct Wide3 {
  N x{}, y{}, z{};
};

template <class N>
inline Wide3<N> operator+(const Wide3<N>& a, const Wide3<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
inline Wide3<N> operator-(const Wide3<N>& a, const Wide3<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
inline Wide3<N> operator*(const Wide3<N>& a, N s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class N>
inline N dot(const Wide3<N>& a, const Wide3<N>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

}  // namespace brittle
