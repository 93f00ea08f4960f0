#include "game/content/segment.h"

#include "content_helpers.h"

#include <gmock/gmock.h>

namespace brittle::content {
namespace {

using testing::HasSubstr;
using testing::Not;

class SloppySegment : public testing::Test {
 protected:
  TemplateSet templates_ = readTemplates(dataFile("templates.xml"), "templates.xml");
  Segment segment_ = readSegment(dataFile("segments/yard/sloppy.xml"), "s.xml", templates_);
  std::string problems_ = listed(segment_.problems);
};

TEST_F(SloppySegment, SettingsAreReadAndTemplatesLieUnder) {
  EXPECT_EQ(segment_.size, Vec3(12, 10, 16));
  EXPECT_FLOAT_EQ(segment_.light[0], 0.8f);
  EXPECT_FLOAT_EQ(segment_.light[2], 1.2f);  // from the template
  EXPECT_FLOAT_EQ(segment_.softShadow, 0.9f);
  ASSERT_TRUE(segment_.fogColor);
  EXPECT_EQ((*segment_.fogColor)[5], 1.0f);
}

TEST_F(SloppySegment, BoxesHaveTheirOwnValuesOverTheTemplates) {
  ASSERT_EQ(segment_.boxes.size(), 4u);
  const Box& first = segment_.boxes[0];
  EXPECT_EQ(first.line, 3);
  EXPECT_EQ(first.position, Vec3(-0.5f, 1, -3));
  EXPECT_EQ(first.halfExtents, Vec3(1, 0.25f, 2));
  EXPECT_EQ(first.color[1], Vec3(0.5f, 0.75f, 1));
  EXPECT_EQ(first.tile[2], 7);
  EXPECT_FALSE(first.visible);
  EXPECT_FLOAT_EQ(first.glow, 1.5f);
  const Box& second = segment_.boxes[1];
  EXPECT_EQ(second.color[1], Vec3(0, 1, 0));
  EXPECT_EQ(second.tileRotation, (std::array<int, 3>{1, 3, 2}));
  EXPECT_EQ(second.tileSize, (std::array<float, 3>{1, 2, 3}));
  EXPECT_TRUE(second.visible);
}

TEST_F(SloppySegment, WrongBoxesAreMendedOrLeftOutAndNamed) {
  EXPECT_EQ(segment_.boxes[2].halfExtents, Vec3(1, 1, 1));
  EXPECT_THAT(problems_,
              HasSubstr("s.xml:5: <box> size is negative: its sign is dropped, got '1 1 -1', expected half extents"));
  EXPECT_THAT(problems_, HasSubstr("s.xml:5: unknown template, got 'nowhere'"));
  EXPECT_THAT(problems_, HasSubstr("s.xml:6: <box> pos, got '1 2', expected 3 numbers"));
  EXPECT_THAT(problems_, HasSubstr("s.xml:7: <box> a box without volume is left out"));
  EXPECT_THAT(problems_, HasSubstr("s.xml:8: <box> size, got '1e9 1 1', expected numbers up to 1000000"));
  EXPECT_THAT(problems_, HasSubstr("s.xml:9: <box> size is missing: half extents of 0.5 are used"));
}

TEST_F(SloppySegment, WhatATemplateDoesWrongIsNamedThere) {
  EXPECT_THAT(problems_, HasSubstr("templates.xml:5: <box> tile, got '90', expected whole numbers, 0 to 63"));
  EXPECT_THAT(problems_, HasSubstr("templates.xml:5: <box> reflection, got 'maybe', expected 0 or 1"));
}

TEST_F(SloppySegment, ObstaclesHaveParamsModesAndDifficulty) {
  ASSERT_EQ(segment_.obstacles.size(), 2u);
  const Obstacle& bar = segment_.obstacles[0];
  EXPECT_EQ(bar.type, "bar");
  EXPECT_EQ(bar.line, 10);
  EXPECT_EQ(*bar.find("color"), "0.5 0.75 1");
  EXPECT_EQ(*bar.find("width"), "2");  // the first of the duplicates
  EXPECT_EQ(*bar.find("x"), "a=b");
  EXPECT_EQ(bar.find("depth"), nullptr);
  EXPECT_EQ(bar.modes, kTraining | kClassicAndZen);
  EXPECT_FLOAT_EQ(bar.difficultyMin, 0.25f);
  EXPECT_FLOAT_EQ(bar.difficultyMax, 0.75f);
  EXPECT_EQ(segment_.obstacles[1].modes, kAllModes);
  EXPECT_THAT(problems_, HasSubstr("s.xml:10: duplicate attribute param1: the first counts, got 'width=9'"));
  EXPECT_THAT(problems_, HasSubstr("s.xml:10: <obstacle> param2, got 'nonsense', expected key=value"));
  EXPECT_THAT(problems_, HasSubstr("s.xml:11: <obstacle> type is missing: the element is left out"));
  EXPECT_THAT(problems_, HasSubstr("s.xml:12: <obstacle> pos is missing: 0 0 0 is used"));
}

TEST_F(SloppySegment, DecalsPowerUpsAndWaterAreRead) {
  ASSERT_EQ(segment_.decals.size(), 1u);
  EXPECT_EQ(segment_.decals[0].tile, -2);
  EXPECT_EQ(segment_.decals[0].size, Vec2(2, 3));
  EXPECT_EQ(segment_.decals[0].color, Vec4(1, 1, 1, 0.5f));
  ASSERT_EQ(segment_.powerUps.size(), 1u);
  EXPECT_EQ(segment_.powerUps[0].type, "ballfrenzy");
  ASSERT_EQ(segment_.waters.size(), 1u);
  EXPECT_EQ(segment_.waters[0].halfExtents, Vec2(6, 8));
  EXPECT_EQ(segment_.waters[0].resolution, (std::array<int, 2>{64, 256}));
}

TEST_F(SloppySegment, NothingElseIsWrong) {
  EXPECT_EQ(segment_.problems.size(), 13u) << problems_;
  EXPECT_THAT(problems_, Not(HasSubstr("model")));
}

TEST(Segment, AfterASyntaxErrorReadingGoesOnAtTheNextTag) {
  const Segment segment = readSegment(dataFile("segments/yard/broken.xml"), "b.xml", {});
  const std::string problems = listed(segment.problems);
  std::vector<float> places;
  for (const Box& box : segment.boxes) places.push_back(box.position.z());
  EXPECT_THAT(places, testing::ElementsAre(-1, -2, -5, -6)) << problems;
  ASSERT_FALSE(segment.obstacles.empty());
  EXPECT_EQ(segment.boxes.back().line, 7);
  EXPECT_THAT(problems, HasSubstr("b.xml:3: XML: "));
  EXPECT_THAT(problems, HasSubstr("b.xml:7: XML: "));
  EXPECT_EQ(segment.size, Vec3(12, 10, 8));
}

TEST(Segment, OtherTextsGiveAnEmptySegmentAndAProblem) {
  for (const char* text : {"", "   ", "hello", "<level/>", "\xff\xfe<\0s", "<!--", "<segment"}) {
    const Segment segment = readSegment(text, "e.xml", {});
    EXPECT_FALSE(segment.problems.empty()) << text;
    EXPECT_TRUE(segment.boxes.empty());
    EXPECT_EQ(segment.size, Vec3(12, 10, 16));
  }
}

TEST(Segment, DeepAndRepeatedNonsenseEnds) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<segment>";
  EXPECT_FALSE(readSegment(deep, "d.xml", {}).problems.empty());
  std::string wrong = "<segment size='12 10 16'>";
  for (int i = 0; i < 5000; ++i) wrong += "<box pos=/>";
  EXPECT_LT(readSegment(wrong, "w.xml", {}).problems.size(), 200u);
  std::string many = "<segment size='12 10 16'>";
  for (int i = 0; i < 5000; ++i) many += "<box pos='x'/>";
  EXPECT_EQ(readSegment(many + "</segment>", "m.xml", {}).problems.size(), 1001u);
}

TEST(Segment, WhatNoLevelHoldsIsLeftOut) {
  std::string text = "<segment size=\"1 1 1\">\n";
  for (int i = 0; i < 5001; ++i) text += "<box pos=\"0 0 0\" size=\"1 1 1\"/>\n";
  Segment segment = readSegment(text + "</segment>", "s.xml", {});
  EXPECT_EQ(segment.boxes.size(), 5000u);
  EXPECT_EQ(listed(segment.problems), "s.xml:5002: too many elements: the rest is left out, expected at most 5000\n");
  const std::string value = "a=" + std::string(1000, 'x');
  segment = readSegment(
      "<segment size=\"1 1 1\"><obstacle pos=\"0 0 0\" type=\"o\" param0=\"" + value + "\"/></segment>", "s.xml", {});
  EXPECT_TRUE(segment.obstacles[0].params.empty());
  EXPECT_THAT(listed(segment.problems), HasSubstr("expected at most 1000 bytes"));
}

TEST(Segment, WhatIsTooFarAwayIsLeftOut) {
  const Segment segment = readSegment(
      "<segment size=\"1 1 1\">\n<box pos=\"1e5 0 0\" size=\"1 1 1\"/><box pos=\"1e4 0 0\" size=\"1 1 1\"/></segment>",
      "s.xml", {});
  EXPECT_EQ(segment.boxes.size(), 1u);
  EXPECT_EQ(listed(segment.problems),
            "s.xml:2: <box> pos: the element is left out, got '1e5 0 0', expected numbers up to 10000\n");
}

TEST(Segment, AfterTooManySyntaxErrorsTheRestIsNotRead) {
  std::string text = "<segment size=\"1 1 1\">\n";
  for (int i = 0; i < 100; ++i) text += "</b>\n";
  EXPECT_THAT(listed(readSegment(text, "s.xml", {}).problems),
              HasSubstr("s.xml:53: XML: too many errors, the rest is not read"));
}

TEST(Segment, LegacyAttributesAreUnderstood) {
  const Segment segment = readSegment(
      "<segment size='1 1 1'><box pos='0 0 0' size='1 1 1' tileX='1' tileZ='3' colorY='.1 .2 .3'/></segment>", "l.xml",
      {});
  ASSERT_EQ(segment.boxes.size(), 1u);
  EXPECT_EQ(segment.boxes[0].tile, (std::array<int, 3>{1, 0, 3}));
  EXPECT_EQ(segment.boxes[0].color[1], Vec3(0.1f, 0.2f, 0.3f));
  EXPECT_TRUE(segment.problems.empty());
}

TEST(Segment, CutOrChangedAnywhereItIsStillSound) {
  const TemplateSet templates = readTemplates(dataFile("templates.xml"), "t.xml");
  forEachDamage(dataFile("segments/yard/sloppy.xml"), [&](const std::string& text) {
    const Segment segment = readSegment(text, "f.xml", templates);
    ASSERT_GT(segment.size.minCoeff(), 0.0f);
    for (const Box& box : segment.boxes) ASSERT_TRUE(isFinite(box.position) && box.halfExtents.minCoeff() > 0.0f);
    for (const Obstacle& obstacle : segment.obstacles) ASSERT_FALSE(obstacle.type.empty());
    for (const Water& water : segment.waters) ASSERT_GT(water.halfExtents.minCoeff(), 0.0f);
  });
}

}  // namespace
}  // namespace brittle::content
