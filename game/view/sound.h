// view/sound.h - what is heard of a game: the events of each tick become voices, the room's settings its acoustics. A
// function of the packets alone, like the picture: which of several takes of a sound is heard, how high and how exactly
// when comes from a random stream of the tick's own.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "engine/audio/instruments.h"
#include "engine/audio/mixer.h"
#include "game/sim/frame_packet.h"
#include "game/view/cues.h"
#include "game/view/music.h"
#include "game/view/omission.h"

namespace brittle::view {

class Sound {
 public:
  /// `mixer` must outlive it.
  explicit Sound(audio::Mixer& mixer) : mixer_(mixer) {}

  /// After every tick.
  void tick(const sim::FramePacket& packet);
  /// Another game follows: ends all sounds.
  void reset();
  /// What was left out since then, here and by the mixer: of each kind that is not zero.
  std::vector<NamedCount> omissions() const;
  const audio::Instruments& instruments() const { return instruments_; }

 private:
  void enterRoom(const sim::FramePacket& packet);
  void playMusic(const sim::FramePacket& packet);
  void playWaiting();
  void followTime(const sim::FramePacket& packet);
  void reportUnknown(const sim::Event& event, const std::vector<std::string>& names);

  audio::Mixer& mixer_;
  std::uint64_t room_ = 0;
  bool knowsRoom_ = false;
  audio::Instruments instruments_;
  std::vector<MusicNote> waiting_;  // for their tones
  std::int32_t musicTick_ = -1;     // played last
  float timeShare_ = 1.0f;          // as the mixer has it
  Masking masking_;
  std::int32_t streak_ = 0;        // before this tick
  std::set<std::string> unknown_;  // names of script sounds that were reported
};

/// How far a room's music has come: before the first room the title has its own time.
std::int32_t musicTickOf(const sim::FramePacket& packet);

/// The low-pass of all that is heard: the room's, or slow motion's if that is more.
float lowPassOf(const sim::FramePacket& packet);

/// A room's settings as the mixer takes them: any number is brought within limits.
audio::Acoustics acousticsOf(const sim::RoomView& room);

}  // namespace brittle::view
