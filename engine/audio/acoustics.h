// audio/acoustics.h - what a room does to its sounds. Only what is asked for is made: a room without reverb and echo
// has no memory here and no stage that runs.
#pragma once

#include <optional>

#include "engine/audio/block.h"
#include "engine/audio/echo.h"
#include "engine/audio/reverb.h"

namespace brittle::audio {

struct Acoustics {
  ReverbDef reverb;      // volume 0: none
  EchoDef echo;          // volume 0: none
  float lowPass = 0.0f;  // of all that is heard, 0 open to 1 shut, see cutoffOf

  bool hasSpace() const { return reverb.volume > 0.0f || echo.volume > 0.0f; }
};

/// Any numbers as ones that the effects here take: not a number counts as 0.
Acoustics withinLimits(Acoustics asked);

class Space {
 public:
  explicit Space(const Acoustics& acoustics);
  /// Adds what comes back of `in` to `out`.
  void process(const Block& in, Block& out);
  bool isSilent() const;
  std::size_t bytes() const;

 private:
  std::optional<Reverb> reverb_;
  std::optional<Echo> echo_;
};

}  // namespace brittle::audio
