// audio/mixer.h - all that is heard: voices, the room, the limiter. One thread (the game's) tells it what to play, one
// other (the audio callback) takes the mix; they share lock-free queues only, and the callback neither allocates nor
// frees. Used without a device too: then one thread does both, and the mix is a function of what was told between which
// blocks.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/audio/acoustics.h"
#include "engine/audio/bank.h"
#include "engine/audio/limiter.h"
#include "engine/audio/queue.h"
#include "engine/audio/voices.h"
#include "engine/core/tally.h"

namespace brittle::audio {

/// What is not heard, or not to its end.
enum class Omission : std::uint8_t {
  Order,         // the queue to the audio thread was full
  RefusedVoice,  // all voices are taken, by louder sounds
  EndedVoice,    // the quietest gave way
  Count
};
const char* nameOf(Omission omission);

class Mixer {
 public:
  /// `bank` must outlive it.
  explicit Mixer(const Bank& bank) : bank_(bank) {}
  ~Mixer();
  Mixer(const Mixer&) = delete;
  Mixer& operator=(const Mixer&) = delete;

  // The game's thread. What does not fit into the queue is left out and counted.

  const Bank& bank() const { return bank_; }
  /// Plays at the next block. `def.clip` is one of the bank's.
  void play(const VoiceDef& def) { send({Command::Play, def, nullptr, 0.0f}); }
  /// The next room: the last one's reverb rings out while this one's begins. Within limits, see withinLimits.
  void setAcoustics(const Acoustics& acoustics);
  /// Of all that is heard, in place of the room's own until the next room; 0 open to 1 shut.
  void setLowPass(float amount) { send({Command::LowPass, {}, nullptr, amount}); }
  /// Of everything that plays, for slow motion: 1 as it is, from 1/16 to 4.
  void setRate(float rate) { send({Command::Rate, {}, nullptr, rate}); }
  /// Ends all sounds and the room's.
  void silence();
  std::uint32_t refused() const { return refused_; }
  /// Appends what was left out so far, of each kind that is not zero.
  void omissions(std::vector<NamedCount>& counts) const;
  /// Held for rooms. [bytes]
  std::size_t spaceBytes() const { return spaceBytes_.load(std::memory_order_relaxed); }

  // The audio thread.

  /// Fills `stereo`: left and right in turn.
  void render(std::span<float> stereo);
  std::uint32_t activeVoices() const { return voices_.active(); }
  bool hasSpace() const { return space_ != nullptr || leaving_ != nullptr; }

 private:
  struct Command {
    enum Kind : std::uint8_t { Play, Room, LowPass, Rate, Silence } kind = Play;
    VoiceDef voice;
    Space* space = nullptr;
    float number = 0.0f;  // Rate: it; Room, LowPass: the low-pass
  };

  void send(const Command& command);
  void collect();
  void obey(const Command& command);
  void retire(Space*& space);
  void renderBlock();
  void renderSpaces(const Block& sent);
  void applyLowPass();

  const Bank& bank_;
  Queue<Command, 1024> commands_;
  Queue<Space*, 2048> retired_;  // back to the game's thread, which frees them: more than there can be
  std::uint32_t refused_ = 0;
  std::atomic<std::uint32_t> refusedVoices_{0}, endedVoices_{0};  // written by the audio thread
  std::atomic<std::size_t> spaceBytes_{0};

  Voices voices_;
  Space* space_ = nullptr;    // of this room
  Space* leaving_ = nullptr;  // of the last one
  float rate_ = 1.0f;
  float lowPass_ = 0.0f, lowPassGoal_ = 0.0f;
  StateVariable lowLeft_, lowRight_;
  Limiter limiter_;
  Block block_;
  int given_ = kBlockFrames;  // frames of block_ that are rendered already
};

}  // namespace brittle::audio
