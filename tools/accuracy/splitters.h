// accuracy/splitters.h - splitters that trust their arithmetic beside ours: how often each fails, and how many cuts it
// makes in a second. All cut a cube to pieces, at random and through what is there already.
#pragma once

#include <string>
#include <vector>

#include "tools/accuracy/study.h"

namespace brittle::accuracy {

struct SplitterRow {
  std::string splitter;  // "naive float"
  std::string cuts;      // "random", "vertex", "edge", "face"
  double attempts = 0.0, splits = 0.0;
  double failures = 0.0;            // cuts that left no two closed pieces with a volume that add up within 1e-6 m3
  double failuresPerMillion = 0.0;  // attempts
  double splitsPerSecond = 0.0;     // processor time of the cuts alone
  double volumeError = 0.0;         // worst |above + below - parent|, of a cube of 1 m3 [m3]
};

std::vector<SplitterRow> compareSplitters(const Effort& effort, const Advance& advance);
inline constexpr int kSplitterRows = 24;  // six splitters in four ways

}  // namespace brittle::accuracy
