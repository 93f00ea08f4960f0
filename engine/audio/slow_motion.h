// audio/slow_motion.h - time that gets slower and faster again, as sound: the module of Effect::SlowMotion.
#pragma once

#include "engine/audio/clip.h"

namespace brittle::audio {

/// A chord that sinks by two octaves as what turns runs down; `rising`: it comes up again, in half the time.
Samples timeBend(bool rising);

}  // namespace brittle::audio
