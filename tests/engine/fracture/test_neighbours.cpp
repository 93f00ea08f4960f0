#include "engine/fracture/neighbours.h"

#include <gtest/gtest.h>

#include <map>

#include "engine/core/random.h"
#include "engine/geometry/clip.h"
#include "tests/engine/fracture/scene.h"

namespace brittle::fracture {
namespace {

/// Area that two convexes share, from all pairs of their faces.
float sharedArea(const geometry::ConvexView& a, const geometry::ConvexView& b) {
  std::vector<Vec3> polygon, clip;
  float most = 0.0f;
  for (std::uint32_t i = 0; i < a.faces.size(); ++i) {
    for (std::uint32_t k = 0; k < b.faces.size(); ++k) {
      const Plane& p = a.faces[i].plane;
      const Plane& q = b.faces[k].plane;
      if (p.normal.dot(q.normal) > -0.9999f || std::abs(p.offset + q.offset) > 1e-4f) continue;
      geometry::facePolygon(a, i, Transform{}, polygon);
      if (std::abs(q.distance(polygon[0])) > 1e-5f) continue;
      geometry::clipToFace(b, k, Transform{}, clip, polygon);
      if (polygon.size() >= 3) most = maxOf(most, geometry::polygonArea(polygon));
    }
  }
  return most;
}

void expectComplete(const Scene& scene, const Fracture& made) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, const Neighbours*> known;
  for (const Neighbours& pair : made.neighbours) {
    EXPECT_TRUE(known.emplace(std::make_pair(pair.pieceA, pair.pieceB), &pair).second) << "listed once";
  }
  const float least = 0.01f * kSlop * kSlop;
  for (std::uint32_t a = 0; a < made.pieces.size(); ++a) {
    for (std::uint32_t b = a + 1; b < made.pieces.size(); ++b) {
      if (made.pieces[a].group == made.pieces[b].group || made.pieces[a].source != made.pieces[b].source) continue;
      const geometry::ConvexView viewA = viewOf(scene, made, made.pieces[a]),
                                 viewB = viewOf(scene, made, made.pieces[b]);
      const float area = sharedArea(viewA, viewB);
      const auto found = known.find({a, b});
      const bool isBorderline = area > 0.5f * least && area < 2.0f * least;
      EXPECT_TRUE(isBorderline || (found != known.end()) == (area > least))
          << a << ", " << b << " share " << area << " m2";
      if (found == known.end()) continue;
      const Neighbours& pair = *found->second;
      EXPECT_GT(pair.normal.dot(made.pieces[b].mass.center - made.pieces[a].mass.center), 0.0f) << "from A to B";
      for (std::uint32_t i = 0; i < pair.pointCount; ++i) {
        for (const geometry::ConvexView& view : {viewA, viewB}) {
          for (const geometry::Face& face : view.faces) EXPECT_LT(face.plane.distance(pair.points[i]), 1e-5f);
        }
      }
    }
  }
}

TEST(Neighbours, AreThoseOfABruteForceSearch) {
  Fracturer fracturer;
  for (const Pattern pattern : {Pattern::Pane, Pattern::Block, Pattern::Tempered, Pattern::Laminated}) {
    FractureMaterial material;
    material.pattern = pattern;
    material.dieSize = 0.1f;
    const Scene scene = pattern == Pattern::Block ? block() : panesWithSeam();
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      Random random(seed);
      Impact impacts[2] = {straightAt({0.05f, 0.1f, 0.01f}, random.nextFloat(2.0f, 40.0f)),
                           straightAt({0.2f, -0.2f, 0.01f}, random.nextFloat(2.0f, 40.0f))};
      const Fracture& made = fracturer.fracture(scene.parts, {impacts, 1 + seed % 2}, material, kSlop, seed);
      SCOPED_TRACE("pattern " + std::to_string(static_cast<int>(pattern)) + ", seed " + std::to_string(seed));
      expectComplete(scene, made);
      EXPECT_GT(made.neighbours.size(), 0u);
    }
  }
}

TEST(Neighbours, FourCornersSpanThePolygon) {
  std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  Vec3 corners[4];
  ASSERT_EQ(mainCorners(square, Vec3::UnitZ(), corners), 4u);
  EXPECT_NEAR(geometry::polygonArea({corners, corners + 4}), 4.0f, 1e-6f);
}

}  // namespace
}  // namespace brittle::fracture
