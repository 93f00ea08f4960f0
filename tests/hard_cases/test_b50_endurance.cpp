// B50: an hour of play by somebody who throws at everything, on several seeds, in zen and in the classic mode, where
// the game begins again at the last room's door whenever the balls run out. Every number stays finite, nothing sleeps
// in mid-air, memory stays flat, and a second run gives the same hashes.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/allocations.h"
#include "tests/game/sim/endless.h"
#include "tests/hard_cases/case.h"
#include "tests/hard_cases/support.h"
#include "tests/hard_cases/work.h"

namespace brittle::sim {
namespace {

constexpr int kLookTicks = 150;  // between two looks at what floats
constexpr int kHashTicks = 60;

/// What came of one run; its memory is there before the run begins.
struct Record {
  explicit Record(int ticks) {
    hashes.reserve(static_cast<std::size_t>(ticks / kHashTicks + 1));
    milliseconds.reserve(static_cast<std::size_t>(ticks));
    memory.reserve(static_cast<std::size_t>(ticks / rules::kRoomTicks + 1));
  }
  std::vector<std::uint64_t> hashes;  // of every second
  std::vector<double> milliseconds;   // processor time of each tick
  std::vector<std::size_t> memory;    // of the game when a room is entered [bytes]
  std::size_t kept = 0;               // of it when all is over [bytes]
  double breaks = 0, games = 0, looks = 0;
};

/// One player and as many games as it takes.
class Session {
 public:
  Session(std::uint64_t seed, Mode mode) : thrower_(seed), start_(allocatedBytes()) {
    def_.level = "endless";
    def_.seed = seed;
    def_.mode = mode;
    def_.balls = 300;  // for a minute or two
    begin();
  }
  void play(int ticks, bool looks, Record& record) {
    for (int tick = 0; tick < ticks && !testing::Test::HasFailure(); ++tick) {
      const std::uint64_t room = game_->roomNumber();
      const replay::InputFrame input = thrower_.next(*game_);
      const double before = hard::cpuSeconds();
      game_->tick(input);
      record.milliseconds.push_back(1e3 * (hard::cpuSeconds() - before));
      for (std::uint32_t slot : {0u, 1u})
        if (geometry::MeshPool* meshes = game_->meshes(slot)) meshes->clearDirty();  // as whoever draws it does
      if (tick % kHashTicks == 0) record.hashes.push_back(game_->stateHash());
      if (game_->roomNumber() != room) record.memory.push_back(allocatedBytes() - start_);
      if (looks && tick % kLookTicks == 0) record.looks += look(tick);
      if (game_->isOver()) {
        end(record);
        begin();
      }
    }
    end(record);
  }

 private:
  void begin() {
    Result<std::unique_ptr<Game>> made = Game::create(source_, def_);
    ASSERT_TRUE(static_cast<bool>(made)) << made.error().message;
    game_ = std::move(*made);
  }
  void end(Record& record) {
    EXPECT_TRUE(game_->problems().empty()) << game_->problems().front().text;
    record.breaks += game_->totalBreaks();
    record.games += 1;
    def_.firstRoom = game_->reached().room;
  }
  /// How many rooms were looked at.
  int look(int tick) {
    EXPECT_EQ(game_->totalQuarantined(), 0u) << "tick " << tick;
    game_->copyFrame(packet_);
    for (const RoomView& room : packet_.rooms) {
      for (const BodyPose& body : room.bodies)
        EXPECT_TRUE(isFinite(body.pose.position) && body.pose.rotation.coeffs().allFinite()) << "tick " << tick;
      for (const CrumbView& crumb : room.crumbs) EXPECT_TRUE(isFinite(crumb.position)) << "tick " << tick;
      EXPECT_EQ(physics::floatingSleepers(*game_->world(room.slot)), 0)
          << "tick " << tick << ", room " << room.number << ", seed " << def_.seed;
    }
    return static_cast<int>(packet_.rooms.size());
  }

  const LayeredSource source_ = endlessSource();
  GameDef def_;
  Thrower thrower_;
  std::size_t start_;
  std::unique_ptr<Game> game_;
  FramePacket packet_;
};

Record play(std::uint64_t seed, int ticks, bool looks) {
  Record record(ticks);
  const std::size_t before = allocatedBytes();
  Session(seed, seed % 2 == 0 ? Mode::Classic : Mode::Zen).play(ticks, looks, record);
  record.kept = allocatedBytes() - before;
  return record;
}

/// Rooms need from 1 to 5 MB: what a game never gives back shows in those that need the least. Mean of that quarter.
double floorOf(std::span<const std::size_t> memory) {
  std::vector<std::size_t> sorted(memory.begin(), memory.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.resize(sorted.size() / 4);
  double sum = 0.0;
  for (const std::size_t bytes : sorted) sum += static_cast<double>(bytes);
  return sum / static_cast<double>(sorted.size());
}

void expectFlat(const std::vector<std::size_t>& memory) {
  if (memory.size() < 40) return;  // rooms differ: it takes many
  const std::span<const std::size_t> all(memory);
  const double early = floorOf(all.first(all.size() / 2)), late = floorOf(all.last(all.size() / 2));
  EXPECT_LT(late, 1.1 * early);
  hard::reportWorst("memory grown by", 100.0 * (late - early) / early, "%");
}

void reportTimes(std::vector<double> milliseconds) {
  std::sort(milliseconds.begin(), milliseconds.end());
  hard::reportWorst("a tick's processor time: median", milliseconds[milliseconds.size() / 2], "ms");
  hard::reportWorst("of 99 in 100 below", milliseconds[milliseconds.size() * 99 / 100], "ms");
  hard::reportWorst("at most", milliseconds.back(), "ms");
}

TEST(B50, AnHourOfThrowingAtEverything) {
  const int ticks = hard::counted(33, 60 * 60) * rules::kTickRate;
  for (std::uint64_t seed = 1; seed <= 2 * static_cast<std::uint64_t>(hard::counted(1, 2)); ++seed) {
    const Record first = play(seed, ticks, true);
    if (HasFailure()) return;
    const Record second = play(seed, ticks, false);
    EXPECT_GT(first.breaks, ticks / 60) << "seed " << seed;
    expectFlat(first.memory);
    reportTimes(first.milliseconds);
    ASSERT_EQ(first.hashes.size(), second.hashes.size());
    for (std::size_t i = 0; i < first.hashes.size(); ++i)
      ASSERT_EQ(first.hashes[i], second.hashes[i]) << "seed " << seed << ", second " << i;
    EXPECT_EQ(second.kept, 0u) << "what games hold is given back";
    hard::reportSum("breaks", first.breaks);
    hard::reportSum("games", first.games);
    hard::reportSum("rooms looked at", first.looks);
    hard::reportSum("hashes alike", static_cast<double>(first.hashes.size()));
  }
}

}  // namespace
}  // namespace brittle::sim
