// audio/echo.h - repeats: each `delay` after the last, weaker by `feedback` and duller by the low-pass. Exact to the
// sample.
#pragma once

#include <vector>

#include "engine/audio/block.h"
#include "engine/audio/filter.h"

namespace brittle::audio {

struct EchoDef {
  float volume = 0.0f;    // of the first repeat, 0 to 1
  float delay = 0.25f;    // [s], 0.001 to 2
  float feedback = 0.0f;  // 0 to 0.95: more would take minutes to fade
  float lowPass = 0.0f;   // 0 open to 1 shut, see cutoffOf; acts on every repeat
};

class Echo {
 public:
  explicit Echo(const EchoDef& def);
  /// Adds the repeats of `in` to `out`.
  void process(const Block& in, Block& out);
  /// Nothing sounds in it any more: exact zeros come out until something goes in.
  bool isSilent() const { return silent_; }
  std::size_t bytes() const { return 2 * left_.size() * sizeof(float); }

 private:
  EchoDef def_;
  float step_ = 1.0f;
  std::vector<float> left_, right_;  // as long as the delay
  OnePole lowLeft_, lowRight_;
  std::size_t at_ = 0, quiet_ = 0;  // [samples]
  bool silent_ = true;
};

}  // namespace brittle::audio
