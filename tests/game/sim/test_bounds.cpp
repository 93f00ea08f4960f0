// What no level holds is named once with its place and left out, and the game goes on with what there is.
#include <gtest/gtest.h>

#include "game/sim/game.h"
#include "tests/game/sim/fixture.h"

namespace brittle::sim {
namespace {

int countProblems(const Game& game, const std::string& part) {
  int count = 0;
  for (const Problem& problem : game.problems()) count += problem.text.find(part) != std::string::npos ? 1 : 0;
  return count;
}

/// Bodies that are there, those of the segments too.
int bodiesIn(const Game& game) {
  FramePacket packet;
  game.copyFrame(packet);
  int count = 0;
  for (const BodyPose& body : packet.rooms[0].bodies) count += body.generation != 0 ? 1 : 0;
  return count;
}

std::size_t boxesIn(const Game& game) {
  FramePacket packet;
  game.copyFrame(packet);
  std::size_t count = 0;
  for (const PlacedSegment& segment : packet.rooms[0].segments) count += segment.look->boxes.size();
  return count;
}

/// A room script that goes on after what it asked too much of: the length it declares last counts.
std::string andLength(const std::string& body) {
  return body + " mgLength(320)";
}

void expectPlays(Game& game) {
  EXPECT_FLOAT_EQ(game.camera().velocity.z(), -10.0f);
  const float before = game.roomDistance();
  play(game, 30);
  EXPECT_GT(game.roomDistance(), before + 4.0f);
  EXPECT_EQ(game.totalQuarantined(), 0u);
}

constexpr const char* kOneBody = "function init() mgStatic(1) mgCreateBox(mgCreateBody(), .1, .1, .1) end";

TEST(Bounds, ObstaclesBeyondThoseARoomHolds) {
  const content::MemorySource source = withObstacles(
      400, kOneBody,
      andLength(
          "for i = 1, 3 do mgSegment('test/corridor', 0) end for i = 1, 9 do mgObstacle('tested', 3, 1, -20) end"));
  const auto game = newTestGame(source);
  EXPECT_EQ(
      countProblems(*game, "segments/test/corridor.xml:102: more than 500 obstacles in a room: the rest is left out"),
      1);
  EXPECT_EQ(game->problems().size(), 1u);
  expectPlays(*game);
  EXPECT_EQ(bodiesIn(*game), 500 + 3);
}

TEST(Bounds, ARoomFullOfBoxes) {
  const std::string boxes = repeated(1246, "<box pos=\"0 -9 -1\" size=\"1 1 1\"/>");
  const auto game =
      newTestGame(oneRoom(boxes, 0.0f, andLength("for i = 0, 19 do\nmgSegment('test/corridor', -32 * i) end")));
  EXPECT_EQ(
      countProblems(*game, "rooms/test/room.lua:2: more than 10000 boxes and decals in a room: the rest is left out"),
      1);
  EXPECT_EQ(game->problems().size(), 1u);
  expectPlays(*game);
  EXPECT_EQ(boxesIn(*game), 3u * 1250u) << "of eight segments those 70 m ahead are built";
}

TEST(Bounds, BoxesOnOneSpot) {
  const std::string boxes = repeated(396, "<box pos=\"0 -9 -1\" size=\"1 1 1\"/>");
  const auto game = newTestGame(oneRoom(boxes, 0.0f, andLength("for i = 1, 20 do\nmgSegment('test/corridor', 0) end")));
  EXPECT_EQ(countProblems(*game, "rooms/test/room.lua:2: more than 1500 boxes within 8 m: the rest is left out"), 1);
  EXPECT_EQ(game->problems().size(), 1u);
  expectPlays(*game);
  EXPECT_EQ(boxesIn(*game), 1200u);
}

TEST(Bounds, SingleBoxesAndStones) {
  for (const char* call : {"mgBox(1, 1, 1, 0, -9, -i)", "mgObstacle('stone', 0, -9, -i)"}) {
    const auto game = newTestGame(oneRoom("", 0.0f, andLength(std::string("for i = 1, 1100 do\n") + call + " end")));
    EXPECT_EQ(countProblems(*game, "rooms/test/room.lua:2: more than 1000 segments in a room: the rest is left out"),
              1);
    EXPECT_EQ(game->problems().size(), 1u);
    expectPlays(*game);
  }
}

TEST(Bounds, BodiesOfAllObstacles) {
  const auto game = newTestGame(withObstacles(
      20, "function init() mgStatic(1) for i = 1, 200 do mgCreateBox(mgCreateBody(), .1, .1, .1) end end"));
  EXPECT_EQ(countProblems(
                *game,
                "segments/test/corridor.xml:9: obstacle tested: obstacles/tested.lua:1: mgCreateBody: too many bodies"),
            1);
  EXPECT_EQ(game->problems().size(), 1u);
  expectPlays(*game);
  EXPECT_EQ(bodiesIn(*game), 1500 + 1);
}

TEST(Bounds, ShapesOfAllObstacles) {
  const auto game = newTestGame(withObstacles(
      20, "function init() mgStatic(1) local b = mgCreateBody() for i = 1, 400 do mgCreateBox(b, .1, .1, .1) end end"));
  EXPECT_EQ(
      countProblems(
          *game, "segments/test/corridor.xml:9: obstacle tested: obstacles/tested.lua:1: mgCreateBox: too many shapes"),
      1);
  EXPECT_EQ(game->problems().size(), 1u);
  expectPlays(*game);
}

// Each is far from its own bound.
TEST(Bounds, ScriptsThatTakeTheTicksTimeTogether) {
  const auto game =
      newTestGame(withObstacles(100,
                                "n = 0 function init() b = mgCreateBody() mgStatic(2) mgCreateBox(b, .1, .1, .1) end\n"
                                "function tick() n = n + 1 mgMove(b, 0, n, 0) for i = 1, 60000 do end end"));
  play(*game, 10);
  EXPECT_EQ(countProblems(*game, "obstacle tested"), 0);
  EXPECT_EQ(countProblems(*game, "the scripts of a room: more than 2000000 instructions in a tick"), 1);
  EXPECT_EQ(game->problems().size(), 1u);
  expectPlays(*game);
  FramePacket packet;
  game->copyFrame(packet);
  int moved = 0;
  for (const BodyPose& body : packet.rooms[0].bodies)
    moved += body.generation != 0 && body.pose.position.y() > 5.0f ? 1 : 0;
  EXPECT_GT(moved, 5);
  EXPECT_LT(moved, 60);
}

// Making a sandbox takes time too: a crowd of obstacles starts over several ticks.
TEST(Bounds, ObstaclesThatStartTogetherStartOneAfterAnother) {
  const content::MemorySource source = withObstacles(450, kOneBody);
  GameDef def;
  def.level = "test";
  const auto game = newGame(source, def);
  EXPECT_TRUE(game->problems().empty());
  play(*game, 10);
  EXPECT_EQ(bodiesIn(*game), 450 + 1) << "none is forgotten";
}

TEST(Bounds, MemoryOfOneScript) {
  const auto game =
      newTestGame(withObstacles(3, "t = {} function tick() for i = 1, 999 do t[#t + 1] = {1, 2, 3} end end"));
  play(*game, 60);
  EXPECT_EQ(countProblems(*game, "obstacles/tested.lua:1: the memory budget is used up"), 1);
  expectPlays(*game);
}

TEST(Bounds, AScriptLongerThanAnyIsNotRead) {
  const auto game = newTestGame(withObstacles(2, std::string(70'000, ' ')));
  EXPECT_EQ(
      countProblems(
          *game,
          "segments/test/corridor.xml:2: obstacle tested: obstacles/tested.lua: 70000 bytes, expected at most 65536"),
      1);
  EXPECT_EQ(game->problems().size(), 1u);
  expectPlays(*game);
}

// The same rays cost more where more is in their way.
TEST(Bounds, RaysAreChargedForWhatIsInTheirWay) {
  const std::string script = "function tick() for i = 1, 200 do mgRaycast(0, 0, 0, 0, 0, -6) end end";
  for (const int crowd : {0, 400}) {
    content::MemorySource source = oneRoom(
        "<obstacle pos=\"3 1 -20\" type=\"tested\"/>" + repeated(crowd, "<box pos=\"0 -9 -16\" size=\"1 1 16\"/>"),
        320.0f);
    source.add("obstacles/tested.lua", script);
    const auto game = newTestGame(source);
    play(*game, 5);
    EXPECT_EQ(countProblems(*game, "obstacles/tested.lua:1: the budget of 200000 instructions is used up"),
              crowd > 0 ? 1 : 0);
    expectPlays(*game);
  }
}

TEST(Bounds, MoreContentThanAGameReads) {
  content::MemorySource source = oneRoom("", 0.0f, andLength("for i = 1, 12 do mgSegment('big' .. i, 0) end"));
  for (int i = 1; i <= 12; ++i)
    source.add("segments/big" + std::to_string(i) + ".xml",
               "<segment size=\"12 10 16\">" + std::string(7'500'000, ' ') + "</segment>");
  const auto game = newTestGame(source);
  EXPECT_EQ(
      countProblems(
          *game,
          "rooms/test/room.lua:1: segment big9: segments/big9.xml: not read: a game holds at most 67108864 bytes"),
      1);
  EXPECT_EQ(game->problems().size(), 4u);
  expectPlays(*game);
}

// A thousand different names are a thousand problems, of which the first are kept.
TEST(Bounds, EndlesslyManyDifferentProblems) {
  std::string powerUps;
  for (int i = 0; i < 4000; ++i) powerUps += "<powerup pos=\"0 0 0\" type=\"p" + std::to_string(i) + "\"/>";
  const auto game = newTestGame(oneRoom(powerUps, 320.0f));
  EXPECT_EQ(game->problems().size(), rules::kMaxProblems);
  expectPlays(*game);
}

}  // namespace
}  // namespace brittle::sim
