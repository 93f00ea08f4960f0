#include "engine/audio/mixer.h"

#include "engine/core/assert.h"
#include "engine/effects/has/low_pass.h"

namespace brittle::audio {

Mixer::~Mixer() {
  Command command;
  while (commands_.pop(command)) delete command.space;
  collect();
  delete space_;
  delete leaving_;
}

void Mixer::send(const Command& command) {
  if (commands_.push(command)) return;
  ++refused_;
  if (command.space != nullptr) spaceBytes_ -= command.space->bytes();
  delete command.space;
}

const char* nameOf(Omission omission) {
  constexpr const char* names[] = {"sound orders refused", "sounds without voice", "sounds cut off"};
  return names[static_cast<int>(omission)];
}

void Mixer::omissions(std::vector<NamedCount>& counts) const {
  Tally<Omission> all;
  all.add(Omission::Order, refused_);
  all.add(Omission::RefusedVoice, refusedVoices_.load(std::memory_order_relaxed));
  all.add(Omission::EndedVoice, endedVoices_.load(std::memory_order_relaxed));
  all.list(counts);
}

/// Frees what the audio thread is done with.
void Mixer::collect() {
  Space* space = nullptr;
  while (retired_.pop(space)) {
    spaceBytes_ -= space->bytes();
    delete space;
  }
}

void Mixer::setAcoustics(const Acoustics& acoustics) {
  collect();
  Command command{Command::Room, {}, nullptr, acoustics.lowPass};
  if (acoustics.hasSpace()) {
    command.space = new Space(acoustics);
    spaceBytes_ += command.space->bytes();
  }
  send(command);
}

void Mixer::silence() {
  collect();
  send({Command::Silence, {}, nullptr, 0.0f});
}

void Mixer::retire(Space*& space) {
  const bool kept = space == nullptr || retired_.push(space);
  BR_ASSERT(kept);
  space = nullptr;
}

void Mixer::obey(const Command& command) {
  switch (command.kind) {
    case Command::Play:
      voices_.play(command.voice);
      refusedVoices_.store(voices_.refused(), std::memory_order_relaxed);
      endedVoices_.store(voices_.ended(), std::memory_order_relaxed);
      break;
    case Command::Rate:
      rate_ = clampTo(command.number, 0.0625f, 4.0f);
      break;
    case Command::LowPass:
      lowPassGoal_ = clampTo(command.number, 0.0f, 1.0f);
      break;
    case Command::Room:
      retire(leaving_);
      leaving_ = space_;
      space_ = command.space;
      lowPassGoal_ = command.number;
      break;
    case Command::Silence:
      voices_.stop();
      retire(leaving_);
      retire(space_);
      lowPass_ = lowPassGoal_ = 0.0f;
      break;
  }
}

void Mixer::render(std::span<float> stereo) {
  Command command;
  while (commands_.pop(command)) obey(command);
  for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
    if (given_ == kBlockFrames) renderBlock();
    stereo[i] = block_.left[given_];
    stereo[i + 1] = block_.right[given_++];
  }
}

void Mixer::renderBlock() {
  block_ = {};
  Block sent;
  voices_.render(rate_, block_, space_ != nullptr ? &sent : nullptr);
  renderSpaces(sent);
  if constexpr (effects::kHasLowPass) applyLowPass();
  limiter_.process(block_);
  given_ = 0;
}

void Mixer::renderSpaces(const Block& sent) {
  if (space_ != nullptr) space_->process(sent, block_);
  if (leaving_ == nullptr) return;
  leaving_->process(Block{}, block_);
  if (leaving_->isSilent()) retire(leaving_);
}

}  // namespace brittle::audio
