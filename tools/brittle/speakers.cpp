#include "tools/brittle/speakers.h"

#include <utility>

#include "engine/core/log.h"
#include "game/view/sound.h"
#include "platform/sdl/audio_output.h"

namespace brittle::program {

struct Speakers::Parts {
  audio::Bank bank;
  audio::Mixer mixer{bank};
  view::Sound sound{mixer};
  std::unique_ptr<platform::AudioOutput> output;  // goes first: its thread uses the others
};

std::unique_ptr<Speakers> Speakers::open() {
  auto parts = std::make_unique<Parts>();
  auto output = platform::openAudio(parts->mixer);
  if (!output) {
    logWarning(output.error().message + "; playing in silence");
    return nullptr;
  }
  parts->output = std::move(*output);
  return std::unique_ptr<Speakers>(new Speakers(std::move(parts)));
}

Speakers::Speakers(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Speakers::~Speakers() = default;

void Speakers::ticked(const sim::FramePacket& packet) {
  parts_->sound.tick(packet);
}

void Speakers::restarted() {
  parts_->sound.reset();
}

std::vector<NamedCount> Speakers::omissions() const {
  return parts_->sound.omissions();
}

}  // namespace brittle::program
