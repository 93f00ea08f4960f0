#include "engine/replay/player.h"

#include <string>

namespace brittle::replay {
namespace {

bool restoreFrom(const Snapshot& snapshot, Simulation& simulation) {
  const auto bytes = snapshot.bytes();
  if (!bytes) return false;
  ByteReader in(*bytes);
  return simulation.restore(in);
}

}  // namespace

bool Player::step() {
  simulation_.tick(replay_.frames[tick_]);
  ++tick_;
  return simulation_.hash() == replay_.hashes[tick_ - 1];
}

Status Player::seek(std::uint32_t target) {
  if (target > replay_.ticks())
    return Error{"tick " + std::to_string(target) + " is beyond the replay's " + std::to_string(replay_.ticks()) +
                 " ticks"};
  const Snapshot* snapshot = replay_.snapshotBefore(target);
  if (snapshot != nullptr && (snapshot->tick > tick_ || target < tick_)) {
    const std::string name = "the snapshot of tick " + std::to_string(snapshot->tick);
    if (!restoreFrom(*snapshot, simulation_)) return Error{name + " cannot be restored"};
    if (simulation_.hash() != replay_.hashes[snapshot->tick - 1])
      return Error{name + " is not the state recorded there: verify the replay"};
    tick_ = snapshot->tick;
  }
  if (target < tick_) return Error{"no snapshot before tick " + std::to_string(target) + ": start the game again"};
  while (tick_ < target) step();
  return Done{};
}

namespace {

/// Ticks `from` + 1 to `to` in a simulation that has done `from`.
std::optional<Difference> compare(const Replay& replay, Simulation& simulation, std::uint32_t from, std::uint32_t to,
                                  const std::function<bool()>& ticked) {
  for (std::uint32_t tick = from; tick < to; ++tick) {
    simulation.tick(replay.frames[tick]);
    const std::uint64_t hash = simulation.hash();
    if (hash != replay.hashes[tick]) return Difference{tick + 1, replay.hashes[tick], hash, from, false};
    if (!ticked()) break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Difference> verify(const Replay& replay, const MakeSimulation& make,
                                 const std::function<bool(std::uint32_t, std::uint32_t)>& progress) {
  const std::uint32_t first = replay.snapshots.empty() ? replay.ticks() : replay.snapshots.front().tick;
  const std::uint32_t all = replay.ticks() + (replay.ticks() - first);
  std::uint32_t done = 0;
  bool goesOn = true;
  const auto ticked = [&] {
    ++done;
    goesOn = !progress || progress(done, all);
    return goesOn;
  };
  const std::unique_ptr<Simulation> whole = make();
  if (const auto difference = compare(replay, *whole, 0, replay.ticks(), ticked)) return difference;
  for (std::size_t i = 0; i < replay.snapshots.size() && goesOn; ++i) {
    const Snapshot& snapshot = replay.snapshots[i];
    const std::uint32_t end = i + 1 < replay.snapshots.size() ? replay.snapshots[i + 1].tick : replay.ticks();
    const std::unique_ptr<Simulation> part = make();
    if (!restoreFrom(snapshot, *part)) return Difference{snapshot.tick, 0, 0, snapshot.tick, true};
    const std::uint64_t recorded = replay.hashes[snapshot.tick - 1];
    if (part->hash() != recorded) return Difference{snapshot.tick, recorded, part->hash(), snapshot.tick, false};
    if (const auto difference = compare(replay, *part, snapshot.tick, end, ticked)) return difference;
  }
  return std::nullopt;
}

}  // namespace brittle::replay
