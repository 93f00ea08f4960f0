#include "engine/replay/recorder.h"

#include <utility>

#include "engine/core/assert.h"
#include "engine/replay/compress.h"

namespace brittle::replay {

Recorder::Recorder(Start start, std::uint32_t snapshotInterval) : snapshotInterval_(snapshotInterval) {
  BR_ASSERT(snapshotInterval >= 1);
  replay_.start = std::move(start);
}

void Recorder::record(const InputFrame& input, const Simulation& simulation) {
  BR_ASSERT(input.throws.size() <= static_cast<std::size_t>(kMaxThrows));
  if (replay_.ticks() == kMaxTicks) return;
  replay_.frames.push_back(input);
  replay_.hashes.push_back(simulation.hash());
  if (replay_.ticks() % snapshotInterval_ != 0) return;
  ByteWriter out;
  simulation.save(out);
  if (out.bytes().size() > kLongestSnapshot) return;
  replay_.snapshots.push_back({replay_.ticks(), static_cast<std::uint32_t>(out.bytes().size()), compress(out.bytes())});
}

}  // namespace brittle::replay
