#include "tools/brittle/soundtrack.h"

#include <vector>

#include "engine/audio/wav.h"
#include "game/sim/constants.h"
#include "game/view/sound.h"
#include "tools/brittle/interrupt.h"
#include "tools/brittle/progress.h"

namespace brittle::program {

Status writeSoundtrack(const replay::Replay& replay, GameSimulation& simulation, const FrameRange& frames,
                       const std::string& path) {
  Result<audio::WavWriter> file = audio::WavWriter::open(path);
  if (!file) return file.error();
  const audio::Bank bank;
  audio::Mixer mixer(bank);
  view::Sound sound(mixer);
  replay::Player player(replay, simulation);
  sim::FramePacket packet;
  std::vector<float> stereo(2 * audio::kSampleRate / sim::rules::kTickRate);
  Progress progress("sound", frames.last);
  while (true) {
    simulation.game().copyFrame(packet);
    sound.tick(packet);
    mixer.render(stereo);
    if (player.tick() >= frames.first) file->write(stereo);
    progress.reached(player.tick());
    if (isInterrupted()) return interruption();
    if (player.tick() >= frames.last) return file->close();
    player.step();
  }
}

}  // namespace brittle::program
