// What obstacle scripts ask to be seen: draw(), decals on bodies, and calls that nothing here is drawn by.
#include <gtest/gtest.h>

#include "fixture.h"

namespace brittle::sim {
namespace {

content::MemorySource withThing(const std::string& script) {
  content::MemorySource source = oneRoom("<obstacle pos=\"0.5 1 -10\" type=\"tested\"/>");
  source.add("obstacles/tested.lua", script);
  return source;
}

std::vector<BodyDecal> decalsOf(const Game& game, Vec3* place = nullptr) {
  FramePacket packet;
  game.copyFrame(packet);
  const std::vector<BodyDecal> decals = packet.rooms[0].bodyDecals;
  if (place != nullptr && !decals.empty())
    *place = packet.rooms[0].bodies[decals[0].body].pose.toWorld(decals[0].look.position);
  return decals;
}

const char* const kPaintedPane = R"(
function init()
  mgStatic(2)
  mgForceLimit(0.02)
  pane = mgCreateBody(0, 0, 0)
  mgCreateBox(pane, 0.5, 0.5, 0.02)
end
function tick() mgMove(pane, 0.1 * mgObstacleTime(), 0, 0) end
function draw()
  mgColor(1, 0.5, 0.25, 0.75)
  mgBodyDecal(pane, 21, 0.2, 0.3, 0.1, 0, 0.02, 0, 0, 0.5)
end)";

TEST(ScriptLook, ADecalIsOnItsBodyAfterTheStep) {
  const content::MemorySource source = withThing(kPaintedPane);
  const auto game = newTestGame(source);
  for (int i = 0; i < 30; ++i) {
    game->tick({});
    Vec3 place;
    const std::vector<BodyDecal> decals = decalsOf(*game, &place);
    ASSERT_EQ(decals.size(), 1u) << "one a tick, not one more every tick";
    EXPECT_EQ(decals[0].look.tile, 21);
    EXPECT_EQ(decals[0].look.size, Vec2(0.2f, 0.3f));
    EXPECT_EQ(decals[0].look.color, Vec4(1.0f, 0.5f, 0.25f, 0.75f));
    EXPECT_NEAR(decals[0].look.rotation.angularDistance(rotationAbout(Vec3::UnitZ(), 0.5f)), 0.0f, 1e-4f);
    EXPECT_GT(place.x(), 0.6f) << "0.5 of the obstacle and 0.1 of the decal, and the pane has moved";
  }
  EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
  int asked = 0;
  for (const effects::Demand& demand : game->effects().demands())
    asked += demand.effect == effects::Effect::Decals && demand.who == "obstacles/tested.lua:11" ? 1 : 0;
  EXPECT_EQ(asked, 1);
}

TEST(ScriptLook, ABrokenBodyHasNoDecal) {
  const content::MemorySource source = withThing(kPaintedPane);
  const auto game = newTestGame(source);
  game->tick(throwAt(0.08f, 0.0f));
  play(*game, 60);
  ASSERT_EQ(game->totalBreaks(), 1u);
  EXPECT_TRUE(decalsOf(*game).empty());
}

TEST(ScriptLook, DrawIsPartOfTheState) {
  const content::MemorySource source = withThing("n = 0 function draw() n = n + 1 end");
  const auto game = newTestGame(source);
  const std::uint64_t before = game->stateHash();
  play(*game, 7);
  ByteWriter out;
  game->save(out);
  const auto other = newTestGame(source);
  EXPECT_EQ(other->stateHash(), before);
  ByteReader in(out.bytes());
  ASSERT_TRUE(other->restore(in));
  play(*game, 5);
  play(*other, 5);
  EXPECT_EQ(other->stateHash(), game->stateHash());
}

TEST(ScriptLook, WhatFailsInDrawIsSaidAndPlayGoesOn) {
  for (const char* call : {"mgBodyDecal(7, 1, 1, 1)", "mgBodyDecal(b, 1, 0, 1)", "mgBodyDecal(b, 1)",
                           "mgBodyDecal(b, 1, 1, 1, 1e9, 0, 0)", "mgBodyDecal(b, 1, 0/0, 1)", "nothing()"}) {
    const content::MemorySource source =
        withThing(std::string("function init() mgStatic(1) b = mgCreateBody() mgCreateBox(b, 1, 1, 1) end\n"
                              "function draw() ") +
                  call + " end");
    const auto game = newTestGame(source);
    play(*game, 5);
    EXPECT_EQ(game->problems().size(), 1u) << call;
    EXPECT_TRUE(decalsOf(*game).empty()) << call;
  }
}

TEST(ScriptLook, AButtonShowsWhetherItWaits) {
  const content::MemorySource source = withThing(R"(
function init() button, n = mgCreateButton(0, 0, 0), 0 end
function tick() n = n + 1 mgSetButtonDown(button, n % 10 < 5) end)");
  const auto game = newTestGame(source);
  std::map<std::uint32_t, int> colors;
  for (int i = 0; i < 10; ++i) {
    game->tick({});
    const geometry::MeshPool& pool = *game->meshes(0);
    for (geometry::MeshSlot slot = 0; slot < pool.slotCount(); ++slot)
      if (pool.isAlive(slot) && pool.info(slot).material == static_cast<std::uint16_t>(Look::Stone))
        ++colors[pool.view(slot).vertices[0].color];
  }
  ASSERT_EQ(colors.size(), 2u);
  for (const auto& [color, ticks] : colors) EXPECT_EQ(ticks, 5) << color;
}

TEST(ScriptLook, CallsThatChangeNothingSeenSaySoOnce) {
  const content::MemorySource source = withThing(
      "function init() mgRoundness(0.5) mgShapeChamfer(0.1) mgHideEdges(true) mgTexture(true, 1, 1, 0, 0) end\n"
      "function tick() mgRoundness(1) mgTexture(false) end");
  const auto game = newTestGame(source);
  play(*game, 3);
  ASSERT_EQ(game->problems().size(), 4u);
  EXPECT_NE(game->problems()[0].text.find("obstacles/tested.lua:1: mgRoundness"), std::string::npos)
      << game->problems()[0].text;
}

}  // namespace
}  // namespace brittle::sim
