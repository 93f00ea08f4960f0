#include "engine/replay/player.h"

#include <gtest/gtest.h>

#include "engine/replay/compress.h"
#include "tests/engine/replay/toy_simulation.h"

namespace brittle::replay {
namespace {

MakeSimulation toy(std::uint64_t seed, std::uint32_t breakAt = 0) {
  return [=] {
    auto simulation = std::make_unique<ToySimulation>(seed);
    simulation->breakAt = breakAt;
    return simulation;
  };
}

TEST(Player, ARecordedGameVerifies) {
  const Replay replay = toyReplay(200);
  EXPECT_EQ(replay.snapshots.size(), 5u);
  std::uint32_t last = 0, all = 0;
  EXPECT_FALSE(verify(replay, toy(42), [&](std::uint32_t done, std::uint32_t of) {
                 last = done, all = of;
                 return true;
               }).has_value());
  EXPECT_EQ(last, all);
  EXPECT_EQ(all, 200u + 160u) << "the whole run, then from the first snapshot on";
}

TEST(Player, TheFirstTickThatDiffersIsNamed) {
  const Replay replay = toyReplay(200);
  const auto difference = verify(replay, toy(42, 77));
  ASSERT_TRUE(difference.has_value());
  EXPECT_EQ(difference->tick, 77u);
  EXPECT_EQ(difference->fromSnapshot, 0u);
  EXPECT_NE(difference->recorded, difference->replayed);
}

TEST(Player, AnotherSeedDiffersAtOnce) {
  EXPECT_EQ(verify(toyReplay(50), toy(43))->tick, 1u);
}

TEST(Player, AChangedInputDiffersInItsTick) {
  Replay replay = toyReplay(100);
  replay.frames[60].buttons ^= 1;
  EXPECT_EQ(verify(replay, toy(42))->tick, 61u);
}

// The whole run is right, and yet a snapshot that misses something the next tick reads is found.
TEST(Player, ASnapshotThatForgetsSomethingIsFound) {
  const auto difference = verify(toyReplay(200, 40, true), toy(42));
  ASSERT_TRUE(difference.has_value());
  EXPECT_EQ(difference->fromSnapshot, 40u);
  EXPECT_EQ(difference->tick, 41u);
}

TEST(Player, ADamagedSnapshotIsFound) {
  Replay replay = toyReplay(200);
  replay.snapshots[2].block[3] ^= 0x10;
  const auto difference = verify(replay, toy(42));
  ASSERT_TRUE(difference.has_value());
  EXPECT_TRUE(difference->unreadable);
  EXPECT_EQ(difference->tick, 120u);
}

TEST(Player, SeekingGivesTheStateOfTheFullRun) {
  const Replay replay = toyReplay(200);
  ToySimulation simulation(42);
  Player player(replay, simulation);
  for (const std::uint32_t target : {5u, 39u, 40u, 41u, 199u, 80u, 120u, 200u}) {
    ASSERT_TRUE(player.seek(target)) << target;
    EXPECT_EQ(player.tick(), target);
    EXPECT_EQ(simulation.ticks, target);
    EXPECT_EQ(simulation.hash(), replay.hashes[target - 1]) << target;
  }
  EXPECT_TRUE(player.atEnd());
}

TEST(Player, SeekingWhereItCannotGoSaysSo) {
  const Replay replay = toyReplay(100);
  ToySimulation simulation(42);
  Player player(replay, simulation);
  EXPECT_EQ(player.seek(101).error().message, "tick 101 is beyond the replay's 100 ticks");
  ASSERT_TRUE(player.seek(50));
  EXPECT_EQ(player.seek(10).error().message, "no snapshot before tick 10: start the game again");
}

TEST(Player, SeekingRefusesASnapshotThatIsNotTheStateRecordedThere) {
  Replay replay = toyReplay(100);
  ToySimulation other(43);
  other.tick(toyInput(0));
  ByteWriter out;
  other.save(out);
  replay.snapshots[1].size = static_cast<std::uint32_t>(out.bytes().size());
  replay.snapshots[1].block = compress(out.bytes());
  ToySimulation simulation(42);
  Player player(replay, simulation);
  ASSERT_TRUE(player.seek(50)) << "the snapshot of tick 40 is sound";
  const Status status = player.seek(90);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().message, "the snapshot of tick 80 is not the state recorded there: verify the replay");
}

TEST(Player, AnEmptyReplayVerifies) {
  EXPECT_FALSE(verify(toyReplay(0), toy(42)).has_value());
}

}  // namespace
}  // namespace brittle::replay
