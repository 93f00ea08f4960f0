#include "game/sim/progress.h"

#include <algorithm>
#include <sstream>

#include "game/sim/constants.h"

namespace brittle::sim {

Progress Progress::parse(const std::string& text, const std::string& file, std::vector<std::string>& problems) {
  Progress progress;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::int32_t balls = 0;
    std::uint32_t room = 0;
    std::string level;
    const bool isRead = static_cast<bool>(words >> balls >> room) && std::getline(words >> std::ws, level);
    if (isRead && balls > 0 && balls <= rules::kBallCap) {
      progress.pass(level, room, balls);
    } else if (!line.empty()) {
      problems.push_back(file + ":" + std::to_string(number) + ": " + line.substr(0, 80) +
                         ": expected BALLS ROOM LEVEL");
    }
  }
  return progress;
}

std::string Progress::text() const {
  std::string text;
  for (const auto& [place, balls] : balls_)
    text += std::to_string(balls) + " " + std::to_string(place.second) + " " + place.first + "\n";
  return text;
}

bool Progress::pass(const std::string& level, std::uint32_t room, std::int32_t balls) {
  std::int32_t& stored = balls_[{level, room}];
  if (balls <= stored) return false;
  stored = balls;
  return true;
}

std::int32_t Progress::ballsAt(const std::string& level, std::uint32_t room) const {
  const auto found = balls_.find({level, room});
  return found == balls_.end() ? rules::kStartBalls : found->second;
}

GameDef nextGame(const Game& game, const Progress& progress, const std::vector<std::string>& levels) {
  GameDef def = game.def();
  ++def.seed;
  def.title = false;
  const RestartPoint& from = game.checkpoint();
  const bool isPassed = from.room > def.firstRoom;
  if (isPassed) def.balls = progress.ballsAt(def.level, from.room);
  if (isPassed) def.streak = 0;
  def.firstRoom = from.room;
  if (game.hud().phase != Phase::Checkpoint) return def;
  def.firstRoom = 0;
  def.streak = from.streak;
  def.distance = from.distance;
  const auto here = std::find(levels.begin(), levels.end(), def.level);
  if (here != levels.end() && here + 1 != levels.end()) def.level = *(here + 1);
  return def;
}

}  // namespace brittle::sim
