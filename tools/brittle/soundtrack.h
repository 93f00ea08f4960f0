// brittle/soundtrack.h - the sound of a replay as a file: the mix that is heard when it is played, one tick of 800
// samples per frame.
#pragma once

#include <string>

#include "engine/core/result.h"
#include "engine/replay/replay.h"
#include "tools/brittle/game.h"
#include "tools/brittle/options.h"

namespace brittle::program {

/// Writes the sound of the frames as 16 bits stereo at 48 kHz: sample 800 n is heard as the n-th of them is seen. Plays
/// `simulation`, which is at the replay's start, from there whatever the frames, since what rings on belongs to them: a
/// range is cut out of the whole.
Status writeSoundtrack(const replay::Replay& replay, GameSimulation& simulation, const FrameRange& frames,
                       const std::string& path);

}  // namespace brittle::program
