// The music of a room among its sounds.
#include "engine/math/trig.h"
#include "game/view/music.h"
#include "game/view/sound.h"

namespace brittle::view {
namespace {

constexpr float kMusicWorth =
    8.0f;  // a chord that stops in the middle is noticed sooner than a shard that does not fall

audio::VoiceDef noteVoice(const MusicNote& note, const audio::Instruments& instruments) {
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
  if (!instruments_) instruments_ = std::make_unique<audio::Instruments>();
  for (const MusicNote& note : notesAt(packet.rooms.front().music, tick)) mixer_.play(noteVoice(note, *instruments_));
}

}  // namespace brittle::view
