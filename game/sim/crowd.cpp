#include "game/sim/crowd.h"

#include <algorithm>

#include "engine/math/types.h"
#include "game/sim/constants.h"

namespace brittle::sim {
namespace {

// What lies before a room's start or beyond the longest counts as at its ends: bounded, however long a box is.
constexpr float kFirst = -128.0f, kLast = 4224.0f;  // [m]
constexpr auto kCells = static_cast<std::size_t>((kLast - kFirst) / rules::kCrowdCell);

std::size_t cellOf(float place) {
  const float cell = (clampTo(place, kFirst, kLast) - kFirst) / rules::kCrowdCell;
  return std::min(static_cast<std::size_t>(cell), kCells - 1);
}

}  // namespace

bool Crowd::add(float start, float end) {
  const std::size_t first = cellOf(start), last = cellOf(end);
  if (cells_.empty()) cells_.resize(kCells);
  for (std::size_t i = first; i <= last; ++i)
    if (cells_[i] >= rules::kMaxBoxesPerCell) return false;
  for (std::size_t i = first; i <= last; ++i) ++cells_[i];
  return true;
}

std::uint32_t Crowd::between(float a, float b) const {
  const std::size_t first = cellOf(minOf(a, b)), last = cellOf(maxOf(a, b));
  std::uint32_t sum = 0;
  for (std::size_t i = first; i <= last && i < cells_.size(); ++i) sum += cells_[i];
  return sum;
}

}  // namespace brittle::sim
