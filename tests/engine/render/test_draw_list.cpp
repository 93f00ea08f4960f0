#include "engine/render/draw_list.h"

#include <gtest/gtest.h>

#include "engine/core/random.h"
#include "engine/geometry/make.h"
#include "engine/geometry/split.h"

namespace brittle::render {
namespace {

using geometry::Convex;

class DrawLists : public ::testing::Test {
 protected:
  DrawLists() { group_.pool = &pool_; }

  geometry::MeshSlot add(const Convex& convex, const Vec3& position, std::uint16_t material = kGlass) {
    const auto body = static_cast<std::uint32_t>(group_.bodies.size());
    group_.bodies.push_back({position, Quat::Identity()});
    const geometry::MeshSlot slot = pool_.add(convex, body, material);
    group_.meshes.push_back({slot, body, material, kWhite});
    return slot;
  }
  const DrawList& build(float farthest = 100.0f) {
    builder_.build(group_, materials_, makeView(camera_, 320, 180), farthest, list_);
    return list_;
  }
  static Convex cube(float half = 0.5f) { return geometry::makeBox<float>(Vec3(half, half, half)); }

  geometry::MeshPool pool_;
  MeshGroup group_;
  Camera camera_;
  std::vector<Material> materials_ = builtInMaterials();
  DrawListBuilder builder_;
  DrawList list_;
};

TEST_F(DrawLists, ShowsOneFaceOfACubeAhead) {
  add(cube(), Vec3(0.0f, 0.0f, -3.0f));
  EXPECT_EQ(build().glass.size(), 6u);  // two triangles
  EXPECT_TRUE(list_.opaque.empty());
}

TEST_F(DrawLists, KeepsCutFacesOfGlassApart) {
  Convex above, below;
  geometry::SplitScratch scratch;
  ASSERT_EQ(geometry::split<float>(cube(), planeThrough(Vec3::Zero(), Vec3::UnitZ()), {}, scratch, above, below),
            geometry::SplitOutcome::Split);
  add(below, Vec3(0.0f, 0.0f, -3.0f));  // the half whose cut looks at the camera
  EXPECT_TRUE(build().glass.empty());
  EXPECT_EQ(list_.cuts.size(), 6u);
}

TEST_F(DrawLists, ShowsTheFarFacesOfDimGlass) {
  add(cube(), Vec3(0.0f, 0.0f, -3.0f), kCrystal);
  EXPECT_EQ(build().glass.size(), 36u);
}

TEST_F(DrawLists, ShowsThreeFacesOfACubeSeenFromItsCorner) {
  add(cube(), Vec3(-1.0f, -1.0f, -3.0f), kMetal);
  EXPECT_EQ(build().opaque.size(), 18u);
  EXPECT_TRUE(list_.glass.empty());
}

TEST_F(DrawLists, TrianglesTurnTheirFrontToTheCamera) {
  add(cube(), Vec3(-1.0f, 0.7f, -3.0f), kMetal);
  const std::vector<std::uint32_t>& indices = build().opaque;
  ASSERT_FALSE(indices.empty());
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    Vec3 p[3];
    for (std::size_t k = 0; k < 3; ++k) p[k] = pool_.vertices()[indices[i + k]].point + group_.bodies[0].position;
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    EXPECT_GT(normal.dot(camera_.position - p[0]), 0.0f);
  }
}

TEST_F(DrawLists, GlassComesFarthestFirst) {
  const geometry::MeshSlot near = add(cube(), Vec3(0.0f, 0.0f, -2.0f));
  const geometry::MeshSlot far = add(cube(), Vec3(0.0f, 0.0f, -8.0f));
  const geometry::MeshSlot middle = add(cube(), Vec3(0.0f, 0.0f, -5.0f));
  const std::vector<std::uint32_t>& indices = build().glass;
  ASSERT_EQ(indices.size(), 18u);
  const auto slotOf = [&](std::size_t i) { return pool_.vertices()[indices[i]].slot; };
  EXPECT_EQ(slotOf(0), far);
  EXPECT_EQ(slotOf(6), middle);
  EXPECT_EQ(slotOf(12), near);
}

TEST_F(DrawLists, LeavesOutWhatCannotBeSeen) {
  add(cube(), Vec3(0.0f, 0.0f, 3.0f));    // behind
  add(cube(), Vec3(9.0f, 0.0f, -3.0f));   // beside
  add(cube(), Vec3(0.0f, 9.0f, -3.0f));   // above
  add(cube(), Vec3(0.0f, 0.0f, -40.0f));  // in the fog
  EXPECT_TRUE(build(25.0f).glass.empty());
  EXPECT_TRUE(list_.edges.empty());
}

TEST_F(DrawLists, SkipsDeadSlotsAndUnknownBodies) {
  const geometry::MeshSlot dead = add(cube(), Vec3(0.0f, 0.0f, -3.0f));
  group_.meshes.push_back({pool_.add(cube(), 77, kGlass), 77, kGlass, kWhite});
  pool_.remove(dead);
  group_.meshes.push_back({1234, 0, kGlass, kWhite});
  EXPECT_TRUE(build().glass.empty());
}

TEST_F(DrawLists, UsesTheLastMaterialForUnknownOnes) {
  add(cube(), Vec3(0.0f, 0.0f, -3.0f), 999);
  EXPECT_FALSE(build().opaque.empty());  // the table ends with the ball's metal
}

TEST_F(DrawLists, DrawsEachEdgeOfGlassOnceAndNoneOfMetal) {
  add(cube(), Vec3(-2.0f, 0.0f, -4.0f));
  add(cube(), Vec3(2.0f, 0.0f, -4.0f), kMetal);
  EXPECT_EQ(build().edges.size(), 12u);
}

TEST_F(DrawLists, MakesFreshCutsBrighterAndHiddenEdgesDimmer) {
  geometry::SplitScratch scratch;
  Convex above, below;
  ASSERT_EQ(geometry::split<float>(cube(), planeThrough(Vec3::Zero(), Vec3::UnitY()), {}, scratch, above, below),
            geometry::SplitOutcome::Split);
  add(above, Vec3(0.0f, -1.0f, -3.0f));  // seen from above: its cut face looks down, away from the camera
  float brightest = 0.0f, dimmest = 1.0f;
  for (const EdgeInstance& edge : build().edges) {
    brightest = maxOf(brightest, edge.strength);
    dimmest = minOf(dimmest, edge.strength);
  }
  const float fresh = materials_[kGlass].edge;
  EXPECT_FLOAT_EQ(brightest, fresh);  // the cut's front edge, on the face towards the camera
  EXPECT_LT(dimmest, 0.3f * fresh);
}

TEST_F(DrawLists, LeavesOutEdgesBetweenFacetsOfASmoothSurface) {
  add(geometry::makeCylinder(0.5f, 0.5f, 24), Vec3(0.0f, 0.0f, -3.0f));
  EXPECT_EQ(build().edges.size(), 48u);  // the two rims, not the 24 upright lines
}

TEST_F(DrawLists, DependOnTheArgumentsOnly) {
  Random random(5);
  for (int i = 0; i < 40; ++i) {
    const float x = random.nextFloat(-2.0f, 2.0f);
    add(cube(0.2f), Vec3(x, 0.0f, -4.0f));  // all at the same depth: ties
  }
  const std::vector<std::uint32_t> first = build().glass;
  DrawListBuilder other;
  DrawList list;
  other.build(group_, materials_, makeView(camera_, 320, 180), 100.0f, list);
  EXPECT_EQ(list.glass, first);
}

}  // namespace
}  // namespace brittle::render
