// What a level tells its scripts and none of them asks for is named before the first tick.
#include <gtest/gtest.h>

#include <algorithm>

#include "fixture.h"

namespace brittle::sim {
namespace {

std::string problemsOf(content::MemorySource source, const std::string& script) {
  source.add("obstacles/tested.lua", script);
  const std::unique_ptr<Game> game = newTestGame(source);
  std::string all;
  for (const Problem& problem : game->problems()) all += problem.text + "\n";
  return all;
}

constexpr const char* kScript =
    "function init() a = mgGetFloat('width', 1) end function tick() b = mgGetFloat('speed', 1) end";

std::string obstacle(const std::string& attributes) {
  return "\n<obstacle pos=\"0 1 -12\" type=\"tested\" " + attributes + "/>";
}

TEST(Unread, AMisspeltParameterOfAnObstacle) {
  EXPECT_EQ(
      problemsOf(oneRoom(obstacle("param4=\"sped=3\" param5=\"width=2\" param6=\"speed=1\"")), kScript),
      "segments/test/corridor.xml:2: a parameter that obstacles/tested.lua never asks for, got 'sped=3', expected "
      "speed\n");
  EXPECT_EQ(problemsOf(oneRoom(obstacle("param0=\"color=1 1 1\"")), kScript),
            "segments/test/corridor.xml:2: a parameter that obstacles/tested.lua never asks for, got 'color=1 1 1', "
            "expected one of width, speed\n");
}

TEST(Unread, OfACallOfARoomsScript) {
  EXPECT_EQ(
      problemsOf(oneRoom("", 0.0f, "mgSegment('test/corridor', 0)\nmgObstacle('tested', 0, 1, -9, 'widht=1')"),
                 kScript),
      "rooms/test/room.lua:2: a parameter that obstacles/tested.lua never asks for, got 'widht=1', expected width\n");
}

TEST(Unread, OfATemplateOnlyWhatLooksMisspelt) {
  content::MemorySource source = oneRoom(obstacle("template=\"glass\""));
  source.add("templates.xml",
             "<templates><template name=\"glass\"><properties param0=\"color=1 1 1\" param1=\"sped=2\"/>"
             "</template></templates>");
  EXPECT_EQ(
      problemsOf(source, kScript),
      "segments/test/corridor.xml:2: a parameter that obstacles/tested.lua never asks for, got 'sped=2', expected "
      "speed\n");
}

TEST(Unread, OfAStone) {
  const std::string stone =
      "\n<obstacle pos=\"0 1 -12\" type=\"stone\" param0=\"sizex=1\" param1=\"nomask=1\" "
      "param2=\"author=me\"/>";
  EXPECT_EQ(problemsOf(oneRoom(stone), kScript),
            "segments/test/corridor.xml:2: a parameter that no stone has, got 'sizex=1', expected sizeX\n");
}

TEST(Unread, AnAttributeOfARoom) {
  content::MemorySource source =
      oneRoom("", 0.0f, "mgSegment('test/corridor', 0) if mgGetFloat('steps', 1) > 0 then helper() end");
  source.add("rooms/include.lua", "function helper() return mgGetBool('dark') end");
  source.add(
      "levels/test.xml",
      "<level>\n<room type=\"test/room\" length=\"1\" start=\"1\" end=\"1\" seed=\"4\" distance=\"2\" steps=\"1\" "
      "dark=\"1\" _mine=\"1\" step=\"2\"/></level>");
  EXPECT_EQ(problemsOf(source, kScript),
            "levels/test.xml:2: an attribute that rooms/test/room.lua never asks for, got 'step=2', expected steps\n");
}

TEST(Unread, NothingIsSaidOfAScriptThatPutsNamesTogether) {
  EXPECT_EQ(problemsOf(oneRoom(obstacle("param0=\"sizeX=1\"")),
                       "function tick() for _, axis in ipairs({'X', 'Y'}) do mgGetFloat('size' .. axis, 1) end end"),
            "");
}

TEST(Unread, ASegmentThatIsPlacedOftenIsNamedOnce) {
  const std::string room = "for i = 0, 4 do mgSegment('test/corridor', -32 * i) end";
  const std::string said = problemsOf(oneRoom(obstacle("param0=\"sped=3\""), 0.0f, room), kScript);
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

}  // namespace
}  // namespace brittle::sim
