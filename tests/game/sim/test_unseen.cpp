// What is taken out because nobody can see it again, and what is not.
#include "game/sim/unseen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/physics/world.h"
#include "tests/game/sim/fixture.h"

namespace brittle::sim {
namespace {

const Vec3 kEye(0.0f, 1.0f, 0.0f);

Mover moverAt(const Vec3& center, const Vec3& velocity = Vec3::Zero()) {
  return {center, velocity, 0.2f, velocity.isZero()};
}

bool isLeavingAt(const Vec3& center, const Vec3& velocity = Vec3::Zero(), bool rolls = false, float gravity = 1.0f) {
  return isLeaving(widestView(kEye, rolls, gravity), moverAt(center, velocity));
}

TEST(Unseen, IsWhatLiesBesideOrBelowEveryPicture) {
  EXPECT_FALSE(isLeavingAt(Vec3(0.0f, 1.0f, -5.0f)));
  EXPECT_FALSE(isLeavingAt(Vec3(3.2f, 1.0f, -5.0f)));  // its edge is seen: 2.9 m are the picture's half width there
  EXPECT_TRUE(isLeavingAt(Vec3(4.2f, 1.0f, -5.0f)));
  EXPECT_TRUE(isLeavingAt(Vec3(-4.2f, 1.0f, -5.0f)));
  EXPECT_FALSE(isLeavingAt(Vec3(0.0f, -5.0f, -5.0f))) << "a phone held upright shows it";
  EXPECT_TRUE(isLeavingAt(Vec3(0.0f, -8.0f, -5.0f)));
  EXPECT_FALSE(isLeavingAt(Vec3(0.0f, 20.0f, -5.0f))) << "its shadow may be seen, and it may fall";
}

TEST(Unseen, IsNotWhatMayComeBack) {
  const Vec3 beside(4.2f, 1.0f, -5.0f), below(0.0f, -8.0f, -5.0f);
  EXPECT_FALSE(isLeavingAt(beside, Vec3(-1.0f, 0.0f, 0.0f)));
  EXPECT_TRUE(isLeavingAt(beside, Vec3(1.0f, 0.0f, 0.0f)));
  EXPECT_FALSE(isLeavingAt(beside, Vec3(1.0f, 0.0f, -4.0f))) << "the picture widens faster than it goes aside";
  EXPECT_TRUE(isLeavingAt(beside, Vec3(1.0f, 0.0f, 4.0f)));
  EXPECT_FALSE(isLeavingAt(below, Vec3(0.0f, 1.0f, 0.0f)));
  EXPECT_TRUE(isLeavingAt(below, Vec3(0.0f, -1.0f, 0.0f)));
  EXPECT_FALSE(isLeavingAt(below, Vec3(0.0f, -1.0f, 0.0f), false, -1.0f)) << "it will be lifted";
}

TEST(Unseen, OfARoomThatTurnsIsWhatNoTurnShows) {
  EXPECT_TRUE(isLeavingAt(Vec3(6.0f, 1.0f, -5.0f), Vec3::Zero(), false));
  EXPECT_FALSE(isLeavingAt(Vec3(6.0f, 1.0f, -5.0f), Vec3::Zero(), true));
  EXPECT_TRUE(isLeavingAt(Vec3(9.0f, 1.0f, -5.0f), Vec3::Zero(), true));
}

// No picture of any shape shows a place of which isLeaving holds: corners of balls at random, against the tangents.
TEST(Unseen, NoWindowShowsIt) {
  Random random(3);
  int leaving = 0;
  for (int i = 0; i < 20'000; ++i) {
    const float x = random.nextFloat(-9.0f, 9.0f), y = random.nextFloat(-12.0f, 4.0f),
                z = random.nextFloat(-12.0f, 1.0f);
    const Vec3 center(x, y, z);
    if (!isLeavingAt(center)) continue;
    ++leaving;
    const Vec3 from = center - kEye;
    for (const float aspect : {0.01f, rules::kNarrowestPicture, 1.0f, 16.0f / 9.0f, 4.0f}) {
      const float wide = Camera{.halfWidthTangent = rules::kHalfWidthTangent}.halfWidthTangentIn(aspect);
      const float high = wide / aspect, depth = -from.z();
      const bool isSeen = std::fabs(from.x()) - wide * depth < 0.2f * std::sqrt(1.0f + wide * wide) &&
                          std::fabs(from.y()) - high * depth < 0.2f * std::sqrt(1.0f + high * high);
      ASSERT_FALSE(isSeen) << center.transpose() << " aspect " << aspect;
    }
  }
  EXPECT_GT(leaving, 2000);
}

TEST(Unseen, ListsGoOnFromTickToTickAndForgetWhatIsSeen) {
  const physics::BodyHandle a{1, 1}, b{2, 1}, again{2, 2};
  std::vector<Unseen> unseen;
  const auto now = [&](std::vector<physics::BodyHandle> bodies) {
    goOn(bodies, 1, unseen);
    std::vector<std::uint32_t> ticks;
    for (const Unseen& one : unseen) ticks.push_back(one.ticks);
    return ticks;
  };
  EXPECT_EQ(now({a}), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(now({a, b}), (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(now({a, b}), (std::vector<std::uint32_t>{2, 1}));
  EXPECT_EQ(now({b}), (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(now({a, again}), (std::vector<std::uint32_t>{0, 0})) << "another body in the same place";
}

/// A standing pane of glass far aside of the way, over a ledge, beyond the picture when a bolt of steel goes through
/// it; `more`: what the script does every tick after that.
content::MemorySource paneAside(const std::string& more = "") {
  content::MemorySource source =
      oneRoom("<box pos=\"12 -1.2 -10\" size=\"5 .2 5\"/><obstacle pos=\"12 0 -10\" type=\"tested\"/>", 32.0f);
  source.add("obstacles/tested.lua", R"(
n = 0
function init()
  mgForceLimit(0.01) mgStatic(1)
  b = mgCreateBody(0, 0, 0)
  s = mgCreateBox(b, 0.6, 0.6, 0.03)
end
function tick()
  n = n + 1
  if mgCameraDistance() < 9.9 and not bolt then
    mgMaterial("steel") mgStatic(0)
    bolt = mgCreateBody(0, 0.1, 2)
    mgCreateBox(bolt, 0.1, 0.1, 0.1)
    mgSetVel(bolt, 0, 1, -40)
    broken = n + 20
  end
  if bolt and n > broken then )" + more + " end\nend");
  return source;
}

std::size_t piecesIn(const Game& game) {
  std::size_t pieces = 0;
  game.world(0)->forEachBody([&](physics::BodyHandle, const physics::Body& body) { pieces += body.isPiece ? 1 : 0; });
  return pieces;
}

struct Aside {
  std::size_t most = 0, left = 0;
  std::uint64_t gone = 0, crumbs = 0;
  std::uint64_t ticksKept = 0;  // from the breaking to the first removal
};

Aside playAside(const content::MemorySource& source) {
  const auto game = newTestGame(source);
  Aside aside;
  std::uint64_t broken = 0;
  for (int tick = 0; tick < 300; ++tick) {
    game->tick({});
    if (broken == 0 && game->totalBreaks() > 0) broken = game->tickCount();
    aside.most = maxOf(aside.most, piecesIn(*game));
    if (aside.ticksKept == 0 && countOf(*game, "pieces out of sight") > 0) aside.ticksKept = game->tickCount() - broken;
  }
  EXPECT_TRUE(game->problems().empty()) << game->problems().front().text;
  aside.left = piecesIn(*game);
  aside.gone = countOf(*game, "pieces out of sight");
  aside.crumbs = countOf(*game, "crumbs removed");
  return aside;
}

TEST(UnseenOfARoom, PiecesAsideAreTakenOutAfterAWhileAndCounted) {
  const Aside aside = playAside(paneAside());
  ASSERT_GT(aside.most, 3u);
  EXPECT_GE(aside.ticksKept, static_cast<std::uint64_t>(rules::kUnseenTicks));
  EXPECT_EQ(aside.left, 0u);
  EXPECT_GT(aside.gone, aside.most / 2) << "the others fell off the ledge";
}

TEST(UnseenOfARoom, WhatAScriptHasANumberForStays) {
  const Aside aside = playAside(paneAside("for x = -6, 6 do mgRaycast(x / 10, 2, 0, x / 10, -2, -4) end"));
  EXPECT_GT(aside.left, 0u);
  EXPECT_LT(aside.left, aside.most);
}

// A block of the level's own lies on what fell down there: taking that out would move it.
TEST(UnseenOfARoom, WhatCarriesSomethingOfTheLevelStays) {
  const Aside aside = playAside(paneAside(
      "if not weight then mgMaterial('wood') weight = mgCreateBody(0, 1, 0) mgCreateBox(weight, 3, 0.1, 3) end"));
  EXPECT_GT(aside.left, 0u);
}

TEST(UnseenOfARoom, GoesOnAlikeAfterASnapshot) {
  const content::MemorySource source = paneAside();
  const auto game = newTestGame(source), again = newTestGame(source);
  while (game->totalBreaks() == 0 && game->tickCount() < 100) game->tick({});
  play(*game, rules::kUnseenTicks / 2);
  ByteWriter out;
  game->save(out);
  ByteReader in(out.bytes());
  ASSERT_TRUE(again->restore(in));
  EXPECT_EQ(again->stateHash(), game->stateHash());
  for (int tick = 0; tick < 2 * rules::kUnseenTicks; ++tick) {
    game->tick({});
    again->tick({});
    ASSERT_EQ(again->stateHash(), game->stateHash()) << tick;
  }
  EXPECT_GT(countOf(*again, "pieces out of sight"), 0u);
}

}  // namespace
}  // namespace brittle::sim
