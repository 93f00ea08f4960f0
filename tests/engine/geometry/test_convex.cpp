#include "engine/geometry/convex.h"

#include <gtest/gtest.h>

#include "engine/core/random.h"
#include "engine/geometry/make.h"
#include "engine/geometry/make_impl.h"

namespace brittle::geometry {
namespace {

Convex fromLoops(std::uint32_t vertexCount, const std::vector<std::vector<std::uint32_t>>& faces) {
  Convex convex;
  convex.vertices.resize(vertexCount);
  make_detail::Loops loops;
  for (const std::vector<std::uint32_t>& face : faces) {
    loops.corners.insert(loops.corners.end(), face.begin(), face.end());
    loops.close();
  }
  EXPECT_TRUE(make_detail::linkLoops(loops, convex));
  return convex;
}

TEST(Convex, BoxIsValid) {
  const Convex box = makeBox<float>(Vec3(1.0f, 2.0f, 3.0f));
  EXPECT_STREQ(findTopologyError(box.view()), nullptr);
  EXPECT_EQ(convexityError(box), 0.0f);
  EXPECT_EQ(extentOf(box.view()), 6.0f);
}

TEST(Convex, NoIndexOfAHalfEdgeCanBeWrongUnnoticed) {
  const Convex box = makeBox<float>(Vec3::Ones());
  const auto count = static_cast<std::uint16_t>(box.edges.size());
  for (std::uint16_t i = 0; i < count; ++i) {
    for (std::uint16_t value = 0; value <= count; ++value) {
      for (std::uint16_t Edge::*field : {&Edge::face, &Edge::vertex, &Edge::next, &Edge::opposite}) {
        Convex broken = box;
        if (broken.edges[i].*field == value) continue;
        broken.edges[i].*field = value;
        EXPECT_NE(findTopologyError(broken.view()), nullptr) << i << " " << value;
      }
    }
  }
}

TEST(Convex, FacesMustEnterTheirOwnLoop) {
  const Convex box = makeBox<float>(Vec3::Ones());
  for (std::uint16_t value = 0; value <= box.edges.size(); ++value) {
    Convex changed = box;
    changed.faces[0].edge = value;
    const bool isOwn = value < box.edges.size() && box.edges[value].face == 0;
    EXPECT_EQ(findTopologyError(changed.view()) == nullptr, isOwn) << value;
  }
}

TEST(Convex, RefusesAVertexOfDegreeTwo) {
  // A tetrahedron with a vertex in the middle of the edge 0-1.
  const Convex mesh = fromLoops(5, {{0, 2, 1, 4}, {0, 4, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  EXPECT_STREQ(findTopologyError(mesh.view()), "a vertex has fewer than 3 edges");
}

TEST(Convex, RefusesFacesThatMeetTwice) {
  // Two pairs of triangles, joined at the vertices 0 and 1 alone: without these two the graph falls apart.
  const Convex mesh = fromLoops(6, {{0, 2, 3}, {1, 3, 2}, {0, 4, 5}, {1, 5, 4}, {0, 3, 1, 4}, {0, 5, 1, 2}});
  EXPECT_STREQ(findTopologyError(mesh.view()), "two faces meet more than once");
}

TEST(Convex, RefusesTwoSolidsInOneMesh) {
  const Convex mesh =
      fromLoops(8, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {4, 7, 6}});
  EXPECT_STREQ(findTopologyError(mesh.view()), "Euler's identity fails");
}

TEST(Convex, RefusesMeshesTooSmallOrTooLarge) {
  EXPECT_STREQ(findTopologyError(Convex().view()), "fewer than 4 vertices or faces");
  Convex large;
  large.edges.resize(kMaxHalfEdges + 1);
  EXPECT_STREQ(findTopologyError(large.view()), "more half-edges than 16 bits count");
}

TEST(Convex, PackedNormalsComeBack) {
  Random random(1);
  EXPECT_EQ(unpackNormal(0), Vec3(Vec3::Zero()));
  for (int i = 0; i < 10000; ++i) {
    const float x = random.nextFloat(-1.0f, 1.0f);
    const float y = random.nextFloat(-1.0f, 1.0f);
    const float z = random.nextFloat(-1.0f, 1.0f);
    const Vec3 normal = normalizedOr(Vec3(x, y, z), Vec3::UnitX());
    const std::uint32_t packed = packNormal(normal);
    EXPECT_NE(packed, 0u);
    EXPECT_LT((unpackNormal(packed) - normal).norm(), 0.008f);
  }
}

TEST(Convex, AxisNormalsPackExactly) {
  for (int i = 0; i < 3; ++i) {
    for (const float sign : {1.0f, -1.0f}) {
      Vec3 axis = Vec3::Zero();
      axis[i] = sign;
      EXPECT_EQ(unpackNormal(packNormal(axis)), axis);
    }
  }
}

TEST(Convex, ConvexityErrorIsTheHeightOfADent) {
  Convex box = makeBox<float>(Vec3::Ones());
  box.vertices[7].point.y() += 0.25f;
  EXPECT_EQ(convexityError(box), 0.25f);
}

}  // namespace
}  // namespace brittle::geometry
