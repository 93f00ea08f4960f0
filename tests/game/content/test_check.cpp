#include "game/content/check.h"

#include "content_helpers.h"
#include "game/content/script_names.h"

#include <gmock/gmock.h>

namespace brittle::content {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Check, ReadsAWholeFolder) {
  const CheckReport report = checkPath(kData);
  EXPECT_EQ(report.segments, 2);
  EXPECT_EQ(report.levels, 1);
  EXPECT_EQ(report.templates, 1);
  EXPECT_EQ(report.gameLists, 1);
  EXPECT_EQ(report.materials, 1);
  EXPECT_EQ(report.scripts, 2);
  EXPECT_EQ(report.rooms, 4);
  EXPECT_EQ(report.skipped, 1);
  const std::string problems = listed(report.problems);
  EXPECT_THAT(problems, HasSubstr("yard.xml.mp3:3: the room has no script, got 'yard/missing'"));
  EXPECT_THAT(problems, Not(HasSubstr("got 'yard/first'")));
  EXPECT_THAT(problems, HasSubstr("game.xml.mp3:3: there is no such level, got 'nowhere'"));
  EXPECT_THAT(problems, HasSubstr("first.lua.mp3:4: unknown function, got 'mgObstace', expected mgObstacle"));
  EXPECT_THAT(problems, HasSubstr("first.lua.mp3:5: unknown function, got 'mgRandFloat', expected mgRndFloat"));
  EXPECT_THAT(problems, HasSubstr("second.lua:3: ')' expected (to close '(' at line 2) near 'end'"));
  EXPECT_THAT(problems, HasSubstr("sloppy.xml.mp3:5: unknown template, got 'nowhere'"));
}

TEST(Check, ASingleFileFindsTheTemplatesAroundIt) {
  const CheckReport report = checkPath(kData + "/segments/yard/sloppy.xml.mp3");
  EXPECT_EQ(report.segments, 1);
  EXPECT_THAT(listed(report.problems), Not(HasSubstr("got 'pane'")));
}

TEST(Check, TheSameListEveryTime) { EXPECT_EQ(listed(checkPath(kData).problems), listed(checkPath(kData).problems)); }

TEST(Check, WhatIsNotThereIsAProblem) { EXPECT_EQ(listed(checkPath("/no/such/path").problems), "/no/such/path: there is no such file or folder\n"); }

TEST(ScriptNames, NearOnesAreSuggested) {
  EXPECT_TRUE(isScriptCall("mgCreateBody"));
  EXPECT_EQ(nearestScriptCall("mgObstalce"), "mgObstacle");
  EXPECT_EQ(nearestScriptCall("somethingElse"), "");
}

}  // namespace
}  // namespace brittle::content
