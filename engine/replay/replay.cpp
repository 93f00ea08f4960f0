#include "engine/replay/replay.h"

#include "engine/replay/compress.h"

namespace brittle::replay {

std::optional<std::vector<unsigned char>> Snapshot::bytes() const {
  return decompress(block, size);
}

const Snapshot* Replay::snapshotBefore(std::uint32_t tick) const {
  const Snapshot* last = nullptr;
  for (const Snapshot& snapshot : snapshots)
    if (snapshot.tick <= tick) last = &snapshot;
  return last;
}

}  // namespace brittle::replay
