// The first level by scripted players: who plays better ends with more balls, and who throws nothing does not get
// through the first room.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "game/content/asset_source.h"
#include "game/sim/smoke.h"

namespace brittle::sim {
namespace {

const content::FolderSource& assets() {
  static const content::FolderSource source({BRITTLE_SOURCE_DIR "/assets"});
  return source;
}

SmokeResult playLevel(const std::string& skill, std::uint64_t seed) {
  SmokeSettings settings;
  settings.seed = seed;
  settings.values["skill"] = skill;
  const Result<std::string> script = assets().read("player.lua");
  EXPECT_TRUE(static_cast<bool>(script));
  SmokeResult result = runSmoke(assets(), "assets/player.lua", script ? *script : "", settings);
  for (const SmokeFailure& failure : result.failures)
    ADD_FAILURE() << skill << ", seed " << seed << ", tick " << failure.tick << ": " << failure.text;
  return result;
}

/// Of the balls left after games with so many seeds.
int medianOf(const std::string& skill, std::uint64_t seeds) {
  std::vector<int> balls;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) balls.push_back(playLevel(skill, seed).hud.balls);
  std::sort(balls.begin(), balls.end());
  return balls[balls.size() / 2];
}

/// The good one by `lead` balls. Few games say less than many: a careless player has none left or as many as an average
/// one.
void expectBetterOnesAhead(std::uint64_t seeds, int lead) {
  const int careless = medianOf("careless", seeds);
  const int average = medianOf("average", seeds);
  const int good = medianOf("good", seeds);  // the script itself expects the checkpoint of a good player
  EXPECT_GE(average, careless + 10);
  EXPECT_GE(good, average + lead);
}

TEST(Players, TheBetterOneEndsTheThreeRoomsWithClearlyMoreBalls) {
  expectBetterOnesAhead(5, 10);
}
TEST(PlayersLong, TheBetterOneEndsTheThreeRoomsWithClearlyMoreBalls) {
  expectBetterOnesAhead(20, 20);
}

TEST(Players, WhoThrowsNothingDoesNotGetThroughTheFirstRoom) {
  const SmokeResult result = playLevel("idle", 1);
  EXPECT_EQ(result.hud.phase, Phase::GameOver);
  EXPECT_EQ(result.hud.room, 0);
}

}  // namespace
}  // namespace brittle::sim
