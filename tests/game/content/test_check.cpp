#include "game/content/check.h"

#include "content_helpers.h"
#include "game/content/script_names.h"

#include <gmock/gmock.h>

#include <sys/stat.h>

#include <filesystem>
#include <map>
#include <fstream>

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

TEST(Check, TheSameListEveryTime) {
  EXPECT_EQ(listed(checkPath(kData).problems), listed(checkPath(kData).problems));
}

TEST(Check, WhatIsNotThereIsAProblem) {
  EXPECT_EQ(listed(checkPath("/no/such/path").problems), "/no/such/path: there is no such file or folder\n");
}

TEST(Check, AFileThatIsNoContentIsSaidToBeNone) {
  EXPECT_EQ(listed(checkPath(kData + "/../../content_helpers.h").problems).substr(kData.size() - 11),
            "content_helpers.h: not level content, expected a .xml, .lua or .mesh file, or a folder of them\n");
  const std::string pipe = testing::TempDir() + "brittle_pipe.xml";
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(listed(checkPath(pipe).problems), pipe + ": not a file, expected content\n");
  std::filesystem::remove(pipe);
}

TEST(Check, AFaultyTemplateIsListedOnceHoweverItIsReached) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "brittle_pack";
  std::filesystem::create_directories(folder / "segments");
  std::ofstream(folder / "templates.xml")
      << "<templates><template name=\"t\"><properties tile=\"99\"/></template></templates>";
  for (const char* name : {"a.xml", "b.xml"})
    std::ofstream(folder / "segments" / name)
        << "<segment size=\"1 1 1\"><box pos=\"0 0 0\" size=\"1 1 1\" template=\"t\"/></segment>";
  const std::string relative = folder.lexically_relative(std::filesystem::current_path()).string();
  for (const std::string& path : {folder.string(), relative, relative + "/", relative + "/segments/.."})
    EXPECT_EQ(checkPath(path).problems.size(), 1u) << listed(checkPath(path).problems);
  EXPECT_EQ(listed(checkPath(relative + "/segments").problems),
            relative + "/templates.xml:1: <box> tile, got '99', expected whole numbers, 0 to 63\n");
}

TEST(Check, ObstaclesWithoutAScriptAreNamedUnlessTheyBelongToTheFormat) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "brittle_obstacles";
  std::filesystem::remove_all(folder);
  for (const char* name : {"segments", "obstacles/mine"}) std::filesystem::create_directories(folder / name);
  std::ofstream(folder / "obstacles/mine/lamp.lua.mp3") << "function init() end";
  std::ofstream(folder / "segments/a.xml") << "<segment size=\"1 1 1\">\n<obstacle pos=\"0 0 0\" type=\"mine/lamp\"/>\n"
                                              "<obstacle pos=\"0 0 0\" type=\"cactus\"/>\n"
                                              "<obstacle pos=\"0 0 0\" type=\"scorediamnod\"/>\n"
                                              "<obstacle pos=\"0 0 0\" type=\"mine/lmp\"/>\n"
                                              "<obstacle pos=\"0 0 0\" type=\"submarine\" hiden=\"1\"/></segment>";
  const std::string file = (folder / "segments/a.xml").string();
  EXPECT_EQ(listed(checkPath(folder.string()).problems),
            file + ":4: unknown obstacle type, got 'scorediamnod', expected scorediamond\n" +  //
                file + ":5: unknown obstacle type, got 'mine/lmp', expected mine/lamp\n" + file +
                ":6: <obstacle> unknown attribute, got 'hiden', expected hidden\n" + file +
                ":6: unknown obstacle type, got 'submarine', expected a file obstacles/submarine.lua\n");
}

/// A fresh folder with an asset tree in it.
std::filesystem::path treeOf(const std::string& name, const std::map<std::string, std::string>& files) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / name;
  std::filesystem::remove_all(folder);
  for (const auto& [file, text] : files) {
    std::filesystem::create_directories((folder / file).parent_path());
    std::ofstream(folder / file) << text;
  }
  return folder;
}

TEST(Check, WhatLiesInLevelsAndSegmentsIsThatOrAProblem) {
  const std::string noise("\x7f<\x01\xfe\x80 <<\0>\x02", 12), segment = "<segment size=\"1 1 1\"/>";
  const std::string level = "<level><room type=\"r\" length=\"1\"/></level>";
  const std::filesystem::path folder = treeOf("brittle_kinds", {{"levels/deep/noise.xml.mp3", noise},
                                                                {"levels/empty.xml", ""},
                                                                {"levels/good.xml", level},
                                                                {"levels/notes.txt", noise},
                                                                {"levels/wrong.xml", segment},
                                                                {"other/levels/any.xml", "<svg/>"},
                                                                {"other/noise.xml", noise},
                                                                {"rooms/r.lua", ""},
                                                                {"segments/good.xml.gz.mp3", segment},
                                                                {"segments/levels/noise.xml", noise},
                                                                {"segments/wrong.xml", "\n" + level},
                                                                {"templates.xml", "<game/>"}});
  const std::string file = folder.string() + "/";
  const CheckReport report = checkPath(folder.string());
  EXPECT_EQ(listed(report.problems),
            file + "levels/deep/noise.xml.mp3:1: not XML: bytes that are no text, expected <level>\n" +   //
                file + "levels/empty.xml:1: an empty file, expected <level>\n" +                          //
                file + "levels/wrong.xml:1: another kind of file, got '<segment>', expected <level>\n" +  //
                file + "other/noise.xml:1: not XML, expected an element\n" +                              //
                file + "segments/levels/noise.xml:1: not XML: bytes that are no text, expected <segment>\n" + file +
                "segments/wrong.xml:2: another kind of file, got '<level>', expected <segment>\n" +  //
                file + "templates.xml:1: another kind of file, got '<game>', expected <templates>\n");
  EXPECT_EQ(report.skipped, 2) << "the notes and the picture";
  EXPECT_EQ(report.root, folder.string());
  EXPECT_THAT(report.playable, testing::ElementsAre("good"));
  EXPECT_EQ(listed(checkPath(file + "levels/wrong.xml").problems),
            file + "levels/wrong.xml:1: another kind of file, got '<segment>', expected <level>\n");
}

TEST(Check, OnlyAFoldersLevelsArePlayable) {
  const std::filesystem::path folder =
      treeOf("brittle_playable",
             {{"levels/deep/a.xml.mp3", "<level><room type=\"r\" length=\"1\"/></level>"}, {"rooms/r.lua", ""}});
  EXPECT_THAT(checkPath(folder.string()).playable, testing::ElementsAre("deep/a"));
  EXPECT_THAT(checkPath((folder / "levels").string()).playable, testing::ElementsAre("deep/a"));
  EXPECT_THAT(checkPath((folder / "levels/deep/a.xml.mp3").string()).playable, testing::IsEmpty());
  EXPECT_THAT(checkPath((folder / "rooms").string()).playable, testing::IsEmpty());
}

TEST(ScriptNames, NearOnesAreSuggested) {
  EXPECT_TRUE(isScriptCall("mgCreateBody"));
  EXPECT_EQ(nearestScriptCall("mgObstalce"), "mgObstacle");
  EXPECT_EQ(nearestScriptCall("somethingElse"), "");
}

}  // namespace
}  // namespace brittle::content
