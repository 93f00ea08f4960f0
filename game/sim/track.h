// game/sim/track.h - the rooms the camera passes: the one it is in and the next one, each in a world of its own. Balls
// cross from one into the other; all else stays in its room.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/replay/input_frame.h"
#include "game/sim/pace.h"
#include "game/sim/room.h"

namespace brittle::sim {

class Track {
 public:
  /// Enters the first room: it has been played, without the player, from where every room begins to be played.
  Track(Session& session, std::vector<RoomEntry> entries, std::uint32_t firstRoom, std::int64_t startOffset);

  /// With `isMoving` false the camera stands, and nothing can be thrown. `time` passes of the game's time.
  void tick(const replay::InputFrame& input, bool isMoving, const TimeStep& time = {});

  Camera camera() const;
  const Pace& pace() const { return pace_; }
  Room& current() { return *current_; }
  const Room& current() const { return *current_; }
  Room* next() { return next_.get(); }
  const Room* next() const { return next_.get(); }
  /// The one whose Room::slot() it is, or null.
  Room* inSlot(std::uint32_t slot) const {
    if (current_->slot() == slot) return current_.get();
    return next_ && next_->slot() == slot ? next_.get() : nullptr;
  }
  std::int64_t globalOrigin() const { return origin_; }  // of the current room [2^-8 m]
  float displayedDistance() const;
  bool levelDone() const { return done_; }
  /// Which of the level's the current room is, and how many there are.
  std::uint32_t roomIndex() const { return firstRoom_ + static_cast<std::uint32_t>(number_); }
  std::uint32_t roomCount() const { return static_cast<std::uint32_t>(entries_.size()); }

  /// What can be seen ahead in both rooms, nearest first.
  void look(std::vector<Sight>& sights) const;

  std::uint64_t stateHash() const;
  std::uint64_t roomHash() const;
  void save(ByteWriter& out) const;
  bool restore(ByteReader& in);

 private:
  void makeNext();
  void tickRooms(const TimeStep& time = {});
  void throwBall(const replay::Throw& aim);
  void moveBalls();
  void enterNext();
  void passDoor();
  void throwBalls(const replay::InputFrame& input);
  std::unique_ptr<Room> makeRoom(std::uint64_t number);
  std::unique_ptr<Room> restoreRoom(ByteReader& in, std::uint64_t number);

  Session& session_;
  std::vector<RoomEntry> entries_;
  std::uint32_t firstRoom_;
  Pace pace_;
  std::int64_t origin_;
  std::uint64_t number_ = 0;  // of the current room, from the start of the game
  bool done_ = false;
  bool isMoving_ = true;                  // in the last tick
  std::unique_ptr<Room> current_, next_;  // before the first room is entered there is no current one
};

}  // namespace brittle::sim
