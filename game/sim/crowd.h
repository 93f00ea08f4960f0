// game/sim/crowd.h - how many boxes reach into each part of a room's length: what lies on one spot costs rays and the
// search for pairs time by its number. Knows no boxes, only where they begin and end.
#pragma once

#include <cstdint>
#include <vector>

namespace brittle::sim {

class Crowd {
 public:
  /// From `start` to `end` [m] from the room's start along -Z. False, and nothing is counted, where there are
  /// rules::kMaxBoxesPerCell already.
  bool add(float start, float end);
  /// No more boxes than this reach into the part between two places, in any order; one that is long counts often.
  std::uint32_t between(float a, float b) const;

 private:
  std::vector<std::uint16_t> cells_;
};

}  // namespace brittle::sim
