// The first level by scripted players: who plays better ends with more balls, and who throws nothing does not get
// through the first room.
#include <gtest/gtest.h>

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

/// Balls left on average after games with so many seeds. (The median of few says little: a careless player has none
/// left or as many as an average one.)
double meanOf(const std::string& skill, std::uint64_t seeds) {
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) sum += playLevel(skill, seed).hud.balls;
  return sum / static_cast<double>(seeds);
}

/// The good one by `lead` balls.
void expectBetterOnesAhead(std::uint64_t seeds, double lead) {
  const double careless = meanOf("careless", seeds);
  const double average = meanOf("average", seeds);
  const double good = meanOf("good", seeds);  // the script itself expects the checkpoint of a good player
  EXPECT_GE(average, careless + 10.0);
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
