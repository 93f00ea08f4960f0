// A dry run of a level finds what play would report of it, in every room and without a player.
#include "game/sim/dry_run.h"

#include <gmock/gmock.h>

#include "tests/game/sim/fixture.h"
#include "tests/game/sim/layered_source.h"

namespace brittle::sim {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

DryRun run(const content::AssetSource& source, const std::string& level = "test") {
  return dryRun(source, level, [](std::uint32_t, std::uint32_t) { return true; });
}

TEST(DryRun, FindsNothingInTheShippedLevels) {
  EXPECT_THAT(run(shippedAssets(), "first").problems, IsEmpty());
  EXPECT_THAT(run(shippedAssets(), "showroom").problems, IsEmpty());
  EXPECT_EQ(run(shippedAssets(), "showroom").rooms, 17u);
}

/// A corridor with an obstacle at its end, whose script is this.
content::MemorySource withScript(const std::string& script, const std::string& attributes = "") {
  content::MemorySource source = oneRoom("\n<obstacle pos=\"0 1 -31\" type=\"tested\" " + attributes + "/>", 0.0f,
                                         "for i = 0, 4 do mgSegment('test/corridor', -32 * i) end mgLength(160)");
  source.add("obstacles/tested.lua", script);
  return source;
}

TEST(DryRun, FindsWhatScriptsDoWrong) {
  const std::string at = "segments/test/corridor.xml:2: obstacle tested: obstacles/tested.lua:1: ";
  EXPECT_THAT(run(withScript("function init() local a = nil + 1 end")).problems,
              ElementsAre(at + "attempt to perform arithmetic on a nil value"));
  EXPECT_THAT(run(withScript("function init() while true do end end")).problems,
              ElementsAre(at + "the budget of 200000 instructions is used up"));
  EXPECT_THAT(run(withScript("function tick() mgMove(7, 0, 0, 0) end")).problems,
              ElementsAre(at + "mgMove: no body 7"));
  EXPECT_THAT(run(withScript("function draw() mgLaser() end")).problems, testing::SizeIs(1));
}

TEST(DryRun, FindsWhatRoomsAskForAndIsNotThere) {
  content::MemorySource source = oneRoom("", 0.0f, "mgSegment('test/corridor', 0) mgSegment('nowhere')\nmgGravity(99)");
  EXPECT_THAT(run(source).problems,
              ElementsAre("rooms/test/room.lua:1: segment nowhere: segments/nowhere.xml: there is no such file",
                          "rooms/test/room.lua:2: mgGravity: argument 1 is 99, expected -10 to 10"));
  source = oneRoom("", 0.0f, "while true do end");
  EXPECT_THAT(run(source).problems,
              ElementsAre("levels/test.xml:1: room test/room: rooms/test/room.lua:1: the budget of "
                          "1000000 instructions is used up"));
  EXPECT_THAT(run(source, "none").problems, ElementsAre("levels/none.xml: there is no such file"));
}

TEST(DryRun, FindsWhatOnlyOtherModesHave) {
  constexpr const char* broken = "function init() oops() end";
  for (const char* mode : {"1", "2", "4"})
    EXPECT_THAT(run(withScript(broken, std::string("mode=\"") + mode + "\"")).problems, testing::SizeIs(1)) << mode;
  EXPECT_THAT(run(withScript(broken, "mode=\"16\"")).problems, IsEmpty()) << "nobody plays versus";
}

TEST(DryRun, AHundredTimesTheSameRoomIsPassedThroughThrice) {
  const LayeredSource source({{"levels/long.xml", levelOf(100, "first/hall")}});
  EXPECT_EQ(run(source, "long").rooms, 3u);
}

TEST(DryRun, AnEndlessLevelTakesNoLongerThanALongOne) {
  std::string level = "<level>";
  for (int i = 0; i < 500; ++i) level += "<room type=\"test/room\" length=\"1\" seed=\"" + std::to_string(i) + "\"/>";
  content::MemorySource source = oneRoom("");
  source.add("levels/test.xml", level + "</level>");
  const DryRun ran = run(source);
  EXPECT_GT(ran.rooms, 150u);
  EXPECT_LT(ran.rooms, 300u);
}

TEST(DryRun, EndsWhenItIsTold) {
  const LayeredSource source({{"levels/long.xml", levelOf(20, "first/hall")}});
  std::uint32_t told = 0;
  dryRun(source, "long", [&](std::uint32_t done, std::uint32_t of) {
    EXPECT_EQ(done, told++);
    EXPECT_EQ(of, 60u);
    return told < 2;
  });
  EXPECT_EQ(told, 2u);
}

// Obstacles that take all the time there is to start them wait; the camera waits for them.
TEST(DryRun, ACrowdedRoomIsTriedToItsLastObstacle) {
  std::string crowd;
  for (int i = 0; i < 450; ++i) crowd += "<obstacle pos=\"3 1 -20\" type=\"busy\"/>";
  content::MemorySource source = oneRoom(crowd + "\n<obstacle pos=\"3 1 -20\" type=\"broken\"/>", 160.0f);
  source.add("obstacles/busy.lua", "function init() for i = 1, 150000 do end end");
  source.add("obstacles/broken.lua", "function init() oops() end");
  EXPECT_THAT(run(source).problems, testing::SizeIs(1));
}

}  // namespace
}  // namespace brittle::sim
