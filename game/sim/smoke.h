// game/sim/smoke.h - scripted games that check themselves: plays a Lua script against a Game and collects what did not
// hold. Pure: no files but the asset source, no printing; `brittle smoke` and the tests print.
//
// The script's functions (named arguments are fields of one table):
//   level(NAME)                       levels/NAME.xml; before anything else (default "first")
//   seed(N)                           default 1
//   mode(NAME)                        "training", "classic", "mayhem", "zen"
//   room(N)                           start at room N (from 0)
//   throw{tick=T, x=X, y=Y}           at tick T (default: now) aim at (X, Y) of the plane one unit ahead
//   run(T)                            play until tick T
//   restore_at(T)                     play until tick T, save, restore, go on
//   expect_broken(min[, max])         breakings so far
//   expect_balls(n)                   balls left
//   expect_crashes(min[, max])
//   expect_streak(min[, max])
//   expect_crystals(min[, max])       won so far
//   expect_cleared(min[, max])        obstacles dealt with so far
//   expect_events(NAME, min[, max])   "splash" or "smoke": how many were seen so far
//   expect_phase(NAME)                "title", "playing", "checkpoint", "game over"
//   expect_position{z=Z, within=W}    distance of the camera from its room's start [m]
//   expect_speed{v=V, within=W}       camera speed [m/s]
//   expect_room(n)                    number of rooms passed
//   expect_problems(max)              content problems so far
//   expect_power_ups(KIND, n)         of that kind in the inventory, not yet used
//   expect_explosions(min[, max])     so far
//   expect_finite()                   no body was quarantined for a number that is not finite
// What a scripted player sees (assets/player.lua):
//   tick() balls() streak() balls_per_throw() room_number() phase()
//   speed()                           of the camera [m/s]
//   gravity()                         of the room [m/s2]
//   look()                            how many things are in sight now, nearest first
//   seen(I)                           of thing I (from 1): "crystal", "threat", "button" or "power-up"; x, y, ahead of
//   the camera [m]; velocity
//                                     x, y, ahead [m/s]; a number that stays its own; whether the line to it is clear;
//                                     how far aside of the camera's way [m]; whether a ball can move or break it; its
//                                     obstacle's type; x of its centre
//   power_ups(KIND)                   how many there are to use; of one that runs what is left of it, 1 to 0
//   use(KIND)                         uses one in the next tick
//   time_share()                      of a tick that passes of the game's time; less than 1 in slow motion
//   setting(NAME, DEFAULT)            a text given from outside (--set NAME=TEXT)
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/replay/input_frame.h"
#include "game/sim/game.h"

namespace brittle::sim {

struct SmokeFailure {
  std::uint64_t tick = 0;
  std::string text;  // "smoke/x.lua:12: expect_broken: 3, expected 4 to 6"
};

struct SmokeResult {
  std::vector<SmokeFailure> failures;
  std::vector<std::string> problems;  // content problems met
  std::uint64_t ticks = 0;
  std::uint64_t stateHash = 0;        // at the end
  std::uint32_t checks = 0;           // expectations tested
  std::vector<NamedCount> omissions;  // Game::omissions, of all games it took
  Hud hud;                            // at the end
  std::set<std::string> asked;        // names of settings the script wanted to know
  GameDef def;                        // with `inputs`: enough to record the run as a replay
  std::vector<replay::InputFrame> inputs;
  bool passed() const { return failures.empty(); }
};

struct SmokeSettings {
  physics::Accuracy accuracy;
  effects::EffectMask without;
  std::optional<std::uint64_t> seed;          // instead of the script's; math.random follows it too
  std::map<std::string, std::string> values;  // of setting()
  std::function<bool()> isCalledOff;  // asked before each tick: then the script ends with a failure; null: never
};

/// Plays the script `source`, named `name` in messages. A script that is wrong is a failure, not an error.
SmokeResult runSmoke(const content::AssetSource& assets, const std::string& name, const std::string& source,
                     const SmokeSettings& settings = {});

}  // namespace brittle::sim
