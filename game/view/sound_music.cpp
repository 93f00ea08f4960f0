// The music of a room among its sounds.
#include "engine/math/trig.h"
#include "game/view/sound.h"

namespace brittle::view {
namespace {

constexpr float kMusicWorth =
    8.0f;  // a chord that stops in the middle is noticed sooner than a shard that does not fall

audio::VoiceDef noteVoice(const MusicNote& note, audio::Instruments& instruments) {
  const audio::Instruments::Tone tone = instruments.tone(note.instrument, note.note);
  const float angle = 0.25f * kPi * (1.0f + note.side);
  audio::VoiceDef voice;
  voice.clip = tone.clip;
  voice.pitch = tone.pitch;
  voice.left = note.gain * cosine(angle);
  voice.right = note.gain * sine(angle);
  voice.send = 0.5f;
  voice.worth = kMusicWorth;
  return voice;
}

}  // namespace

void Sound::playMusic(const sim::FramePacket& packet) {
  if (packet.rooms.empty() || !packet.rooms.front().effects.has(effects::Effect::Music)) return;
  const std::int32_t tick = musicTickOf(packet);
  if (tick == musicTick_) return;  // the game stands still
  musicTick_ = tick;
  const std::vector<MusicNote> notes = notesAt(packet.rooms.front().music, tick);
  waiting_.insert(waiting_.end(), notes.begin(), notes.end());
  playWaiting();
}

/// A chord of tones that were never played would take longer to compute than a tick lasts: it makes one a tick, and
/// what needs another waits for a sixtieth of a second or two.
void Sound::playWaiting() {
  bool hasMade = false;
  std::erase_if(waiting_, [&](const MusicNote& note) {
    const bool isMade = instruments_.isMade(note.instrument, note.note);
    if (!isMade && hasMade) return false;
    hasMade = hasMade || !isMade;
    mixer_.play(noteVoice(note, instruments_));
    return true;
  });
}

}  // namespace brittle::view
