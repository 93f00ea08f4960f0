// game/sim/session.h - what the rooms of one game share: the assets, the definition, and where events, problems and
// demands go.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "game/sim/constants.h"
#include "game/sim/content_reader.h"
#include "game/sim/event.h"
#include "game/sim/game.h"
#include "game/sim/omission.h"
#include "game/sim/power_up.h"
#include "game/sim/score.h"
#include "game/sim/slow_motion.h"

namespace brittle::sim {

/// Where the camera is, in the local frame of the room that is asked.
struct Viewpoint {
  Vec3 position = Vec3(0.0f, rules::kCameraHeight, 0.0f);  // [m]
  float speed = 0.0f;                                      // along -Z [m/s]
  std::int32_t ticks = 0;                                  // since it entered the room, negative before
  float tickPart = 0.0f;                                   // and this of a tick more; made anew every tick
};

struct Session {
  Session(const content::AssetSource& assets, const GameDef& gameDef) : files(assets), def(gameDef) {
    takeFileProblems();
  }

  ContentReader files;
  GameDef def;
  Score score;
  Inventory inventory;
  Clock clock;
  std::uint32_t explosions = 0;  // since the start
  std::uint64_t tick = 0;
  Tally<Omission> omissions;                // since the game was made or restored
  Tally<physics::Omission> worldOmissions;  // of rooms that are left
  std::vector<Event> events;                // of this tick
  std::vector<Problem> problems;            // each text once
  std::set<std::string> reported, missing;
  std::vector<std::string> soundNames;
  std::map<std::string, std::string> globals;  // of mgGet and mgSet

  int ballCap() const { return def.mode == Mode::Training ? rules::kTrainingBallCap : rules::kBallCap; }
  void report(const std::string& text) {
    if (reported.contains(text)) return;
    if (reported.size() >= rules::kMaxProblems) return omissions.add(Omission::UntoldProblem);
    reported.insert(text);
    problems.push_back({text, tick});
  }
  /// Says of each thing once that it cannot be had, where it was asked for first.
  void reportMissing(const std::string& thing, const std::string& where, const std::string& why) {
    if (missing.contains(thing + ": " + why)) return;
    if (reported.size() >= rules::kMaxProblems) return omissions.add(Omission::UntoldProblem);
    if (missing.insert(thing + ": " + why).second) report(where + ": " + thing + ": " + why);
  }
  void takeFileProblems() {
    for (const std::string& text : files.takeProblems()) report(text);
  }
  /// The index of a sound's name, new or known.
  int soundIndex(const std::string& name) {
    for (std::size_t i = 0; i < soundNames.size(); ++i)
      if (soundNames[i] == name) return static_cast<int>(i);
    if (soundNames.size() >= 256) return 0;
    soundNames.push_back(name);
    return static_cast<int>(soundNames.size()) - 1;
  }
};

}  // namespace brittle::sim
