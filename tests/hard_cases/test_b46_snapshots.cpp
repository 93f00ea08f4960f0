// B46: each shipped replay is played once, and a snapshot taken at 100 random ticks. Restored, each goes on to the same
// hashes to the end as the game that was never interrupted: in a game just made and in one that has played something
// else, in memory that comes filled with 0xff (no number), 0x5a or 0x00, so that nothing is read that is not in the
// snapshot. (That other builds restore and go on alike: tools/cross_hash.)
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "engine/core/random.h"
#include "game/content/asset_source.h"
#include "tests/hard_cases/case.h"
#include "tests/allocations.h"
#include "tools/brittle/game.h"

namespace brittle::program {
namespace {

/// Memory that comes filled, while it lives.
struct Poison {
  explicit Poison(int byte) { fillAllocations(byte); }
  ~Poison() { fillAllocations(-1); }
  Poison(const Poison&) = delete;
  Poison& operator=(const Poison&) = delete;
};

/// A replay, the hash after each of its ticks, and snapshots after some.
struct Played {
  replay::Replay replay;
  std::vector<std::uint64_t> hashes;
  std::vector<std::pair<std::uint32_t, std::vector<unsigned char>>> snapshots;
};

class B46 : public testing::TestWithParam<const char*> {
 protected:
  std::unique_ptr<GameSimulation> newGame() {
    auto game = openReplay(assets_, played_.replay, GetParam());
    EXPECT_TRUE(static_cast<bool>(game)) << game.error().message;
    return game ? std::move(*game) : nullptr;
  }
  /// A game that has gone on from its start in another way than the replay.
  std::unique_ptr<GameSimulation> usedGame() {
    auto game = newGame();
    for (std::uint32_t i = 0; i < 240; ++i) {
      replay::InputFrame input;
      if (i % 12 == 3) input.throws.push_back(replay::quantizeAim(0.01f * static_cast<float>(i % 37) - 0.2f, 0.02f));
      game->tick(input);
    }
    return game;
  }
  void play(int snapshots, std::uint32_t ticks) {
    Random random(46, snapshots);
    std::set<std::uint32_t> at;
    while (at.size() < static_cast<std::size_t>(snapshots)) at.insert(1 + random.nextBelow(ticks - 1));
    const auto game = newGame();
    for (std::uint32_t tick = 0; tick < ticks; ++tick) {
      game->tick(played_.replay.frames[tick]);
      played_.hashes.push_back(game->hash());
      if (!at.contains(tick + 1)) continue;
      ByteWriter out;
      game->save(out);
      played_.snapshots.emplace_back(tick + 1, out.bytes());
    }
  }
  void expectTheSameFrom(std::size_t which, std::uint32_t most) {
    constexpr int kFills[] = {0xff, 0x5a, 0x00};
    const auto& [tick, bytes] = played_.snapshots[which];
    SCOPED_TRACE("snapshot of tick " + std::to_string(tick));
    const Poison poison(kFills[which % 3]);
    const auto game = which % 2 == 0 ? newGame() : usedGame();
    ByteReader in(bytes);
    ASSERT_TRUE(game->restore(in));
    ASSERT_EQ(game->hash(), played_.hashes[tick - 1]);
    const std::uint32_t end = std::min(tick + most, static_cast<std::uint32_t>(played_.hashes.size()));
    for (std::uint32_t next = tick; next < end; ++next) {
      game->tick(played_.replay.frames[next]);
      ASSERT_EQ(game->hash(), played_.hashes[next]) << "differs first after tick " << next + 1;
    }
    hard::reportSum("snapshots", 1);
    hard::reportSum("ticks alike", end - tick);
  }

  content::FolderSource assets_{std::vector<std::string>{BRITTLE_SOURCE_DIR "/assets"}};
  Played played_;
};

TEST_P(B46, GoOnAsIfNeverInterrupted) {
  auto loaded = loadReplay(std::string(BRITTLE_SOURCE_DIR "/assets/replays/") + GetParam());
  ASSERT_TRUE(static_cast<bool>(loaded)) << loaded.error().message;
  played_.replay = std::move(*loaded);
  ASSERT_NE(newGame(), nullptr);
  const std::uint32_t all = played_.replay.ticks();
  play(hard::counted(6, 100), hard::isFull() ? all : std::min(all, 1500u));
  for (std::size_t i = 0; i < played_.snapshots.size(); ++i) expectTheSameFrom(i, hard::isFull() ? all : 120u);
}

INSTANTIATE_TEST_SUITE_P(Replays, B46, testing::Values("demo.brt", "first-rooms.brt"),
                         [](const auto& replay) { return replay.param[0] == 'd' ? "Demo" : "FirstRooms"; });

}  // namespace
}  // namespace brittle::program
