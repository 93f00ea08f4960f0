// game/sim/power_up.h - what a player collects, holds and uses: the kinds of power-ups, and the inventory with what
// runs of it. Knows no world: what a kind does is done by whoever asks whether it runs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/effects/effect.h"

namespace brittle::sim {

enum class PowerUp : std::uint8_t {
  BallFrenzy,  // throws are free
  SlowMotion,  // the game's time runs slower
  NitroBalls,  // balls explode at their first touch
  Barrel,      // arms the next throw: one of its balls explodes, much larger, at its first touch
  Count
};

/// As in level files: "ballfrenzy", "slowmotion", "nitroballs", "barrel".
const char* nameOf(PowerUp kind);
std::optional<PowerUp> powerUpNamed(const std::string& name);
/// The physical effect it needs, if any.
std::optional<effects::Effect> effectOf(PowerUp kind);
/// How long one runs [ticks]; 0: until the next throw.
std::int32_t ticksOf(PowerUp kind);

/// One kind that the player holds or that runs.
struct PowerUpSlot {
  PowerUp kind = PowerUp::BallFrenzy;
  std::int32_t count = 0;  // still to be used
  bool runs = false;
  std::int32_t ticksLeft = 0, ticksAll = 0;  // of what runs; 0 where it waits for a throw
  template <class Archive>
  void serialize(Archive& a) {
    a(kind);
    a(count);
    a(runs);
    a(ticksLeft);
    a(ticksAll);
  }
};

/// Kinds stand in the order in which they were collected; a kind of which nothing is left leaves its place to the ones
/// behind it.
class Inventory {
 public:
  /// At most rules::kMostPowerUps of a kind.
  void collect(PowerUp kind);
  /// Begins one of the kind in place `place` (from 0); of a kind that runs, it lasts longer. Nothing if there is none
  /// to use.
  std::optional<PowerUp> use(std::size_t place);
  bool runs(PowerUp kind) const;
  std::int32_t count(PowerUp kind) const;
  /// What waited for a throw has got it.
  void finish(PowerUp kind);
  /// One tick: what has run out.
  std::vector<PowerUp> tick();
  /// Ends all that runs; what is held stays.
  void stop();
  bool isEmpty() const { return slots_.empty(); }
  const std::vector<PowerUpSlot>& slots() const { return slots_; }
  /// Whether it is one that play can lead to: what bytes from a file must hold.
  bool isValid() const;

  template <class Archive>
  void serialize(Archive& a) {
    a.vector(slots_);
  }

 private:
  PowerUpSlot* find(PowerUp kind);
  void dropEmpty();

  std::vector<PowerUpSlot> slots_;
};

}  // namespace brittle::sim
