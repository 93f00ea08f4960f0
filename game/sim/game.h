// game/sim/game.h - one game: rooms, obstacles, balls and score over a physics world per room. tick(input) is a
// function of the state and the input: no clock, no window, no sound, no picture. Used by the program, the view
// (through FramePacket) and smoke scripts.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/byte_stream.h"
#include "engine/core/result.h"
#include "engine/core/tally.h"
#include "engine/effects/effect_set.h"
#include "engine/physics/accuracy.h"
#include "engine/physics/world.h"
#include "engine/replay/input_frame.h"
#include "game/sim/event.h"
#include "game/sim/frame_packet.h"
#include "game/sim/sight.h"

namespace brittle::content {
class AssetSource;
}

namespace brittle::sim {

enum class Mode : std::uint8_t { Training = 0, Classic = 1, Mayhem = 2, Zen = 3, Versus = 4, Coop = 5 };

struct GameDef {
  std::string level = "first";  // levels/NAME.xml
  std::uint64_t seed = 1;       // of every random choice
  physics::Accuracy accuracy;
  effects::EffectMask without;  // effects switched off; the seen and heard ones change nothing of the state
  Mode mode = Mode::Classic;
  std::uint32_t firstRoom = 0;  // start at this room of the level
  std::int32_t balls = 25;      // to start with: of a checkpoint those stored for it
  std::int32_t streak = 0;
  float distance = 0.0f;         // as displayed at the level's first room: of the levels before
  bool title = false;            // wait for a touch before the first room begins
  std::int64_t startOffset = 0;  // global place of the first room [2^-8 m]; nothing but what is shown depends on it
};

/// Where a game can be taken up: at the door of a room, with these counts.
struct RestartPoint {
  std::uint32_t room = 0;  // of the level; past the last one: the level is done
  std::int32_t balls = 0;
  std::int32_t streak = 0;
  float distance = 0.0f;  // as displayed

  template <class Archive>
  void serialize(Archive& a) {
    a(room);
    a(balls);
    a(streak);
    a(distance);
  }
};

/// Something wrong with the content, found while loading or playing. The game goes on.
struct Problem {
  std::string text;  // "file:line: what, value, expected"
  std::uint64_t tick = 0;
};

class Game {
 public:
  /// Loads the level and its first room. Fails, with one line, if there is no such level or it has no rooms. `assets`
  /// must outlive the game. The same definition and the same assets give the same game.
  static Result<std::unique_ptr<Game>> create(const content::AssetSource& assets, const GameDef& def);
  ~Game();
  Game(const Game&) = delete;
  Game& operator=(const Game&) = delete;

  /// One tick of 1/60 s.
  void tick(const replay::InputFrame& input);

  std::uint64_t tickCount() const;
  /// Everything the next tick reads: worlds, scripts, timers, random streams, score.
  std::uint64_t stateHash() const;
  /// The same of the room the camera is in only, relative to that room: independent of what was played before it.
  std::uint64_t roomHash() const;
  void save(ByteWriter& out) const;
  /// False if the bytes are not a snapshot of this version, level and content; the game is then unusable until a good
  /// restore.
  bool restore(ByteReader& in);
  /// From the next tick on, in every room. For tools: a recording of the game so far no longer replays beyond here.
  void setAccuracy(const physics::Accuracy& accuracy);
  /// What was asked for, at creation or since. What is switched off may play with less of it (world()->accuracy()).
  const physics::Accuracy& accuracy() const;
  /// Level, seed, mode and accuracy as created, or as set since.
  const GameDef& def() const;
  /// Over the bytes of every file read so far, by name.
  std::uint64_t contentHash() const;

  // Looking.
  Camera camera() const;
  const Hud& hud() const;
  bool isOver() const;  // out of balls, or the level's last room is done
  /// The last checkpoint passed; the start of the game before there is one.
  const RestartPoint& checkpoint() const;
  /// The room reached last, and how: what to save for a game that is broken off. In zen the start of the game.
  const RestartPoint& reached() const;
  const std::vector<Event>& events() const;  // of the last tick
  const std::vector<Problem>& problems() const;
  const std::vector<std::string>& soundNames() const;
  std::uint64_t roomNumber() const;   // of the room the camera is in
  float roomDistance() const;         // of the camera from that room's start [m]
  std::int64_t globalOrigin() const;  // of that room [2^-8 m]
  std::uint32_t totalBreaks() const;  // breakings since the start
  std::uint32_t totalCrashes() const;
  std::uint32_t totalCrystals() const;     // won since the start
  std::uint32_t totalCleared() const;      // obstacles dealt with since the start
  std::uint32_t totalExplosions() const;   // since the start
  float timeShare() const;                 // of the last tick that passed of the game's time: 1 but in slow motion
  float gravity() const;                   // of the room the camera is in [m/s2]
  std::uint32_t totalQuarantined() const;  // bodies removed because a number in them was not finite: must stay 0
  /// What was put off, refused or taken away so far, in the worlds and by the rules: of each kind that is not zero.
  /// Tells about the game and is no part of its state: what a restored game did before is not in it.
  std::vector<NamedCount> omissions() const;

  /// What a player can see ahead, nearest first; for scripted players.
  void look(std::vector<Sight>& sights) const;
  /// Copies out all that the picture needs; reuses the packet's memory.
  void copyFrame(FramePacket& packet) const;
  /// The mesh pool of room slot 0 or 1, or null if there is no room in it. The renderer mirrors it and clears its dirty
  /// ranges.
  geometry::MeshPool* meshes(std::uint32_t slot);
  /// The world of room slot 0 or 1, or null: for tests of what must hold in it.
  const physics::World* world(std::uint32_t slot) const;
  /// What the room the camera is in demands, with who asked.
  const effects::EffectSet& effects() const;

 private:
  struct Impl;
  explicit Game(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace brittle::sim
