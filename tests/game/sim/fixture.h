// tests/game/sim/fixture.h - games to test with: the shipped assets, or one room held in memory around the shipped
// obstacles.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include "game/content/asset_source.h"
#include "game/sim/constants.h"
#include "game/sim/game.h"

namespace brittle::sim {

inline const content::FolderSource& shippedAssets() {
  static const content::FolderSource source({BRITTLE_SOURCE_DIR "/assets"});
  return source;
}

/// Level "test" with one corridor of 32 m of the length `length` (which sets the pace), holding `elements` (segment
/// XML), and the shipped obstacle scripts. `room` replaces the room script's body.
inline content::MemorySource oneRoom(const std::string& elements, float length = 160.0f, const std::string& room = "") {
  content::MemorySource source;
  source.add("levels/test.xml", "<level><room type=\"test/room\" length=\"100\"/></level>");
  const std::string body =
      room.empty() ? "mgSegment(\"test/corridor\", 0) mgLength(" + std::to_string(length) + ")" : room;
  source.add("rooms/test/room.lua", "function init() " + body + " end");
  source.add("segments/test/corridor.xml",
             "<segment size=\"12 10 32\"><box pos=\"0 -1.2 -16\" size=\"4 .2 16\"/><box pos=\"-4.2 1.5 -16\" size=\".2 "
             "2.5 16\"/>"
             "<box pos=\"4.2 1.5 -16\" size=\".2 2.5 16\"/><box pos=\"0 4.2 -16\" size=\"4 .2 16\"/>" +
                 elements + "</segment>");
  for (const char* name : {"framedwindow", "suspendwindow", "box", "bar", "scoretop", "scorediamond", "scorestar",
                           "doors/basic", "rotor", "sweeper", "suspendcube"}) {
    const std::string file = std::string("obstacles/") + name + ".lua";
    const Result<std::string> text = shippedAssets().read(file);
    source.add(file, text ? *text : "");
  }
  return source;
}

inline std::string repeated(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

/// A room with so many obstacles of one script on one spot.
inline content::MemorySource withObstacles(int count, const std::string& script, const std::string& room = "") {
  content::MemorySource source =
      oneRoom(repeated(count, "\n<obstacle pos=\"3 1 -20\" type=\"tested\"/>"), 320.0f, room);
  source.add("obstacles/tested.lua", script);
  return source;
}

/// How many of this name a game has left out so far.
inline std::uint64_t countOf(const Game& game, std::string_view name) {
  for (const NamedCount& one : game.omissions())
    if (one.name == name) return one.count;
  return 0;
}

inline std::unique_ptr<Game> newGame(const content::AssetSource& source, GameDef def = {}) {
  Result<std::unique_ptr<Game>> made = Game::create(source, def);
  EXPECT_TRUE(static_cast<bool>(made)) << made.error().message;
  return made ? std::move(*made) : nullptr;
}

inline std::unique_ptr<Game> newTestGame(const content::AssetSource& source) {
  GameDef def;
  def.level = "test";
  return newGame(source, def);
}

inline replay::InputFrame throwAt(float x, float y) {
  replay::InputFrame frame;
  frame.throws.push_back(replay::quantizeAim(x, y));
  return frame;
}

/// Plays `ticks` ticks without a throw, counting events by type.
inline std::map<EventType, int> play(Game& game, int ticks) {
  std::map<EventType, int> counts;
  for (int i = 0; i < ticks; ++i) {
    game.tick({});
    for (const Event& event : game.events()) ++counts[event.type];
  }
  return counts;
}

/// A player without plan: a throw now and then, the same for the same tick.
inline replay::InputFrame scriptedInput(std::uint64_t tick) {
  replay::InputFrame frame;
  if (tick % 45 == 20) frame.throws.push_back(replay::quantizeAim(0.0f, 0.0f));
  if (tick % 90 == 50) {
    const float side = static_cast<float>(static_cast<int>(tick / 90 % 5) - 2) * 0.12f;
    frame.throws.push_back(replay::quantizeAim(side, -0.05f));
  }
  return frame;
}

}  // namespace brittle::sim
