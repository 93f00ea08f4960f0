#include "game/view/sound.h"

#include <cmath>

#include "engine/core/log.h"
#include "engine/effects/has/music.h"
#include "game/sim/constants.h"

namespace brittle::view {
namespace {

constexpr std::uint64_t kStream = 0x50554e44;
constexpr float kUnderWater = 0.55f;  // low-pass while time runs slowest: 1.6 kHz
constexpr float kSlowest = static_cast<float>(sim::rules::kSlowestShare) / 256.0f;
constexpr float kDetune = 0.05f;  // sounds of things differ by up to this share of their pitch; notes do not

audio::VoiceDef voiceOf(const Cue& cue, const audio::Bank& bank, Random& random) {
  const std::uint32_t any = random.nextBelow(bank.variations(cue.sound));
  const float detune = random.nextFloat(1.0f - kDetune, 1.0f + kDetune);
  const bool isNote = cue.sound == audio::Sound::Note;
  audio::VoiceDef voice;
  voice.clip = &bank.clip(cue.sound, cue.variation < 0 ? any : static_cast<std::uint32_t>(cue.variation));
  voice.left = cue.gain * cue.placement.left;
  voice.right = cue.gain * cue.placement.right;
  voice.send = cue.placement.send;
  voice.cutoff = cue.placement.cutoff;
  voice.pitch = isNote ? cue.pitch : cue.pitch * detune;
  voice.delay = static_cast<std::uint32_t>(audio::samplesIn(cue.delay));
  return voice;
}

}  // namespace

void Sound::tick(const sim::FramePacket& packet) {
  enterRoom(packet);
  for (const sim::RoomView& room : packet.rooms)
    if (!room.pickups.empty()) mixer_.bank().prepare(audio::Sound::PowerUpTaken);  // before a ball hits it
  for (const sim::Event& event : packet.events) reportUnknown(event, packet.soundNames);
  Random random(mixSeed(kStream, packet.tick));
  for (const Cue& cue : cuesOf(packet, streak_, masking_, random)) mixer_.play(voiceOf(cue, mixer_.bank(), random));
  followTime(packet);
  streak_ = packet.hud.streak;
  if constexpr (effects::kHasMusic) playMusic(packet);
}

/// Slow motion sounds as under water: lower, an octave at a quarter of the speed, and dull.
void Sound::followTime(const sim::FramePacket& packet) {
  if (packet.timeShare == timeShare_) return;
  timeShare_ = packet.timeShare;
  mixer_.setRate(std::sqrt(timeShare_));
  mixer_.setLowPass(lowPassOf(packet));
}

float lowPassOf(const sim::FramePacket& packet) {
  const float ownAmount = packet.rooms.empty() ? 0.0f : acousticsOf(packet.rooms.front()).lowPass;
  return maxOf(ownAmount, kUnderWater * (1.0f - packet.timeShare) / (1.0f - kSlowest));
}

std::int32_t musicTickOf(const sim::FramePacket& packet) {
  const bool isTitle = packet.hud.phase == sim::Phase::Title;
  return isTitle ? static_cast<std::int32_t>(packet.hud.phaseTicks) : packet.rooms.front().ticks;
}

void Sound::enterRoom(const sim::FramePacket& packet) {
  if (packet.rooms.empty() || (knowsRoom_ && packet.rooms.front().number == room_)) return;
  knowsRoom_ = true;
  room_ = packet.rooms.front().number;
  mixer_.setAcoustics(acousticsOf(packet.rooms.front()));
  if (timeShare_ < 1.0f) mixer_.setLowPass(lowPassOf(packet));
}

void Sound::reportUnknown(const sim::Event& event, const std::vector<std::string>& names) {
  if (event.type != sim::EventType::Sound || event.value < 0 || static_cast<std::size_t>(event.value) >= names.size())
    return;
  const std::string& name = names[static_cast<std::size_t>(event.value)];
  if (soundNamed(name) || !unknown_.insert(name).second) return;
  logWarning("sound " + name + ": no sound here goes by that name, it stays silent");
}

void Sound::reset() {
  mixer_.silence();
  if (timeShare_ != 1.0f) mixer_.setRate(1.0f);
  timeShare_ = 1.0f;
  knowsRoom_ = false;
  musicTick_ = -1;
  waiting_.clear();
  masking_ = {};
  streak_ = 0;
}

std::vector<NamedCount> Sound::omissions() const {
  Tally<Omission> own;
  own.add(Omission::QuietSound, masking_.quiet);
  own.add(Omission::CoveredSound, masking_.covered);
  std::vector<NamedCount> counts;
  own.list(counts);
  mixer_.omissions(counts);
  return counts;
}

audio::Acoustics acousticsOf(const sim::RoomView& room) {
  audio::Acoustics asked;
  if (room.effects.has(effects::Effect::Reverb)) asked.reverb = {room.reverb[0], room.reverb[1], room.reverb[2]};
  if (room.effects.has(effects::Effect::Echo)) asked.echo = {room.echo[0], room.echo[1], room.echo[2], room.echo[3]};
  if (room.effects.has(effects::Effect::LowPass)) asked.lowPass = room.lowPass;
  return audio::withinLimits(asked);
}

}  // namespace brittle::view
