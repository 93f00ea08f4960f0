// replay/recorder.h - writes a replay while a game runs. Call `record` after every tick; nothing else reaches the file.
#pragma once

#include "engine/replay/replay.h"
#include "engine/replay/simulation.h"

namespace brittle::replay {

/// Ten seconds: seeking re-simulates at most this much [ticks].
inline constexpr std::uint32_t kSnapshotInterval = 600;

class Recorder {
 public:
  /// `snapshotInterval` in [ticks], 1 or more.
  explicit Recorder(Start start, std::uint32_t snapshotInterval = kSnapshotInterval);

  /// The tick that `simulation` has just done with `input`. Throws beyond kMaxThrows are a broken contract.
  void record(const InputFrame& input, const Simulation& simulation);

  const Replay& replay() const { return replay_; }

 private:
  Replay replay_;
  std::uint32_t snapshotInterval_;
};

}  // namespace brittle::replay
