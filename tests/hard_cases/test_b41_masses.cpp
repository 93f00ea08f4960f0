// B41: 1,000 to 32,000 bodies made and removed, in bulk and one by one, in the order they were made, in reverse and at
// random. What one costs grows by at most 1.5 times from 1,000 to 32,000 in a world; no handle reaches another's body;
// another round of the same takes no more memory than the first, and when the world is gone, memory is as before it.
// (While it lives a world keeps its buffers for the next time.)
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <numeric>

#include "engine/core/random.h"
#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"
#include "tests/hard_cases/work.h"
#include "tests/allocations.h"

namespace brittle::physics {
namespace {

/// Boxes on a grid; every second one touches the one before it.
BodyHandle make(World& world, int i, std::uint32_t number) {
  static const geometry::Convex box = geometry::makeBox<float>(Vec3(0.1f, 0.1f, 0.1f));
  const Vec3 place(0.2f * static_cast<float>(i % 2) + 0.7f * static_cast<float>(i / 2 % 16),
                   0.5f * static_cast<float>(i / 32 % 32), 0.5f * static_cast<float>(i / 1024));
  BodyDef def = bodyAt(place);
  def.gravityScale = 0.0f;
  def.userData = number;
  const BodyHandle body = world.createBody(def);
  world.addConvex(body, shapeDef(), box);
  return body;
}

enum class Order { AsMade, Reverse, Random };

std::vector<std::size_t> ordered(std::size_t count, Order order) {
  std::vector<std::size_t> result(count);
  std::iota(result.begin(), result.end(), std::size_t{0});
  if (order == Order::Reverse) std::reverse(result.begin(), result.end());
  Random random(41, count);
  for (std::size_t i = 0; order == Order::Random && i + 1 < count; ++i)
    std::swap(result[i], result[i + random.nextBelow(static_cast<std::uint32_t>(count - i))]);
  return result;
}

void expectEmpty(const World& world) {
  const State& state = world.state();
  EXPECT_EQ(state.bodies.size(), 0u);
  EXPECT_EQ(state.shapes.size(), 0u);
  EXPECT_EQ(state.contacts.size(), 0u);
  EXPECT_EQ(state.meshes.aliveCount(), 0u);
  EXPECT_EQ(state.tree.leafCount(), 0u);
}

/// All made, then all removed.
class Bulk {
 public:
  Bulk(int count, Order order) : removal_(ordered(static_cast<std::size_t>(count), order)) {}
  void makeAll() {
    for (std::size_t i = 0; i < removal_.size(); ++i)
      bodies_.push_back(make(world, static_cast<int>(i), static_cast<std::uint32_t>(i)));
  }
  void removeAll() {
    for (const std::size_t i : removal_) world.destroyBody(bodies_[i]);
    bodies_.clear();
  }
  World world;

 private:
  std::vector<std::size_t> removal_;
  std::vector<BodyHandle> bodies_;
};

/// Seconds a body, for `worlds` of `count` each: every size has as many bodies in all, so that all of them find the
/// processor's caches alike.
double costOf(int worlds, int count, Order order) {
  std::deque<Bulk> all;
  for (int i = 0; i < worlds; ++i) all.emplace_back(count, order);
  double seconds = 0.0;
  for (int round = 0; round < 2; ++round) {  // the first one makes room
    const double start = hard::cpuSeconds();
    for (Bulk& bulk : all) bulk.makeAll();
    seconds = hard::cpuSeconds() - start;
    for (Bulk& bulk : all) bulk.world.step(kTick);
    EXPECT_GE(all.front().world.counters().contacts, static_cast<std::uint32_t>(count) / 2);
    const double then = hard::cpuSeconds();
    for (Bulk& bulk : all) bulk.removeAll();
    seconds += hard::cpuSeconds() - then;
    for (Bulk& bulk : all) expectEmpty(bulk.world);
  }
  return seconds / (worlds * count);
}

TEST(B41, ABodyCostsAsMuchAmongManyAsAmongFew) {
  const int most = hard::counted(8000, 32000);
  std::vector<int> counts;
  for (int count = 1000; count <= most; count *= 2) counts.push_back(count);
  for (const Order order : {Order::AsMade, Order::Reverse, Order::Random}) {
    const hard::Spread spread =
        hard::spreadOf(counts, 3, 1.5, [&](int count) { return costOf(most / count, count, order); });
    EXPECT_LE(spread.ratio(), 1.5) << "order " << static_cast<int>(order);
    hard::reportWorst("most work per body over least", spread.ratio());
    hard::reportWorst("a body costs", spread.least * 1e6, "microseconds");
  }
}

TEST(B41, HandlesReachTheirOwnBodyOrNone) {
  const int rounds = hard::counted(20, 200), count = 1000;
  Random random(41, 7);
  World world;
  std::vector<std::pair<BodyHandle, std::uint32_t>> alive;
  std::vector<BodyHandle> gone;
  std::uint32_t number = 0;
  for (int round = 0; round < rounds; ++round) {
    while (alive.size() < static_cast<std::size_t>(count)) {
      alive.emplace_back(make(world, static_cast<int>(number % 4096), number), number);
      ++number;
    }
    const std::size_t leave = random.nextBelow(static_cast<std::uint32_t>(count));
    while (alive.size() > leave) {  // one by one, at random
      std::swap(alive[random.nextBelow(static_cast<std::uint32_t>(alive.size()))], alive.back());
      world.destroyBody(alive.back().first);
      gone.push_back(alive.back().first);
      alive.pop_back();
    }
    for (const auto& [handle, own] : alive) {
      ASSERT_TRUE(world.isAlive(handle));
      ASSERT_EQ(world.body(handle).userData, own);
      ASSERT_TRUE(world.bodyOf(world.body(handle).firstShape) == handle);
    }
    for (const BodyHandle handle : gone) ASSERT_FALSE(world.isAlive(handle));
  }
  hard::reportSum("bodies made one by one", number);
}

TEST(B41, MemoryReturnsToWhatItWas) {
  const int count = hard::counted(2000, 32000);
  make(*std::make_unique<World>(), 0, 0);  // what is made once and stays
  for (const Order order : {Order::AsMade, Order::Reverse, Order::Random}) {
    const std::size_t before = allocatedBytes();
    {
      Bulk bulk(count, order);
      std::size_t first = 0;
      for (int round = 0; round < 4; ++round) {
        bulk.makeAll();
        bulk.world.step(kTick);
        bulk.removeAll();
        bulk.world.step(kTick);
        bulk.world.meshes().clearDirty();  // as whoever draws it does
        expectEmpty(bulk.world);
        if (round == 0) first = allocatedBytes();
        EXPECT_EQ(allocatedBytes(), first) << "round " << round;
      }
    }
    EXPECT_EQ(allocatedBytes(), before);
    hard::reportWorst("bytes left", static_cast<double>(allocatedBytes()) - static_cast<double>(before));
  }
}

}  // namespace
}  // namespace brittle::physics
