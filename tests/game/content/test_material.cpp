#include "game/content/material.h"

#include "content_helpers.h"

#include <cmath>
#include <gmock/gmock.h>

namespace brittle::content {
namespace {

TEST(Material, FourAreBuiltIn) {
  const MaterialTable table = builtInMaterials();
  EXPECT_EQ(table.materials.size(), 4u);
  EXPECT_TRUE(std::isinf(table.find("steel")->forceLimit));
  EXPECT_FLOAT_EQ(table.find("wood")->forceLimit, 0.05f);
  EXPECT_EQ(table.find("glass")->kind, SoundKind::Glass);
  EXPECT_EQ(table.find("door")->mask, 125u);
  EXPECT_EQ(table.find("rubber"), nullptr);
}

TEST(Material, AFileChangesAndAdds) {
  const MaterialTable table = readMaterials(dataFile("materials.xml"), "m.xml");
  EXPECT_FLOAT_EQ(table.find("glass")->forceLimit, 0.25f);
  EXPECT_FLOAT_EQ(table.find("glass")->friction, 0.7f);
  EXPECT_FLOAT_EQ(table.find("ice")->density, 0.9f);
  ASSERT_NE(table.find("jelly"), nullptr);
  EXPECT_EQ(table.find("jelly")->motion, 0);
  EXPECT_EQ(listed(table.problems),
            "m.xml:2: <material> friction, got 'nan', expected 1 number\n"
            "m.xml:4: <material> type, got 'wobbly', expected glass, metal or marble\n"
            "m.xml:4: <material> static, got '7', expected a whole number, 0 to 2\n"
            "m.xml:5: <material> name is missing: the material is left out\n");
}

}  // namespace
}  // namespace brittle::content
