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

content::MemorySource withObstacle(const std::string& script) {
  content::MemorySource source = oneRoom("<obstacle pos=\"1.5 1 -10\" type=\"tested\" param0=\"size=0.25\"/>");
  source.add("obstacles/tested.lua", script);
  return source;
}

TEST(Scripts, AnUnknownCallIsReportedAndPlayGoesOn) {
  const content::MemorySource source = withObstacle("function init() local b = mgCreateBody() mgCreateBox(b,1,1,1) mgWarpSpace(3) end");
  const auto game = newTestGame(source);
  EXPECT_TRUE(hasProblem(*game, "tested.lua:1"));
  const auto problems = game->problems().size();
  play(*game, 200);
  EXPECT_EQ(game->problems().size(), problems);
}

TEST(Scripts, AMisspelledRoomCallLeavesTheRestEmpty) {
  const content::MemorySource source = oneRoom("", 100.0f, "mgLength(100) mgSegment(\"test/corridor\", 0) mgObstace(\"box\", 0, 0, -5) mgLength(400)");
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

TEST(Scripts, WrongArgumentsDoNoHarm) {
  const content::MemorySource source = withObstacle(R"(
function init()
  mgColor("red") end
function tick()
  mgCreateBox(77, 1, 1, 1) end)");
  const auto game = newTestGame(source);
  play(*game, 5);
  EXPECT_GE(game->problems().size(), 1u);
  const char* const calls[] = {"mgCreateBody(0/0)", "mgCreateBox(b, -1, 1, 1)", "mgCreateBox(b, 1e9, 1, 1)", "mgCreateBox(b)",
                               "mgCreateCylinder(b, 0, 1)", "mgCreateMesh(b, 'cow')", "mgMaterial('cheese')", "mgStatic({})",
                               "mgCreateRope(0, 0, 0,0,0, 0,0,0)", "mgCreateHingeJoint(b, 0, 0,0,0, 0,0,0)", "mgMove(b, 1/0, 0, 0)",
                               "mgRotate(nil)", "mgSetVel(3, 1, 1, 1)", "mgGetShapeBody(9)", "mgIsButtonDown(1)", "mgGetPos(0)",
                               "mgRaycast(1, 2, 3)", "mgBodyContainsPoint(b)", "mgIsConnected(b, 5)", "mgGetJointBodies(1)", "mgScore()"};
  for (const char* call : calls) {
    const content::MemorySource wrong = withObstacle(std::string("function init() b = mgCreateBody() ") + call + " end");
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
end)");
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
  const content::MemorySource source = oneRoom("<obstacle pos=\"0 1.2 -28\" type=\"suspendwindow\" param0=\"width=2\" param1=\"height=2\"/>");
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
