// content/level.h - the rooms of a level, in order, and the list of levels of a game.
#pragma once

#include "game/content/problem.h"

#include <map>
#include <string>
#include <vector>

namespace brittle::content {

struct Room {
  std::string type;       // rooms/TYPE.lua, never empty
  float length = 100.0f;  // what the room adds to the displayed distance; positive
  bool start = false;     // first or last room of its kind in a row: placed by the author
  bool end = false;
  std::map<std::string, std::string> attributes;  // all of them as written, type included: scripts read them
  int line = 0;
};

struct Level {
  std::string file;
  std::vector<Room> rooms;
  Problems problems;
};

/// Reads a levels/NAME.xml. Never fails; rooms without a type are left out.
Level readLevel(const std::string& text, const std::string& file);

struct LevelEntry {
  std::string name;  // levels/NAME.xml, may be a path
  int line = 0;
};

struct GameList {
  std::string file;
  std::vector<LevelEntry> levels;  // the last ones repeat for endless play
  Problems problems;
};

/// Reads a game.xml.
GameList readGameList(const std::string& text, const std::string& file);

}  // namespace brittle::content
