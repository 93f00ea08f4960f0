// B15: what hangs together. Two convexes that touch by a face with more area than (2 slop)^2 are connected; by an edge
// or a corner alone, never; gaps and overlaps of 1e-6 m make no difference. The decision flips at one gap only, the
// slop, and at one shared area, and it has no memory: the way back flips at the same place. Outside the slop it agrees
// with an exact separating-axis test: apart by more, not connected; into each other by more, connected.
#include <gtest/gtest.h>

#include "engine/fracture/connect.h"
#include "engine/geometry/gjk.h"
#include "engine/geometry/make.h"
#include "engine/math/transform.h"
#include "tests/engine/geometry/exact.h"
#include "tests/engine/geometry/shapes.h"
#include "tests/hard_cases/case.h"

namespace brittle::fracture {
namespace {

using geometry::Convex;
using geometry::Exact;

constexpr float kSlop = 0.001f;  // [m]

/// Two cubes of 1 m, the second moved by `offset`, both then turned and moved alike.
struct Pair {
  Convex a, b;
  Pair(const Vec3& offset, const Quat& turn)
      : a(geometry::transformed(geometry::makeBox<float>(Vec3::Constant(0.5f)), turn, Vec3::Zero())),
        b(geometry::transformed(geometry::makeBox<float>(Vec3::Constant(0.5f), offset), turn, Vec3::Zero())) {}
};

class B15 : public testing::Test {
 protected:
  ConnectScratch used;  // as earlier questions have left it

  bool isConnected(const Convex& a, const Convex& b) {
    const bool answer = areConnected(a, b, kSlop);
    EXPECT_EQ(answer, areConnected(b, a, kSlop)) << "it is symmetric";
    EXPECT_EQ(answer, areConnected(a, b, kSlop, used)) << "it has no memory";
    return answer;
  }
  bool isConnected(const Vec3& offset, const Quat& turn) {
    const Pair pair(offset, turn);
    return isConnected(pair.a, pair.b);
  }
};

Quat drawTurn(Random& random, int i) {
  const float x = random.nextFloat(-3.0f, 3.0f);
  const float y = random.nextFloat(-3.0f, 3.0f);
  const float z = random.nextFloat(-3.0f, 3.0f);
  return i == 0 ? Quat::Identity() : rotationXyz(Vec3(x, y, z));
}

TEST_F(B15, FacesHoldEdgesAndCornersDoNot) {
  Random random(101);
  for (int i = 0; i < hard::counted(200, 20000); ++i) {
    const Quat turn = drawTurn(random, i);
    for (const float gap : {-1e-6f, 0.0f, 1e-6f}) {
      const float touching = 1.0f + gap;
      EXPECT_TRUE(isConnected({touching, 0.0f, 0.0f}, turn)) << "a face, gap " << gap;
      EXPECT_TRUE(isConnected({touching, 0.9f, -0.9f}, turn)) << "a part of one, gap " << gap;
      EXPECT_FALSE(isConnected({touching, touching, 0.0f}, turn)) << "an edge, gap " << gap;
      EXPECT_FALSE(isConnected({touching, touching, 0.4f}, turn)) << "half an edge, gap " << gap;
      EXPECT_FALSE(isConnected({touching, touching, touching}, turn)) << "a corner, gap " << gap;
    }
    hard::reportSum("poses", 1);
  }
}

/// Where the answer changes while `offsetAt(i)` moves from one end to the other, up and down again.
template <class OffsetAt>
void expectOneFlip(const OffsetAt& offsetAt, int steps, float expected, float tolerance) {
  std::vector<bool> up;
  for (int i = 0; i <= steps; ++i) up.push_back(offsetAt(i).second);
  int flips = 0;
  for (int i = steps; i >= 0; --i) {
    const auto [at, answer] = offsetAt(i);
    EXPECT_EQ(answer, up[static_cast<std::size_t>(i)]) << "the way back";
    if (i == steps || answer == up[static_cast<std::size_t>(i) + 1]) continue;
    ++flips;
    EXPECT_NEAR(at, expected, tolerance);
    hard::reportWorst("threshold off by", std::abs(at / expected - 1.0), "of it");
  }
  EXPECT_EQ(flips, 1);
}

TEST_F(B15, OneGapDecides) {
  Random random(102);
  for (int i = 0; i < hard::counted(20, 500); ++i) {
    const Quat turn = drawTurn(random, i);
    const auto at = [&](int step) {
      const float gap = (0.01f * (static_cast<float>(step) + 0.5f) - 3.0f) * kSlop;  // not on the slop itself
      return std::make_pair(gap, isConnected({1.0f + gap, 0.1f, 0.2f}, turn));
    };
    expectOneFlip(at, 600, kSlop, 0.011f * kSlop);
  }
}

TEST_F(B15, OneAreaDecides) {
  Random random(103);
  for (int i = 0; i < hard::counted(20, 500); ++i) {
    const Quat turn = drawTurn(random, i);
    const auto at = [&](int step) {
      const float side = 0.01f * (static_cast<float>(step) + 0.5f) * kSlop;  // of the square that both faces share
      return std::make_pair(side, isConnected({1.0f, 1.0f - side, 1.0f - side}, turn));
    };
    expectOneFlip(at, 400, 2.0f * kSlop, 0.011f * kSlop);
  }
}

enum class Relation { Apart, Deep, Near };

/// Exactly how two convexes of triangles lie: apart by more than `slop`, into each other by more, or neither.
Relation relationOf(const Convex& first, const Convex& second, const Exact& slop) {
  const geometry::ConvexT<Exact> a = exactOf(first), b = exactOf(second);
  bool isDeep = true, isApart = false;
  const auto tryAxis = [&](const Vec3T<Exact>& u, const Vec3T<Exact>& v) {
    const Exact n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const Exact square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    if (square == 0) return;
    const auto along = [&](const geometry::VertexT<Exact>& vertex) {
      return Exact(n[0] * vertex.point[0] + n[1] * vertex.point[1] + n[2] * vertex.point[2]);
    };
    Exact lowA = along(a.vertices[0]), highA = lowA, lowB = along(b.vertices[0]), highB = lowB;
    for (const auto& vertex : a.vertices)
      lowA = minOf<Exact>(lowA, along(vertex)), highA = maxOf<Exact>(highA, along(vertex));
    for (const auto& vertex : b.vertices)
      lowB = minOf<Exact>(lowB, along(vertex)), highB = maxOf<Exact>(highB, along(vertex));
    const Exact gap = maxOf<Exact>(lowB - highA, lowA - highB);
    const bool isBeyond = gap * gap > slop * slop * square;
    isApart = isApart || (gap > 0 && isBeyond);
    isDeep = isDeep && gap < 0 && isBeyond;
  };
  const auto edgeOf = [](const geometry::ConvexT<Exact>& convex, std::uint32_t edge) {
    const Vec3T<Exact>&from = convex.view().startOf(edge), &to = convex.view().endOf(edge);
    return Vec3T<Exact>(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
  };
  for (const geometry::ConvexT<Exact>* convex : {&a, &b})
    for (const auto& face : convex->faces)
      tryAxis(edgeOf(*convex, face.edge), edgeOf(*convex, convex->edges[face.edge].next));
  for (std::uint32_t i = 0; i < a.edges.size(); ++i)
    for (std::uint32_t k = 0; k < b.edges.size(); ++k)
      if (a.edges[i].opposite > i && b.edges[k].opposite > k) tryAxis(edgeOf(a, i), edgeOf(b, k));
  return isApart ? Relation::Apart : isDeep ? Relation::Deep : Relation::Near;
}

TEST_F(B15, AgreesWithTheExactTestOutsideTheSlop) {
  Random random(104);
  int counts[3] = {0, 0, 0};
  for (int i = 0; i < hard::counted(400, 40000); ++i) {
    const Convex a = geometry::test::randomHull(random, static_cast<int>(4 + random.nextBelow(3)), Vec3::Ones());
    Convex b = geometry::test::randomHull(random, static_cast<int>(4 + random.nextBelow(3)), Vec3::Ones());
    // Brought together along the axis between them, until the gap is a few slops either way.
    geometry::SimplexCache cache;
    const Vec3 away(0.3f, random.nextFloat(-1.0f, 1.0f), 2.5f);
    for (geometry::Vertex& vertex : b.vertices) vertex.point += away;
    for (geometry::Face& face : b.faces) face.plane.offset += face.plane.normal.dot(away);
    const geometry::Separation apart =
        geometry::separation({a, Vec3::Zero(), 0.0f}, {}, {b, Vec3::Zero(), 0.0f}, {}, cache);
    const Vec3 move = apart.normal * (random.nextFloat(-5.0f, 5.0f) * kSlop - apart.distance);
    for (geometry::Vertex& vertex : b.vertices) vertex.point += move;
    for (geometry::Face& face : b.faces) face.plane.offset += face.plane.normal.dot(move);
    const Relation relation = relationOf(a, b, Exact(kSlop) + Exact(1e-6f));  // what floats of 1 m can tell
    ++counts[static_cast<int>(relation)];
    if (relation == Relation::Near) continue;
    EXPECT_EQ(isConnected(a, b), relation == Relation::Deep) << i;
  }
  for (const int count : counts) EXPECT_GT(count, 20);
  hard::reportSum("pairs apart as the exact test has them", counts[0]);
  hard::reportSum("pairs deep alike", counts[1]);
}

}  // namespace
}  // namespace brittle::fracture
