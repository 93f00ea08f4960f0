// platform/sdl/audio_output.h - an audio device that plays a mix: SDL asks for samples on a thread of its own, and the
// mixer gives them.
#pragma once

#include <memory>

#include "engine/audio/mixer.h"
#include "engine/core/result.h"

namespace brittle::platform {

/// Plays as long as it lives.
class AudioOutput {
 public:
  virtual ~AudioOutput() = default;
};

/// Opens the system's usual device at 48 kHz stereo. `mixer` must outlive the output. Fails with SDL's words where
/// there is no device.
Result<std::unique_ptr<AudioOutput>> openAudio(audio::Mixer& mixer);

}  // namespace brittle::platform
