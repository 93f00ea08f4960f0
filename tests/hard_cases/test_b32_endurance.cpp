// B32: 10,000 panes are shot one after another, a tick each, in a world that keeps at most 500 pieces and 500 crumbs.
// There are never more; once warm its memory stays within 1 %; the broad phase's tree is never higher than 2 log2 n.
#include <gtest/gtest.h>

#include <cmath>
#include <deque>

#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"
#include "tests/allocations.h"

namespace brittle::physics {
namespace {

constexpr std::int32_t kCap = 500;

/// A floor, and places for panes above it.
class Range {
 public:
  Range() : world(definition()) { addFloor(world); }
  /// A pane and a ball that breaks it within the tick; those of a second ago are taken away.
  void shoot(int i) {
    const Vec3 place(1.5f * static_cast<float>(i % 7 - 3), 1.0f + 0.1f * static_cast<float>(i % 3),
                     1.5f * static_cast<float>(i / 7 % 7 - 3));
    panes_.push_back(addPane(world, place, Vec3(0.4f, 0.4f, 0.005f), 1.9f));
    balls_.push_back(addBall(world, place + Vec3(0.03f, 0.02f, 0.1f), Vec3(0.0f, 0.0f, -20.0f), 0.05f, 1.0f));
    world.step(kTick);
    world.meshes().clearDirty();  // as whoever draws it does: what is to be uploaded would pile up
    if (panes_.size() <= 10) return;
    for (std::deque<BodyHandle>* list : {&panes_, &balls_}) {
      if (world.isAlive(list->front())) world.destroyBody(list->front());
      list->pop_front();
    }
  }
  std::int32_t pieces() const {
    std::int32_t count = 0;
    world.forEachBody([&](BodyHandle, const Body& body) {
      count += body.isDynamic() && world.shape(body.firstShape).isPiece ? 1 : 0;
    });
    return count;
  }
  World world;

 private:
  static WorldDef definition() {
    WorldDef def;
    def.accuracy.maxBodies = kCap;
    def.accuracy.maxDebris = kCap;
    return def;
  }
  std::deque<BodyHandle> panes_, balls_;
};

TEST(B32, TenThousandBreaksLeaveAWorldNoLarger) {
  const int breaks = hard::counted(800, 10000);
  const int warm = hard::counted(600, 2000);
  Range range;
  std::int32_t mostPieces = 0;
  std::size_t mostCrumbs = 0, start = 0, least = 0, most = 0;
  double steepest = 0.0;
  for (int i = 0; i < breaks; ++i) {
    range.shoot(i);
    ASSERT_GE(range.world.counters().breaks, 1u) << "shot " << i;
    mostPieces = maxOf(mostPieces, range.pieces());
    mostCrumbs = maxOf(mostCrumbs, range.world.debris().crumbs.size());
    const DynamicTree& tree = range.world.state().tree;
    if (tree.leafCount() > 8) steepest = maxOf(steepest, tree.height() / std::log2(double(tree.leafCount())));
    if (i == warm) start = least = most = allocatedBytes();
    if (i < warm) continue;
    least = minOf(least, allocatedBytes());
    most = maxOf(most, allocatedBytes());
  }
  EXPECT_LE(mostPieces, kCap);
  EXPECT_GE(mostPieces, kCap * 9 / 10) << "the cap is reached";
  EXPECT_LE(mostCrumbs, static_cast<std::size_t>(kCap));
  EXPECT_LT(steepest, 2.0);
  EXPECT_LE(static_cast<double>(most), 1.01 * static_cast<double>(start));
  EXPECT_GE(static_cast<double>(least), 0.99 * static_cast<double>(start));
  hard::reportSum("breaks", static_cast<double>(range.world.counters().totalBreaks));
  hard::reportWorst("pieces at most", mostPieces);
  hard::reportWorst("memory changed by", 100.0 * static_cast<double>(most - least) / static_cast<double>(start), "%");
  hard::reportWorst("tree height / log2 n", steepest);
}

}  // namespace
}  // namespace brittle::physics
