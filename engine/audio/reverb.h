// audio/reverb.h - a room as a feedback delay network: eight delays whose outputs are mixed and fed back, each losing
// just so much per pass that everything decays in the time asked for, high frequencies in half of it. Source: Jot and
// Chaigne, Digital Delay Networks for Designing Artificial Reverberators, 1991 (absorbing filters per delay).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/audio/block.h"
#include "engine/audio/filter.h"

namespace brittle::audio {

struct ReverbDef {
  float volume = 0.0f;   // energy of the reverb over that of the sound, as an amplitude; 0 to 1
  float time = 1.0f;     // until it has fallen by 60 dB [s], 0.05 to 10
  float lowPass = 0.0f;  // 0 open to 1 shut, see cutoffOf
};

class Reverb {
 public:
  explicit Reverb(const ReverbDef& def);
  /// Adds the reverb of `in` to `out`.
  void process(const Block& in, Block& out);
  /// Nothing sounds in it any more: exact zeros come out until something goes in.
  bool isSilent() const { return silent_; }
  std::size_t bytes() const;

 private:
  static constexpr std::size_t kLines = 8;
  struct Delay {
    std::vector<float> samples;
    std::size_t at = 0;
    float read() const { return samples[at]; }
    void write(float value) {
      samples[at] = value;
      at = at + 1 == samples.size() ? 0 : at + 1;
    }
  };
  struct Line {
    Delay delay;
    float gain = 0.0f, step = 1.0f;  // per pass: of everything, and of the one-pole that takes the highs
    OnePole damping;
  };
  /// Smears a click into a burst: the echoes are dense from the start.
  struct Diffuser {
    Delay delay;
    float process(float in);
  };

  float step(float left, float right, float& outLeft, float& outRight);
  void rest();

  std::array<Line, kLines> lines_;
  std::array<std::array<Diffuser, 2>, 2> diffusers_;  // of the left and the right
  OnePole colorLeft_, colorRight_;
  float color_ = 1.0f, gain_ = 0.0f;
  std::size_t longest_ = 0, quiet_ = 0;  // [samples]
  bool silent_ = true;
};

}  // namespace brittle::audio
