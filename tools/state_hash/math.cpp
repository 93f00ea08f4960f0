#include "engine/core/hash.h"
#include "engine/core/random.h"
#include "engine/math/simd.h"
#include "engine/math/transform.h"
#include "tools/state_hash/sections.h"

namespace brittle {
namespace {

Vec3 randomVector(Random& random, float size) {
  const float x = random.nextFloat(-size, size);
  const float y = random.nextFloat(-size, size);
  const float z = random.nextFloat(-size, size);
  return Vec3(x, y, z);
}

void add(StateHash& hash, const Vec3& v) {
  for (int i = 0; i < 3; ++i) hash.add(v[i]);
}

std::uint64_t randomStreams() {
  StateHash hash;
  Random random(1, 2);
  for (int i = 0; i < 10000; ++i) hash.add(random.next());
  for (int i = 0; i < 10000; ++i) hash.add(random.nextFloat(-3.0f, 7.0f));
  return hash.value();
}

std::uint64_t trigonometry() {
  StateHash hash;
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
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
  return hash.value();
}

std::uint64_t transforms() {
  StateHash hash;
  Random random(6);
  Transform pose;
  Vec3 point = Vec3::UnitX();
  for (int i = 0; i < 20000; ++i) {
    const Vec3 spin = randomVector(random, 3.0f);
    pose.rotation = integrateRotation(pose.rotation, spin, 1.0f / 60.0f);
    pose.position = 0.99f * pose.position + randomVector(random, 0.1f);
    point = normalizedOr(pose.toLocal(point), Vec3::UnitX());
    const Mat3 turned = pose.rotation.toRotationMatrix() * crossMatrix(point);
    add(hash, turned * spin);
    add(hash, perpendicular(point));
  }
  return hash.value();
}

std::uint64_t lanes() {
  StateHash hash;
  Random random(7);
  Float4 sum = splat(0.0f);
  for (int i = 0; i < 20000; ++i) {
    Wide3<Float4> a, b;
    for (int lane = 0; lane < kLanes; ++lane) {
      const Vec3 u = randomVector(random, 2.0f);
      const Vec3 v = randomVector(random, 2.0f);
      a.x[lane] = u.x(), a.y[lane] = u.y(), a.z[lane] = u.z();
      b.x[lane] = v.x(), b.y[lane] = v.y(), b.z[lane] = v.z();
    }
    const Wide3<Float4> c = a * splat(0.7f) - b;
    sum = maxOf(minOf(sum * splat(0.5f) + dot(c, a + b * splat(0.3f)), splat(100.0f)), splat(-100.0f)) +
          squareRoot(dot(c, c));
    for (int lane = 0; lane < kLanes; ++lane) hash.add(static_cast<float>(sum[lane]));
  }
  return hash.value();
}

}  // namespace

void addMath(std::vector<Line>& lines) {
  lines.push_back({"random streams", randomStreams()});
  lines.push_back({"trigonometry", trigonometry()});
  lines.push_back({"transforms", transforms()});
  lines.push_back({"four lanes", lanes()});
}

}  // namespace brittle
