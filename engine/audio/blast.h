// audio/blast.h - explosions as sound: the module of Effect::Explosions.
#pragma once

#include "engine/audio/clip.h"
#include "engine/core/random.h"

namespace brittle::audio {

/// A blast; `size` from 0, a cracker, to 1, a barrel: deeper, longer.
Samples blast(float size, Random& random);

}  // namespace brittle::audio
