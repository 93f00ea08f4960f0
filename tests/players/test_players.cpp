// The first level by scripted players: who plays better ends with more balls, and who throws nothing does not get
// through the first room. PLAYER_SEEDS in the environment says how many games each plays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "game/content/asset_source.h"
#include "game/sim/smoke.h"

namespace brittle::sim {
namespace {

const content::FolderSource& assets() {
  static const content::FolderSource source({BRITTLE_SOURCE_DIR "/assets"});
  return source;
}

std::uint64_t seedCount() {
  const char* text = std::getenv("PLAYER_SEEDS");
  return text != nullptr ? static_cast<std::uint64_t>(std::max(1, std::atoi(text))) : 3;
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

/// Of the balls left after each game.
int medianOf(const std::string& skill) {
  std::vector<int> balls;
  for (std::uint64_t seed = 1; seed <= seedCount(); ++seed) balls.push_back(playLevel(skill, seed).hud.balls);
  std::sort(balls.begin(), balls.end());
  return balls[balls.size() / 2];
}

TEST(Players, TheBetterOneEndsTheThreeRoomsWithClearlyMoreBalls) {
  const int careless = medianOf("careless");
  const int average = medianOf("average");
  const int good = medianOf("good");  // the script itself expects the checkpoint of a good player
  EXPECT_GE(average, careless + 15);
  EXPECT_GE(good, average + 25);
}

TEST(Players, WhoThrowsNothingDoesNotGetThroughTheFirstRoom) {
  const SmokeResult result = playLevel("idle", 1);
  EXPECT_EQ(result.hud.phase, Phase::GameOver);
  EXPECT_EQ(result.hud.room, 0);
}

}  // namespace
}  // namespace brittle::sim
