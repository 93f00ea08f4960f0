// What effects promise: what is only seen or heard changes no bit, any of them may be off, the order of demands does
// not matter, and a room keeps none that the next one does not ask for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "engine/core/random.h"
#include "fixture.h"
#include "layered_source.h"

namespace brittle::sim {
namespace {

using effects::Effect;
using effects::EffectMask;

GameDef defOf(const std::string& level, std::uint32_t room, EffectMask without) {
  GameDef def;
  def.level = level;
  def.firstRoom = room;
  def.mode = Mode::Zen;
  def.without = without;
  return def;
}

std::uint64_t hashAfter(const content::AssetSource& source, const GameDef& def, int ticks) {
  const auto game = newGame(source, def);
  for (int i = 0; i < ticks; ++i) game->tick(scriptedInput(game->tickCount()));
  EXPECT_EQ(game->totalQuarantined(), 0u);
  EXPECT_EQ(game->tickCount(), static_cast<std::uint64_t>(ticks));
  return game->stateHash();
}

TEST(Effects, WhatIsOnlySeenOrHeardChangesNoBit) {
  const EffectMask seen = effects::maskOf(effects::Kind::Seen), heard = effects::maskOf(effects::Kind::Heard);
  const std::uint64_t whole = hashAfter(shippedAssets(), defOf("first", 0, {}), 150);
  for (const EffectMask without : {seen, heard})
    EXPECT_EQ(hashAfter(shippedAssets(), defOf("first", 0, without), 150), whole) << without.bits();
}

TEST(Effects, AnyOfThemMayBeOffInEveryShippedLevel) {
  Random random(7);
  for (const auto& [level, rooms] : {std::pair{"first", 3u}, {"showroom", 17u}})
    for (std::uint32_t room = 0; room < rooms; ++room) {
      const std::uint64_t bits = random.next();
      SCOPED_TRACE(std::string(level) + " " + std::to_string(room) + " without " + std::to_string(bits));
      hashAfter(shippedAssets(), defOf(level, room, EffectMask::ofBits(static_cast<std::uint32_t>(bits))), 60);
    }
  hashAfter(shippedAssets(), defOf("first", 1, EffectMask::ofBits(~0u)), 60);
}

TEST(Effects, ADemandInEveryOrderGivesTheSameState) {
  std::array<const char*, 4> calls = {"mgReverb(0.5, 1, 0.3) ", "mgSetRotation(1) ", "mgParticles('dust') ",
                                      "mgDepthOfField(8, 4) "};
  std::sort(calls.begin(), calls.end());
  std::uint64_t first = 0;
  do {
    std::string body;
    for (const char* call : calls) body += call;
    const auto source = oneRoom("", 160.0f, body + "mgSegment('test/corridor', 0) mgLength(160)");
    const std::uint64_t hash = hashAfter(source, defOf("test", 0, {}), 20);
    if (first == 0) first = hash;
    ASSERT_EQ(hash, first) << body;
  } while (std::next_permutation(calls.begin(), calls.end()));
}

TEST(Effects, AStageThatBeginsInTheMiddleOfARoomGoesOnAfterASnapshot) {
  auto source = oneRoom("<obstacle pos=\"0 1 -12\" type=\"late\"/>");
  source.add("obstacles/late.lua", R"(
function init()
  mgMaterial("steel")
  a = mgCreateBody(-0.5, 1, 0) mgCreateBox(a, 0.2, 0.2, 0.2)
  b = mgCreateBody(0.5, 1, 0) mgCreateBox(b, 0.2, 0.2, 0.2)
end
function tick()
  if not joint and mgCameraDistance() < 9 then joint = mgCreateBallJoint(a, b, 0, 1, 0) end
end)");
  const auto game = newTestGame(source), again = newTestGame(source);
  play(*game, 20);
  EXPECT_FALSE(game->effects().runs(Effect::Joints));
  play(*game, 60);
  EXPECT_TRUE(game->effects().runs(Effect::Joints));
  ByteWriter out;
  game->save(out);
  ByteReader in(out.bytes());
  ASSERT_TRUE(again->restore(in));
  EXPECT_TRUE(again->effects().runs(Effect::Joints));
  play(*game, 60);
  play(*again, 60);
  EXPECT_EQ(again->stateHash(), game->stateHash());
}

TEST(Effects, ATallPileIsLeftToItselfWhereThatIsSwitchedOff) {
  auto source = oneRoom("<obstacle pos=\"0 -1 -20\" type=\"pile\"/>");
  source.add("obstacles/pile.lua", R"(
function init()
  mgMaterial("steel")
  for i = 1, 12 do mgCreateBox(mgCreateBody(0, 0.2 * i - 0.1, 0), 0.2, 0.1, 0.2) end
end)");
  const auto on = newGame(source, defOf("test", 0, {}));
  const auto off = newGame(source, defOf("test", 0, EffectMask().with(Effect::Stacks)));
  EXPECT_TRUE(on->effects().runs(Effect::Stacks));
  EXPECT_FALSE(off->effects().runs(Effect::Stacks));
  EXPECT_NE(on->stateHash(), off->stateHash());
  for (int ticks = 0; ticks < 2; ++ticks) {
    off->setAccuracy(*physics::preset("balanced"));  // what is switched off stays off
    play(*off, 5);
    EXPECT_EQ(off->world(0)->counters().tallest, 0u);
    EXPECT_FALSE(off->world(0)->accuracy().stacks);
  }
}

TEST(Effects, WhatIsSwitchedOffTakesNothingFromTheAccuracyThatWasAskedFor) {
  const auto game = newGame(shippedAssets(), defOf("first", 0, EffectMask().with(Effect::Stacks).with(Effect::Debris)));
  physics::Accuracy asked = game->accuracy();
  EXPECT_TRUE(asked.stacks);
  EXPECT_EQ(asked.maxDebris, physics::Accuracy().maxDebris);
  ++asked.iterations;
  game->setAccuracy(asked);  // as a slider does
  FramePacket packet;
  game->copyFrame(packet);
  EXPECT_EQ(packet.maxDebris, asked.maxDebris) << "what is only seen keeps its share";
  EXPECT_EQ(game->accuracy().maxDebris, asked.maxDebris);
  EXPECT_EQ(game->world(0)->accuracy().maxDebris, 0);
  EXPECT_EQ(game->world(0)->accuracy().iterations, asked.iterations);
}

TEST(Effects, ARoomKeepsNoneThatTheNextOneDoesNotAskFor) {
  const LayeredSource source({{"levels/two.xml",
                               "<level><room type=\"loud\" length=\"100\"/><room type=\"plain\" "
                               "length=\"100\"/></level>"},
                              {"rooms/loud.lua",
                               "function init() mgReverb(0.5, 1, 0.3) mgEcho(0.4, 0.2, 0.5, 0.3) "
                               "mgSegment('first/hall/crystals', 0) mgLength(20) end"},
                              {"rooms/plain.lua", "function init() mgLength(40) end"}});
  const auto game = newGame(source, defOf("two", 0, {}));
  EXPECT_TRUE(game->effects().runs(Effect::Reverb));
  EXPECT_TRUE(game->effects().runs(Effect::Echo));
  for (int i = 0; i < 3000 && game->roomNumber() == 0; ++i) game->tick({});
  ASSERT_EQ(game->roomNumber(), 1u);
  EXPECT_EQ(game->effects().running(), EffectMask().with(Effect::Fog)) << game->effects().running().bits();
}

}  // namespace
}  // namespace brittle::sim
