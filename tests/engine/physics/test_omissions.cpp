// Nothing is put off, refused or recycled uncounted: each counter is seen to count.
#include <gtest/gtest.h>

#include <limits>

#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

std::uint64_t count(const World& world, Omission omission) {
  return world.counters().omissions[omission];
}

/// A pane of glass that a blow breaks, without a striker as a blast does.
BodyHandle addGlass(World& world, float strength = 1.0f) {
  return addPane(world, Vec3(0.0f, 1.0f, 0.0f), Vec3(0.5f, 0.5f, 0.01f), strength);
}

void breakGlass(World& world, BodyHandle glass) {
  world.breakBody(glass, Vec3(0.0f, 1.0f, 0.0f), -Vec3::UnitZ(), 12.0f, 0.3f);
}

std::size_t piecesIn(const World& world) {
  std::size_t pieces = 0;
  world.forEachBody([&](BodyHandle, const Body& body) { pieces += body.isPiece ? 1 : 0; });
  return pieces;
}

/// All that was ever shed, there or not. [m3]
double shedVolume(const World& world) {
  double volume = world.debris().recycledVolume;
  for (const Crumb& crumb : world.debris().crumbs) volume += static_cast<double>(crumb.volume);
  return volume;
}

TEST(Omissions, BreakingsThatWaitAndWhatWaitsForThem) {
  WorldDef def;
  def.gravity = Vec3::Zero();
  def.accuracy.fractureRounds = 1;
  def.accuracy.fastRounds = 0;
  World world(def);
  for (int i = 0; i < 3; ++i)
    addPane(world, Vec3(0.0f, 0.0f, -0.05f * static_cast<float>(i)), Vec3(0.3f, 0.3f, 0.002f), 0.1f, 0.5f);
  addBall(world, Vec3(0.003f, 0.002f, 0.07f), Vec3(0.0f, 0.0f, -100.0f), 0.05f, 1.0f);
  std::uint64_t held = 0;
  for (int tick = 0; tick < 6; ++tick) {
    world.step(kTick);
    held += world.counters().held;
  }
  EXPECT_GE(held, 1u);
  EXPECT_EQ(count(world, Omission::HeldBreak), held);
  EXPECT_GE(count(world, Omission::StoppedStriker), held);
}

// A blast breaks without a striker; its pieces are pieces too.
TEST(Omissions, PiecesBeyondTheirNumberBecomeCrumbs) {
  WorldDef def;
  def.accuracy.maxBodies = 5;
  World world(def);
  breakGlass(world, addGlass(world));
  const std::size_t before = piecesIn(world);
  ASSERT_GT(before, 5u);
  world.step(kTick);
  EXPECT_EQ(piecesIn(world), 5u);
  EXPECT_EQ(count(world, Omission::RecycledBody), before - 5u);
  EXPECT_GE(world.debris().crumbs.size(), before - 5u);
}

TEST(Omissions, CrumbsBeyondTheirNumberGiveWayWithTheirVolume) {
  WorldDef def;
  def.accuracy.minVolumeScale = 1e6f;
  World many(def);
  breakGlass(many, addGlass(many));
  def.accuracy.maxDebris = 3;
  World few(def);
  breakGlass(few, addGlass(few));
  ASSERT_GT(many.debris().crumbs.size(), 3u);
  EXPECT_EQ(count(many, Omission::RecycledCrumb), 0u);
  EXPECT_EQ(few.debris().crumbs.size(), 3u);
  EXPECT_EQ(count(few, Omission::RecycledCrumb), many.debris().crumbs.size() - 3u);
  EXPECT_NEAR(shedVolume(few), shedVolume(many), 1e-9);
}

TEST(Omissions, RemovedCrumbsLeaveTheRingInOrder) {
  WorldDef def;
  def.accuracy.minVolumeScale = 1e6f;
  def.accuracy.maxDebris = 7;
  World world(def);
  for (int i = 0; i < 3; ++i) {
    breakGlass(world, addGlass(world));
    world.step(kTick);
  }
  ASSERT_EQ(world.debris().crumbs.size(), 7u);
  const double volume = shedVolume(world);
  float middle = 0.0f;
  for (const Crumb& crumb : world.debris().crumbs) middle += crumb.position.x() / 7.0f;
  ASSERT_GT(world.debris().oldest, 0u) << "the ring has turned";
  world.removeCrumbs([&](const Crumb& crumb) { return crumb.position.x() > middle; });
  const std::size_t left = world.debris().crumbs.size();
  ASSERT_GT(left, 0u);
  ASSERT_LT(left, 7u);
  EXPECT_EQ(count(world, Omission::RemovedCrumb), 7u - left);
  EXPECT_NEAR(shedVolume(world), volume, 1e-9);
  EXPECT_EQ(world.debris().oldest, 0u);
  for (std::size_t i = 1; i < left; ++i)
    EXPECT_GE(world.debris().crumbs[i].bornTick, world.debris().crumbs[i - 1].bornTick);
  world.removeCrumbs([](const Crumb&) { return false; });
  EXPECT_EQ(world.debris().crumbs.size(), left);
}

// Rare: of 120 breakings of a block into ten times as many pieces as usual five meet such a cut.
TEST(Omissions, CutsThatNoNumberHolds) {
  std::uint64_t refused = 0;
  for (int seed = 1; seed <= 40; ++seed) {
    WorldDef def;
    def.seed = static_cast<std::uint64_t>(seed);
    def.accuracy.patternDensity = 10.0f;
    World world(def);
    BodyDef block = bodyAt(Vec3::Zero(), BodyType::Static);
    block.breakable.strength = 1.0f;
    block.breakable.material.minVolume = 0.0f;
    block.breakable.material.pattern = fracture::Pattern::Laminated;
    ShapeDef shape = shapeDef(2500.0f);
    shape.anchored = true;
    const BodyHandle glass = addBox(world, block, Vec3(1.0f, 1.0f, 0.3f), shape);
    for (int shot = 0; shot < 3 && world.isAlive(glass); ++shot) {
      const Vec3 point(0.01f * static_cast<float>(seed), 0.02f * static_cast<float>(shot), 0.3f);
      world.breakBody(glass, point, -Vec3::UnitZ(), 40.0f, 0.5f);
      world.step(kTick);
    }
    refused += count(world, Omission::RefusedCut);
  }
  EXPECT_GT(refused, 0u);
  EXPECT_LT(refused, 100u);
}

TEST(Omissions, BodiesWithNumbersThatAreNone) {
  World world;
  const BodyHandle bad = addBall(world, Vec3::Zero(), Vec3::Zero(), 0.1f, 1.0f);
  world.state().bodies[bad].velocity.x() = std::numeric_limits<float>::quiet_NaN();
  world.step(kTick);
  EXPECT_FALSE(world.isAlive(bad));
  EXPECT_EQ(count(world, Omission::QuarantinedBody), 1u);
}

TEST(Omissions, AreListedByNameWhereTheyAreNotZero) {
  Tally<Omission> tally;
  tally.add(Omission::RecycledCrumb, 3);
  tally.add(Omission::HeldBreak);
  std::vector<NamedCount> counts;
  tally.list(counts);
  addUp(counts, counts);
  ASSERT_EQ(counts.size(), 2u);
  EXPECT_STREQ(counts[0].name, "breakings put off");
  EXPECT_EQ(counts[0].count, 2u);
  EXPECT_STREQ(counts[1].name, "crumbs recycled");
  EXPECT_EQ(counts[1].count, 6u);
  EXPECT_STREQ(nameOf(Omission::QuarantinedBody), "bodies quarantined") << "a name for each";
}

}  // namespace
}  // namespace brittle::physics
