#include "game/content/level_names.h"

#include "content_helpers.h"
#include "game/content/nearest.h"

#include <gmock/gmock.h>

#include <filesystem>

namespace brittle::content {
namespace {

using testing::HasSubstr;

std::string unknownIn(const std::string& text, std::string_view root) {
  return listed(unknownNames(text, "a.xml", root));
}

TEST(LevelNames, AMisspelledElementIsNamedWithTheNearestOne) {
  EXPECT_EQ(unknownIn("<segment size=\"1 1 1\">\n<bxo pos=\"0 0 0\"/>\n<obstcale/></segment>", "segment"),
            "a.xml:2: unknown element, got 'bxo', expected one of box, obstacle, decal, powerup, water, model\n"
            "a.xml:3: unknown element, got 'obstcale', expected obstacle\n");
  EXPECT_EQ(unknownIn("<level>\n\n<rom type=\"a\"/></level>", "level"),
            "a.xml:3: unknown element, got 'rom', expected room\n");
  EXPECT_EQ(unknownIn("<game><levels>\n<levle name=\"a\"/></levels></game>", "game"),
            "a.xml:2: unknown element, got 'levle', expected level\n");
  EXPECT_EQ(unknownIn("<templates><template name=\"a\">\n<properites/></template></templates>", "templates"),
            "a.xml:2: unknown element, got 'properites', expected properties\n");
  EXPECT_EQ(unknownIn("<materials>\n<metarial/></materials>", "materials"),
            "a.xml:2: unknown element, got 'metarial', expected material\n");
}

TEST(LevelNames, AMisspelledRootIsNamedAndAnotherKindOfFileLeftAlone) {
  EXPECT_EQ(unknownIn("<segmnet/>", "segmnet"), "a.xml: unknown element, got 'segmnet', expected segment\n");
  EXPECT_EQ(unknownIn("<effects/>", "effects"), "");
}

TEST(LevelNames, AMisspelledAttributeIsNamedWithTheNearestOne) {
  EXPECT_EQ(unknownIn("<segment szie=\"1 1 1\">\n<box pos=\"0 0 0\"\n colour=\"1 1 1\" rotation=\"1\"/></segment>",
                      "segment"),
            "a.xml:1: <segment> unknown attribute, got 'szie', expected size\n"
            "a.xml:3: <box> unknown attribute, got 'colour', expected color\n"
            "a.xml:3: <box> unknown attribute, got 'rotation', expected one of pos, size, hidden, visible, template, "
            "color, tile, tileSize, tileRot, reflection, glow, tileX, tileY, tileZ, colorX, colorY, colorZ\n");
  EXPECT_EQ(unknownIn("<segment><obstacle tpye=\"bar\" parm1=\"a=b\" param12=\"a=b\"/></segment>", "segment"),
            "a.xml:1: <obstacle> unknown attribute, got 'tpye', expected type\n"
            "a.xml:1: <obstacle> unknown attribute, got 'parm1', expected param1\n");
  EXPECT_EQ(
      unknownIn("<templates><template name=\"a\"><properties ligthTop=\"1\"/></template></templates>", "templates"),
      "a.xml:1: <properties> unknown attribute, got 'ligthTop', expected lightTop\n");
  EXPECT_EQ(unknownIn("<materials><material name=\"a\" desnity=\"1\"/></materials>", "materials"),
            "a.xml:1: <material> unknown attribute, got 'desnity', expected density\n");
}

TEST(LevelNames, WhatEditorsAndAuthorsMarkAsTheirsIsLeftAlone) {
  EXPECT_EQ(unknownIn("<segment qt-music=\"1\" drm=\"1\" shbt-meta-author=\"x\"><box pos=\"0 0 0\" mb-glow=\"1\" "
                      "_importIgnore=\"1\" shbt-ignore=\"1\" tileX=\"1\" colorZ=\"1 1 1\"/>"
                      "<obstacle type=\"bar\" IMPORT_IGNORE=\"1\" group=\"1\"/><IMPORT_IGNORE/><model/></segment>",
                      "segment"),
            "");
  EXPECT_EQ(unknownIn("<level><room type=\"a\" rrdifficulty=\"3\" mine=\"x\"/></level>", "level"), "");
}

TEST(LevelNames, TheNearestIsNeverFurtherThanHalfTheName) {
  const std::string_view known[] = {"pos", "size", "resolution"};
  EXPECT_EQ(nearestOf("ops", known), "");
  EXPECT_EQ(nearestOf("po", known), "pos");
  EXPECT_EQ(nearestOf("sise", known), "size");
  EXPECT_EQ(nearestOf("resoltuion", known), "resolution");
  EXPECT_EQ(nearestOf(std::string(200, 's'), known), "");
}

TEST(LevelNames, EveryShippedObstacleIsKnown) {
  int count = 0;
  const std::filesystem::path folder = BRITTLE_SOURCE_DIR "/assets/obstacles";
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
    if (file.path().extension() != ".lua") continue;
    const std::string type = file.path().lexically_relative(folder).replace_extension().generic_string();
    EXPECT_TRUE(isKnownObstacle(type)) << type;
    ++count;
  }
  EXPECT_GT(count, 5);
}

TEST(LevelNames, AMisspelledObstacleIsMeantToBeTheNearestOfTheFormatOrOfThePack) {
  EXPECT_EQ(nearestObstacle("scoretpo", {}), "scoretop");
  EXPECT_EQ(nearestObstacle("mine/chandeleer", {"mine/chandelier"}), "mine/chandelier");
  EXPECT_EQ(nearestObstacle("somethingelse", {}), "");
}

}  // namespace
}  // namespace brittle::content
