#include "game/sim/material.h"

#include <gtest/gtest.h>

#include "game/sim/constants.h"

namespace brittle::sim {
namespace {

TEST(Material, APaneOfTheFormatHoldsTenTimesItsOwnWeight) {
  const Material glass = *findMaterial(content::builtInMaterials(), "glass");
  const Vec3 extent(4.0f, 2.0f, 0.04f);
  const float mass = extent.prod() * surfaceOf(glass).density;
  EXPECT_GT(breakableOf(glass, extent).strength, 10.0f * mass * rules::kGravity * rules::kTickSeconds);
}

TEST(Material, SheetsCrackRadiallyAndBlocksByPlanes) {
  const Material glass = *findMaterial(content::builtInMaterials(), "glass");
  EXPECT_EQ(breakableOf(glass, Vec3(2.0f, 0.04f, 2.0f)).material.pattern, fracture::Pattern::Pane);
  EXPECT_EQ(breakableOf(glass, Vec3(0.04f, 3.0f, 2.0f)).material.pattern, fracture::Pattern::Pane);
  EXPECT_EQ(breakableOf(glass, Vec3(0.5f, 0.5f, 0.5f)).material.pattern, fracture::Pattern::Block);
  EXPECT_EQ(breakableOf(glass, Vec3(8.0f, 0.14f, 0.14f)).material.pattern, fracture::Pattern::Block);
}

TEST(Material, SteelDoesNotBreak) {
  EXPECT_EQ(breakableOf(*findMaterial(content::builtInMaterials(), "steel"), Vec3::Ones()).strength, 0.0f);
}

TEST(Material, BallsMeetEverythingThatCollidesAtAll) {
  Material material = *findMaterial(content::builtInMaterials(), "glass");
  material.mask = 64;
  EXPECT_NE(surfaceOf(material).mask & rules::kCategoryBall, 0u);
  material.mask = 0;
  EXPECT_EQ(surfaceOf(material).mask, 0u);
}

TEST(Material, UnknownNamesAreNull) {
  EXPECT_FALSE(findMaterial(content::builtInMaterials(), "unobtainium"));
}

}  // namespace
}  // namespace brittle::sim
