#include <gtest/gtest.h>

#include "game/sim/game.h"
#include "tests/game/sim/fixture.h"

namespace brittle::sim {
namespace {

bool hasProblem(const Game& game, const std::string& part) {
  for (const Problem& problem : game.problems())
    if (problem.text.find(part) != std::string::npos) return true;
  return false;
}

content::MemorySource withObstacle(const std::string& script, const std::string& parameter = "") {
  content::MemorySource source = oneRoom("<obstacle pos=\"1.5 1 -10\" type=\"tested\" " + parameter + "/>");
  source.add("obstacles/tested.lua", script);
  return source;
}

TEST(Scripts, AnUnknownCallIsReportedAndPlayGoesOn) {
  const content::MemorySource source =
      withObstacle("function init() local b = mgCreateBody() mgCreateBox(b,1,1,1) mgWarpSpace(3) end");
  const auto game = newTestGame(source);
  EXPECT_TRUE(hasProblem(*game, "obstacles/tested.lua:1"));
  const auto problems = game->problems().size();
  play(*game, 200);
  EXPECT_EQ(game->problems().size(), problems);
}

TEST(Scripts, AMisspelledRoomCallLeavesTheRestEmpty) {
  const content::MemorySource source =
      oneRoom("", 100.0f, "mgLength(100) mgSegment(\"test/corridor\", 0) mgObstace(\"box\", 0, 0, -5) mgLength(400)");
  const auto game = newTestGame(source);
  EXPECT_TRUE(hasProblem(*game, "mgObstace"));
  EXPECT_FLOAT_EQ(game->camera().velocity.z(), -100.0f / 32.0f);
}

TEST(Scripts, AnEndlessScriptIsStopped) {
  const content::MemorySource source = withObstacle("function tick() while true do end end");
  const auto game = newTestGame(source);
  play(*game, 10);
  EXPECT_TRUE(hasProblem(*game, "tested"));
}

TEST(Scripts, AMissingObstacleIsNamedWithTheLineThatWantsIt) {
  const content::MemorySource source = oneRoom("\n<obstacle pos=\"0 0 -9\" type=\"nosuch\"/>");
  const auto game = newTestGame(source);
  EXPECT_TRUE(hasProblem(*game, "segments/test/corridor.xml:2"));
}

int countProblems(const Game& game, const std::string& part) {
  int count = 0;
  for (const Problem& problem : game.problems()) count += problem.text.find(part) != std::string::npos ? 1 : 0;
  return count;
}

TEST(Scripts, WhatDoesNotExistIsSaidOnceWithItsPlaceAndPlayGoesOn) {
  content::MemorySource source = oneRoom(
      "<obstacle pos=\"0 0 -9\" type=\"nosuch\"/>\n<obstacle pos=\"0 0 -12\" type=\"nosuch\"/>\n"
      "<box pos=\"0 -5 -3\" size=\"1 1 1\" template=\"notmade\"/>\n<powerup pos=\"0 0 -5\" type=\"wings\"/>\n"
      "<powerup pos=\"0 0 -6\" type=\"wings\"/>\n<obstacle pos=\"0 0.7 -10\" type=\"scoretop\"/>",
      64.0f,
      "\nmgSegment(\"test/corridor\", 0) mgSegment(\"test/gone\", -32) mgSegment(\"test/gone\", -40)\n"
      "mgSegment(\"test/second\", -32) mgPowerUp(\"wings\", 0, 0, -1) mgPowerUp(\"halo\", 0, 0, -1)\n"
      "mgObstacle(\"neither\", 0, 0, -4) mgLength(64)");
  source.add("segments/test/second.xml",
             "<segment size=\"12 10 32\"><box pos=\"0 -5 -3\" size=\"1 1 1\" template=\"notmade\"/></segment>");
  const auto game = newTestGame(source);
  EXPECT_EQ(countProblems(*game, "segments/test/corridor.xml:1: obstacle nosuch"), 1);
  EXPECT_EQ(countProblems(*game, "segments/test/corridor.xml:3: unknown template"), 1);
  EXPECT_EQ(countProblems(*game, "segments/test/corridor.xml:4: power-up wings"), 1);
  EXPECT_EQ(countProblems(*game, "rooms/test/room.lua:2: segment test/gone"), 1);
  EXPECT_EQ(countProblems(*game, "rooms/test/room.lua:3: power-up halo"), 1);
  EXPECT_EQ(countProblems(*game, "rooms/test/room.lua:4: obstacle neither"), 1);
  EXPECT_EQ(game->problems().size(), 6u);
  game->tick(throwAt(0.0f, 0.0f));
  play(*game, 400);
  EXPECT_EQ(game->problems().size(), 6u);
  EXPECT_EQ(game->totalCrystals(), 1u);
}

TEST(Scripts, AStoneIsSeenAndStopsNothing) {
  for (const bool isInSegment : {true, false}) {
    const std::string element =
        "<obstacle pos=\"0 1 -10\" type=\"stone\" param0=\"sizeX=0.6\" param1=\"color=1 0.5 0.25\"/>";
    const content::MemorySource source =
        oneRoom(isInSegment ? element : "", 160.0f,
                std::string("mgSegment(\"test/corridor\", 0) mgLength(160)") +
                    (isInSegment ? "" : " mgObstacle(\"stone\", 0, 1, -10, \"sizeX=0.6\", \"color=1 0.5 0.25\")"));
    const auto game = newTestGame(source);
    EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
    FramePacket packet;
    game->copyFrame(packet);
    int stones = 0;
    for (const PlacedSegment& segment : packet.rooms[0].segments) {
      for (const LookBox& box : segment.look->boxes) {
        if (box.color[0] != Vec3(1.0f, 0.5f, 0.25f)) continue;
        ++stones;
        EXPECT_EQ(box.halfExtents, Vec3(0.6f, 0.5f, 0.5f));
        EXPECT_NEAR(segment.origin.z() + box.center.z(), -10.0f, 1e-5f);
      }
    }
    EXPECT_EQ(stones, 1);
    game->tick(throwAt(0.0f, 0.0f));
    const auto events = play(*game, 30);  // past it, not yet at the floor
    EXPECT_EQ(events.count(EventType::Hit), 0u);
    play(*game, 150);
    EXPECT_EQ(game->totalCrashes(), 0u);
  }
}

TEST(Scripts, BoxesThatDifferHaveLooksOfDifferentNames) {
  const auto game = newTestGame(oneRoom("", 160.0f,
                                        "mgSegment(\"test/corridor\", 0) mgLength(160) mgBox(1, 1, 1, 0, 0, -8)"
                                        " mgBox(1, 1, 1, 2, 0, -8) mgBox(1, 1, 2, 0, 0, -8) mgColor(1, 0, 0)"
                                        " mgBox(1, 1, 1, 0, 0, -8) mgBox(1, 1, 1, 0, 0, -12)"));
  EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
  FramePacket packet;
  game->copyFrame(packet);
  std::multiset<std::string> names;
  for (const PlacedSegment& segment : packet.rooms[0].segments) names.insert(segment.look->name);
  EXPECT_EQ(names.size(), 6u);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 5u);  // the last two differ by their place alone
}

TEST(Scripts, AShapeMovesWithinItsBody) {
  const content::MemorySource source = withObstacle(R"(
function init()
  mgStatic(1)
  b = mgCreateBody(0, 0, 0)
  s = mgCreateBox(b, 0.2, 0.2, 0.2)
  mgTranslateShape(s, 0, 1, 0)
  assert(mgBodyContainsPoint(b, 0, 1, 0) and not mgBodyContainsPoint(b, 0, 0, 0))
  mgTranslateShape(s, 1, 0, 0, true)
  assert(mgBodyContainsPoint(b, 1, 1, 0))
  mgTranslateShape(s, 0, 0.5, 0, false)
  assert(mgBodyContainsPoint(b, 0, 0.5, 0) and not mgBodyContainsPoint(b, 1, 1, 0))
  assert(mgGetShapeBody(s) == b)
end)");
  const auto game = newTestGame(source);
  play(*game, 5);
  EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
}

TEST(Scripts, AShapesMaskDecidesWhatItMeets) {
  for (const char* call : {"", "mgSetShapeMask(s, 0)", "mgSetShapeMask(s, 255, 64)"}) {
    const content::MemorySource source = withObstacle(std::string(R"(
function init()
  mgStatic(1)
  b = mgCreateBody(-1.5, 0, 0)
  s = mgCreateBox(b, 1, 1, 0.1)
  )") + call + "\nend");
    const auto game = newTestGame(source);
    game->tick(throwAt(0.0f, 0.0f));
    const auto events = play(*game, 60);
    EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
    EXPECT_EQ(events.count(EventType::Break), std::string(call).find(", 0)") == std::string::npos ? 1u : 0u) << call;
  }
}

TEST(Scripts, VelocityIsSetForTheBodyAndNotForWhatBrokeOff) {
  // Of all the pieces only the one that goes on as the shape turns as told.
  const content::MemorySource source = withObstacle(R"(
function init()
  mgForceLimit(0.1)
  b = mgCreateBody(-1.5, -1.5, 0)
  s = mgCreateBox(b, 0.6, 0.3, 0.3)
end
function tick()
  local body = mgGetShapeBody(s)
  if body ~= 0 then mgSetAngVel(body, 0, 3, 0) end
end)");
  const auto game = newTestGame(source);
  game->tick(throwAt(0.04f, -0.17f));
  play(*game, 20);
  EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
  EXPECT_GE(game->totalBreaks(), 1u);
  // What it knocks against turns it aside for a tick; what broke off never turns like that.
  int most = 0;
  FramePacket a, b;
  for (int tick = 0; tick < 60; ++tick) {
    game->copyFrame(a);
    game->tick({});
    game->copyFrame(b);
    int turning = 0;
    for (std::size_t i = 0; i < a.rooms[0].bodies.size(); ++i) {
      const BodyPose& before = a.rooms[0].bodies[i];
      const BodyPose& after = b.rooms[0].bodies[i];
      if (before.generation == 0 || before.generation != after.generation) continue;
      // 3 rad/s about Y and nothing else: half the angle of a tick.
      const Vec3 turned = (after.pose.rotation * before.pose.rotation.conjugate()).vec();
      turning += (turned - Vec3(0.0f, 0.025f, 0.0f)).norm() < 0.001f ? 1 : 0;
    }
    EXPECT_LE(turning, 1) << "tick " << tick;
    most = maxOf(most, turning);
  }
  EXPECT_EQ(most, 1);
}

TEST(Scripts, BeatsCountFromTheRoomsDoor) {
  const content::MemorySource source = withObstacle(R"(
local entered = false
function tick()
  local beat = mgGetBeat(0.3)
  local ahead = mgCameraDistance()
  if ahead > 10.001 then assert(beat < 0) end
  if math.abs(ahead - 5) < 0.01 then assert(beat == 1, "beat " .. beat) end
end)");
  const auto game = newTestGame(source);  // 5 m/s: 5 m ahead of what is at 10 m after a second
  play(*game, 100);
  EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
}

TEST(Scripts, WrongArgumentsDoNoHarm) {
  const content::MemorySource source = withObstacle(R"(
function init()
  mgColor("red") end
function tick()
  mgCreateBox(77, 1, 1, 1) end)");
  const auto game = newTestGame(source);
  play(*game, 5);
  EXPECT_GE(game->problems().size(), 1u);
  const char* const calls[] = {"mgCreateBody(0/0)",
                               "mgCreateBox(b, -1, 1, 1)",
                               "mgCreateBox(b, 1e9, 1, 1)",
                               "mgCreateBox(b)",
                               "mgCreateCylinder(b, 0, 1)",
                               "mgCreateMesh(b, 'cow')",
                               "mgMaterial('cheese')",
                               "mgStatic({})",
                               "mgCreateRope(0, 0, 0,0,0, 0,0,0)",
                               "mgCreateHingeJoint(b, 0, 0,0,0, 0,0,0)",
                               "mgMove(b, 1/0, 0, 0)",
                               "mgRotate(nil)",
                               "mgSetVel(3, 1, 1, 1)",
                               "mgGetShapeBody(9)",
                               "mgIsButtonDown(1)",
                               "mgGetPos(0)",
                               "mgRaycast(1, 2, 3)",
                               "mgBodyContainsPoint(b)",
                               "mgIsConnected(b, 5)",
                               "mgTranslateShape(4, 0, 0, 0)",
                               "mgTranslateShape(mgCreateBox(b,1,1,1), 0/0, 0, 0)",
                               "mgTranslateShape(mgCreateBox(b,1,1,1), 1e9, 0, 0)",
                               "mgSetShapeMask(1, 'all')",
                               "mgSetShapeMask()",
                               "mgGetJointBodies(1)",
                               "mgScore()",
                               "mgCreateBody(1e5, 0, 0)",
                               "mgCreateBody(0, 0, 0, 1e7, 0, 0)",
                               "mgCreateBox(b, 1, 1, 1, 1e5, 0, 0)",
                               "mgCreateButton(1e6, 0, 0)",
                               "mgCreateBox(b, 1, 1, 1) mgCreateHingeJoint(b, b, 0,0,0, 0,1,0)",
                               "mgCreateBox(b, 1, 1, 1) mgCreateRope(b, b, 0,0,0, 0,1,0)",
                               "mgCreateBox(b, 1, 1, 1) mgRotate(b, 1e9, 0, 0)",
                               "mgCreateBox(b, 1, 1, 1) mgMove(b, 0, 1e15, 0)",
                               "mgCreateBox(b, 1, 1, 1) mgSetVel(b, 1e4, 0, 0)",
                               "mgRaycast(0, 0, 0, 0, 0, -1e15)",
                               "mgLaser(1e15, 0, 0, 1, 0, 0)"};
  for (const char* call : calls) {
    const content::MemorySource wrong =
        withObstacle(std::string("function init() b = mgCreateBody() ") + call + " end");
    const auto other = newTestGame(wrong);
    play(*other, 5);
    EXPECT_GE(other->problems().size(), 1u) << call;
  }
}

TEST(Scripts, ParametersComeFromTheSegmentOrTheirDefaults) {
  const content::MemorySource source = withObstacle(R"(
function init()
  assert(mgGetFloat("size", 1) == 0.25)
  assert(mgGetFloat("other", 1.5) == 1.5)
  assert(mgGetInt("other", 3) == 3)
  assert(mgGetBool("other", true) == true)
  assert(mgGetString("size", "x") == "0.25")
  local r, g, b = mgGetColor("color", 0.5, 0.25, 1)
  assert(r == 0.5 and g == 0.25 and b == 1)
  assert(mgGetGravity() == 1)
end)",
                                                    "param0=\"size=0.25\"");
  const auto game = newTestGame(source);
  EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
}

TEST(Scripts, RaysFindWallsAndBodiesInTheObstaclesFrame) {
  const content::MemorySource source = withObstacle(R"(
function init()
  local hit, x, y, z = mgRaycast(0, 0, 0, 0, -12, 0, 128)
  assert(hit and math.abs(y + 2) < 0.001 and math.abs(x) < 0.001)
  hit, x = mgRaycast(0, 0, 0, 10, 0, 0, 128)
  assert(hit and math.abs(x - 2.5) < 0.001)
  assert(not mgRaycast(0, 0, 0, 0, 0.1, 0))
  mgStatic(1)
  local b = mgCreateBody(-1, 0, 0)
  mgCreateBox(b, 0.2, 0.2, 0.2)
  assert(mgRaycast(0, 0, 0, -2, 0, 0) == b)
  local px, py, pz = mgGetPos(b)
  assert(math.abs(px + 1) < 0.001 and math.abs(py) < 0.001)
  assert(mgBodyContainsPoint(b, -1.1, 0, 0) and not mgBodyContainsPoint(b, 0, 0, 0))
end)");
  const auto game = newTestGame(source);
  EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
}

TEST(Scripts, AnimatedBodiesGoWhereTheyAreToldNoFasterThanTheyMay) {
  const content::MemorySource source = withObstacle(R"(
function init()
  mgMaterial("door")
  b = mgCreateBody(0, 0, 0)
  mgCreateBox(b, 0.2, 0.2, 0.2)
  n = 0
end
function tick()
  mgMove(b, 1, 0, 0, 10, 3)
  n = n + 1
  local x = mgGetPos(b)
  assert(math.abs(x - math.min(1, (n - 1) * 3 / 60)) < 0.002, "x " .. x .. " at " .. n)
end)");
  const auto game = newTestGame(source);
  play(*game, 60);
  EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
}

TEST(Scripts, AHangingPaneHangs) {
  const content::MemorySource source =
      oneRoom("<obstacle pos=\"0 1.2 -28\" type=\"suspendwindow\" param0=\"width=2\" param1=\"height=2\"/>");
  const auto game = newTestGame(source);
  const auto events = play(*game, 240);
  EXPECT_EQ(events.count(EventType::Break), 0u);
  FramePacket packet;
  game->copyFrame(packet);
  ASSERT_EQ(packet.rooms[0].ropes.size(), 4u);
  for (const RopeView& rope : packet.rooms[0].ropes) {
    EXPECT_NEAR(std::min(rope.from.y(), rope.to.y()), 2.2f, 0.1f);
    EXPECT_NEAR(std::max(rope.from.y(), rope.to.y()), 4.0f, 0.01f);
  }
}

TEST(Scripts, ASegmentThatIsUsedUpGoesOnForEver) {
  const content::MemorySource source = oneRoom(
      "", 100.0f,
      "confSegment('test/corridor', 1, -2147483647) for i = 1, 9 do mgSegment(nextSegment()) end mgLength(100)");
  EXPECT_TRUE(newTestGame(source)->problems().empty());
}

TEST(Scripts, ScriptStateComesBackFromASnapshot) {
  const content::MemorySource source = withObstacle(R"(
local n = 0
list = {}
function init() mgStatic(2) b = mgCreateBody() mgCreateBox(b, 0.2, 0.2, 0.2) end
function tick()
  n = n + 1
  list[n % 7] = math.random()
  mgMove(b, 0, 0.1 * (list[1] or 0) + 0.01 * (n % 10), 0)
end)");
  const auto game = newTestGame(source);
  play(*game, 33);
  ByteWriter out;
  game->save(out);
  const auto other = newTestGame(source);
  ByteReader in(out.bytes());
  ASSERT_TRUE(other->restore(in));
  for (int i = 0; i < 30; ++i) {
    ASSERT_EQ(other->stateHash(), game->stateHash()) << i;
    game->tick({});
    other->tick({});
  }
}

}  // namespace
}  // namespace brittle::sim
