// replay/player.h - runs a simulation through a replay, finds the first tick that differs, and seeks by snapshots.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "engine/core/result.h"
#include "engine/replay/replay.h"
#include "engine/replay/simulation.h"

namespace brittle::replay {

/// A simulation in the replay's start state.
using MakeSimulation = std::function<std::unique_ptr<Simulation>()>;

/// Drives one simulation tick by tick.
class Player {
 public:
  /// `simulation` is in the replay's start state; both outlive the player.
  Player(const Replay& replay, Simulation& simulation) : replay_(replay), simulation_(simulation) {}

  bool atEnd() const { return tick_ >= replay_.ticks(); }
  /// Ticks done.
  std::uint32_t tick() const { return tick_; }
  /// One tick. True if the state hashes as it did when it was recorded. Not at the end.
  bool step();
  /// Forward or back to the state after `target` ticks: restores the nearest snapshot if that is ahead of where the
  /// player is, then simulates. Back before the first snapshot needs a fresh simulation, so a target behind is refused
  /// then; so is a snapshot that does not hash as recorded. The simulation is of no use after a refused snapshot.
  Status seek(std::uint32_t target);

 private:
  const Replay& replay_;
  Simulation& simulation_;
  std::uint32_t tick_ = 0;
};

struct Difference {
  std::uint32_t tick = 0;  // ticks done when the hashes first differ
  std::uint64_t recorded = 0, replayed = 0;
  std::uint32_t fromSnapshot = 0;  // the tick of the snapshot the run began at; 0: at the start
  bool unreadable = false;         // the snapshot could not be restored
};

/// Runs the whole replay from its start, ignoring snapshots, then from each snapshot to the next. The first difference,
/// if any. `progress` is called after every tick with the ticks done of the whole run and of all; when it answers
/// false, that was all, and nothing is known of the rest.
std::optional<Difference> verify(const Replay& replay, const MakeSimulation& make,
                                 const std::function<bool(std::uint32_t, std::uint32_t)>& progress = {});

}  // namespace brittle::replay
