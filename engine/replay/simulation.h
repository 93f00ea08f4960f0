// replay/simulation.h - what can be recorded and replayed: anything that is a function of its start and one input frame
// per tick.
#pragma once

#include <cstdint>

#include "engine/core/byte_stream.h"
#include "engine/replay/input_frame.h"

namespace brittle::replay {

class Simulation {
 public:
  virtual ~Simulation() = default;
  virtual void tick(const InputFrame& input) = 0;
  /// Of everything the next tick reads.
  virtual std::uint64_t hash() const = 0;
  virtual void save(ByteWriter& out) const = 0;
  /// False if the bytes are not a snapshot of this simulation.
  virtual bool restore(ByteReader& in) = 0;
};

}  // namespace brittle::replay
