#include "game/view/shadows.h"

#include <gtest/gtest.h>

#include "engine/geometry/make.h"

namespace brittle::view {
namespace {

struct Caster {
  geometry::MeshPool pool;
  render::MeshGroup group;
  std::vector<render::Material> materials = render::builtInMaterials();

  Caster(const Vec3& half, const Transform& pose, std::uint16_t material) {
    group.pool = &pool;
    group.bodies.push_back(pose);
    group.meshes.push_back({pool.add(geometry::makeBox<float>(half), 0, material), 0, material, render::kWhite});
  }
  std::vector<render::Shadow> shadows(float strength = 1.0f) {
    std::vector<render::Shadow> result;
    addShadows(group, materials, strength, result);
    return result;
  }
};

TEST(Shadows, AreAsWideAndDeepAsTheBodyHoweverItIsTurned) {
  for (const float turn : {0.0f, 0.7f, 2.5f}) {
    Caster pane(Vec3(1.0f, 0.8f, 0.05f), {Vec3(0.5f, 2.0f, -4.0f), rotationAbout(Vec3::UnitY(), turn)}, render::kMetal);
    const std::vector<render::Shadow> seen = pane.shadows();
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_LT((seen[0].position - Vec3(0.5f, 1.2f, -4.0f)).norm(), 1e-4f);  // under its lower edge
    EXPECT_LT((seen[0].halfSize - Vec2(1.0f, 0.05f)).norm(), 1e-4f);
    const Vec3 along = rotationAbout(Vec3::UnitY(), seen[0].turn) * Vec3::UnitX();
    EXPECT_NEAR(std::fabs(along.dot(rotationAbout(Vec3::UnitY(), turn) * Vec3::UnitX())), 1.0f, 1e-4f);
  }
}

TEST(Shadows, OfAPillarFollowItsOtherAxis) {
  const Quat upright = rotationAbout(Vec3::UnitZ(), 1.5707963f);
  Caster pillar(Vec3(1.0f, 0.2f, 0.3f), {Vec3::Zero(), rotationAbout(Vec3::UnitY(), 0.4f) * upright}, render::kMetal);
  const std::vector<render::Shadow> seen = pillar.shadows();
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_LT((seen[0].halfSize - Vec2(0.2f, 0.3f)).norm(), 1e-4f);
}

TEST(Shadows, AreNotMadeWhereTheSegmentHasNone) {
  Caster pane(Vec3(1.0f, 0.8f, 0.05f), {Vec3::Zero(), Quat::Identity()}, render::kMetal);
  EXPECT_TRUE(pane.shadows(0.0f).empty());
}

TEST(Shadows, OfGlassAreLighter) {
  const Transform pose{Vec3::Zero(), Quat::Identity()};
  Caster glass(Vec3(0.3f, 0.3f, 0.3f), pose, render::kGlass), metal(Vec3(0.3f, 0.3f, 0.3f), pose, render::kMetal);
  EXPECT_LT(glass.shadows()[0].opacity, 0.7f * metal.shadows()[0].opacity);
  EXPECT_FLOAT_EQ(metal.shadows(0.5f)[0].opacity, 0.5f * metal.shadows()[0].opacity);
}

TEST(Shadows, OfCrumbsAndWallsAreLeftOut) {
  const Transform pose{Vec3::Zero(), Quat::Identity()};
  EXPECT_TRUE(Caster(Vec3(0.04f, 0.04f, 0.04f), pose, render::kMetal).shadows().empty());
  EXPECT_TRUE(Caster(Vec3(4.0f, 0.1f, 4.0f), pose, render::kMetal).shadows().empty());
}

}  // namespace
}  // namespace brittle::view
