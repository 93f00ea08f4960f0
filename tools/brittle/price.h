// brittle/price.h - what an effect adds to a room, measured by playing the room with it and without it, and by how much
// that may be off.
#pragma once

#include <string>
#include <vector>

#include "engine/core/tally.h"

namespace brittle::program {

/// Of no values 0.
double meanOf(const std::vector<double>& values);

/// What so many ticks of a room took.
struct Spent {
  std::vector<double> ticks;     // simulation and sound [ms]
  std::vector<double> pictures;  // [ms]
  double heapBytes = 0.0;
  std::vector<NamedCount> omissions;  // of game, pictures and sound
};

/// A measured number; what is within its noise cannot be told from zero.
struct Price {
  double value = 0.0, noise = 0.0;
};

struct Prices {
  Price bytes, msPerTick, msPerFrame;
};

/// What `less`, without an effect, saves of the room as it is, which was played before it and after it: what those two
/// differ by is noise, and so is twice the standard error of the times.
Prices pricesOf(const Spent& before, const Spent& less, const Spent& after);

/// In `unit`s to so many decimal places; "< 0.03" if it cannot be told from zero.
std::string inWords(const Price& price, double unit, int decimals);

}  // namespace brittle::program
