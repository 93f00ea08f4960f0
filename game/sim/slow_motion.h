// game/sim/slow_motion.h - the game's own time: as long as a tick, or a part of one while slow motion runs. Physics,
// the camera's way, scripts' clocks, beats and the room's music go by it; power-ups, the HUD and what a player does go
// by ticks. The module of Effect::SlowMotion is slow_motion.cpp; without it every tick is a whole one.
#pragma once

#include <cstdint>

#include "game/sim/constants.h"

namespace brittle::sim {

inline constexpr std::int32_t kWholeTick = 256;  // the game's time is counted in 256ths of a tick

/// What passes of the game's time in one tick.
struct TimeStep {
  std::int32_t part = 0;  // of a tick of the game's time that had passed before it [256ths of a tick], below 256
  std::int32_t share = kWholeTick;  // passes now [256ths of a tick]

  /// Whether a tick of the game's time ends.
  bool isWhole() const { return part + share >= kWholeTick; }
  std::int32_t partAfter() const { return isWhole() ? part + share - kWholeTick : part + share; }
  /// [s]
  float seconds() const { return rules::kTickSeconds * (static_cast<float>(share) / kWholeTick); }
};

struct Clock {
  std::int32_t share = kWholeTick;  // of the last tick, see TimeStep
  std::int64_t lost = 0;            // the game's time behind the ticks [256ths of a tick]

  bool isWhole() const { return share == kWholeTick && lost == 0; }
  /// That has passed after `ticks` ticks. [256ths of a tick]
  std::int64_t after(std::uint64_t ticks) const { return static_cast<std::int64_t>(ticks) * kWholeTick - lost; }
  bool isValid() const { return share >= rules::kSlowestShare && share <= kWholeTick && lost >= 0; }

  template <class Archive>
  void serialize(Archive& a) {
    a(share);
    a(lost);
  }
};

/// The next tick, after `ticks` of them: slower by one step, down to rules::kSlowestShare, while `isSlow`, else faster
/// by one.
TimeStep passTime(Clock& clock, std::uint64_t ticks, bool isSlow);

}  // namespace brittle::sim
