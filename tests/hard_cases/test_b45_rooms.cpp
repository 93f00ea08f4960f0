// B45: a room plays the same bits wherever it lies. Thirty identical rooms of 137.3 m on end, and one room far out.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "game/sim/constants.h"
#include "game/sim/game.h"
#include "tests/game/sim/layered_source.h"
#include "tests/hard_cases/case.h"

namespace brittle::sim {
namespace {

constexpr const char* kRoom = R"(
function init()
  local l = 0
  l = l + mgSegment("first/hall/window", -l)
  l = l + mgSegment("first/hall/hanging", -l)
  mgObstacle("box", mgRndFloat(-3, 3), 0, -60, "sizeX=0.3", "sizeY=0.3", "sizeZ=0.3")
  mgSegment("first/hall/blocks", -70)
  mgSegment("first/hall/door", -121.3)
  mgLength(137.3)
end)";

/// The same shipped segments and obstacles in every room; the attribute `seed` makes their random choices the same too.
LayeredSource sameRooms(int count) {
  return LayeredSource({{"levels/same.xml", levelOf(count, "same", "seed=\"5\"")}, {"rooms/same.lua", kRoom}});
}

replay::InputFrame inputAt(std::uint32_t tickInRoom) {
  replay::InputFrame frame;
  if (tickInRoom == 50 || tickInRoom == 240) frame.throws.push_back(replay::quantizeAim(0.0f, 0.0f));
  if (tickInRoom == 960) frame.throws.push_back(replay::quantizeAim(0.05f, -0.02f));
  return frame;
}

/// The hashes of one room, tick by tick.
std::vector<std::uint64_t> playRoom(Game& game) {
  std::vector<std::uint64_t> hashes;
  const std::uint64_t room = game.roomNumber();
  for (std::uint32_t i = 0; i < rules::kRoomTicks && game.roomNumber() == room; ++i) {
    hashes.push_back(game.roomHash());
    game.tick(inputAt(i));
  }
  return hashes;
}

GameDef definition(std::int64_t offset = 0) {
  GameDef def;
  def.level = "same";
  def.mode = Mode::Zen;  // balls do not run out in thirty rooms
  def.startOffset = offset;
  return def;
}

TEST(B45, ThirtyIdenticalRoomsGiveIdenticalHashes) {
  const LayeredSource source = sameRooms(30);
  Result<std::unique_ptr<Game>> game = Game::create(source, definition());
  ASSERT_TRUE(static_cast<bool>(game)) << game.error().message;
  EXPECT_TRUE((*game)->problems().empty()) << (*game)->problems().front().text;
  const std::vector<std::uint64_t> first = playRoom(**game);
  ASSERT_EQ(first.size(), static_cast<std::size_t>(rules::kRoomTicks));
  EXPECT_GT((*game)->totalBreaks(), 2u);
  for (int room = 1; room < 30; ++room) {
    ASSERT_EQ((*game)->roomNumber(), static_cast<std::uint64_t>(room));
    const std::vector<std::uint64_t> hashes = playRoom(**game);
    ASSERT_EQ(hashes.size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i) ASSERT_EQ(hashes[i], first[i]) << "room " << room << ", tick " << i;
    hard::reportSum("ticks alike", double(first.size()));
  }
}

TEST(B45, ARoomIsTheSameFarOut) {
  const LayeredSource source = sameRooms(2);
  std::vector<std::vector<std::uint64_t>> played;
  for (const std::int64_t metres : {std::int64_t{0}, std::int64_t{1'000'037}, std::int64_t{1} << 40}) {
    Result<std::unique_ptr<Game>> game = Game::create(source, definition(metres * 256));
    ASSERT_TRUE(static_cast<bool>(game));
    EXPECT_EQ((*game)->globalOrigin(), metres * 256);
    played.push_back(playRoom(**game));
  }
  EXPECT_EQ(played[0], played[1]);
  EXPECT_EQ(played[0], played[2]);
  hard::reportSum("places alike", played[0] == played[1] && played[0] == played[2] ? 3 : 0);
}

}  // namespace
}  // namespace brittle::sim
