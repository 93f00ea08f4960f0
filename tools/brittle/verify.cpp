#include <cstdio>

#include "tools/brittle/game.h"
#include "tools/brittle/interrupt.h"
#include "tools/brittle/progress.h"

namespace brittle::program {
namespace {

void printDifference(const std::string& name, const replay::Difference& difference) {
  if (difference.unreadable) {
    std::printf("%s: DIFFERS: the snapshot of tick %u cannot be restored\n", name.c_str(), difference.tick);
    return;
  }
  const std::string from = difference.fromSnapshot == 0
                               ? ""
                               : " (from the snapshot of tick " + std::to_string(difference.fromSnapshot) + ")";
  std::printf("%s: DIFFERS at tick %u%s: recorded %016llx, now %016llx\n", name.c_str(), difference.tick, from.c_str(),
              static_cast<unsigned long long>(difference.recorded),
              static_cast<unsigned long long>(difference.replayed));
}

/// Only the first `ticks` of it.
void shorten(replay::Replay& replay, std::uint32_t ticks) {
  if (ticks >= replay.ticks()) return;
  replay.frames.resize(ticks);
  replay.hashes.resize(ticks);
  while (!replay.snapshots.empty() && replay.snapshots.back().tick > ticks) replay.snapshots.pop_back();
}

int verifyOne(const content::AssetSource& assets, const std::string& name, std::uint32_t ticks) {
  Result<replay::Replay> replay = loadReplay(name);
  if (!replay) return refuse(replay.error());
  if (ticks > 0) shorten(*replay, ticks);
  // The first game also tells whether there is one at all; later ones start from the same files.
  Result<std::unique_ptr<GameSimulation>> first = openReplay(assets, *replay, name);
  if (!first) return refuse(first.error());
  const auto make = [&]() -> std::unique_ptr<replay::Simulation> {
    if (*first) return std::move(*first);
    return std::move(*openReplay(assets, *replay, name));
  };
  std::optional<replay::Difference> difference;
  {
    Progress progress("verifying " + name, 100);
    difference = replay::verify(*replay, make, [&](std::uint32_t done, std::uint32_t of) {
      progress.reached(of == 0 ? 100 : static_cast<std::uint32_t>(100ull * done / of));
      return !isInterrupted();
    });
  }
  if (isInterrupted()) return refuse(interruption());
  if (difference) {
    printDifference(name, *difference);
    return kFailed;
  }
  std::printf("%s: %u ticks and %zu snapshots, the same bits; final state %016llx\n", name.c_str(), replay->ticks(),
              replay->snapshots.size(), static_cast<unsigned long long>(replay->hashes.back()));
  return kDone;
}

}  // namespace

int verify(const VerifyOptions& options) {
  const auto assets = openAssets(options.assets);
  if (!assets) return refuse(assets.error());
  catchInterrupts();
  int worst = kDone;
  for (std::size_t i = 0; i < options.replays.size() && !isInterrupted(); ++i)
    worst = std::max(worst, verifyOne(**assets, options.replays[i], options.ticks));
  return isInterrupted() && worst != kInterrupted ? refuse(interruption()) : worst;
}

}  // namespace brittle::program
