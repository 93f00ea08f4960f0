#include "engine/audio/bank.h"

#include "engine/audio/blast.h"
#include "engine/audio/slow_motion.h"
#include "engine/audio/synthesis.h"
#include "engine/core/profile.h"
#include "engine/effects/has/explosions.h"
#include "engine/effects/has/lasers.h"
#include "engine/effects/has/slow_motion.h"
#include "engine/effects/has/water.h"

namespace brittle::audio {
namespace {

/// How many variations it takes until repeats are not noticed: more of what is heard often.
std::uint32_t countOf(Sound sound) {
  switch (sound) {
    case Sound::Note:
      return kNotes;
    case Sound::Missed:
    case Sound::Door:
    case Sound::Crash:
    case Sound::PowerUpTaken:
    case Sound::PowerUpBegins:
    case Sound::PowerUpEnds:
      return 1;
    case Sound::BlastSmall:
    case Sound::BlastMedium:
    case Sound::BlastLarge:
      return 3;
    case Sound::TimeSlows:
    case Sound::TimeReturns:
      return 1;
    case Sound::Throw:
    case Sound::ShardRain:
      return 3;
    case Sound::TinkleSmall:
    case Sound::TinkleMedium:
    case Sound::TinkleLarge:
      return 8;
    default:
      return 4;
  }
}

Samples ofModule(Sound sound, Random& random) {
  if constexpr (effects::kHasExplosions) {
    if (sound == Sound::BlastSmall) return blast(0.0f, random);
    if (sound == Sound::BlastMedium) return blast(0.4f, random);
    if (sound == Sound::BlastLarge) return blast(1.0f, random);
  }
  if constexpr (effects::kHasSlowMotion)
    if (sound == Sound::TimeSlows || sound == Sound::TimeReturns) return timeBend(sound == Sound::TimeReturns);
  if constexpr (effects::kHasWater)
    if (const int size = static_cast<int>(sound) - static_cast<int>(Sound::SplashDrip); size >= 0 && size < 4)
      return splash(size, random);
  if constexpr (effects::kHasLasers) {
    if (sound == Sound::LaserHum) return laserHum(random);
    if (sound == Sound::LaserHit) return laserHit(random);
    if (sound == Sound::LaserDischarge) return laserDischarge(random);
  }
  return {0.0f};  // of a module that is not there
}

Samples synthesize(Sound sound, std::uint32_t variation, Random& random) {
  switch (sound) {
    case Sound::GlassSmall:
      return glassBreak(0.14f, random);
    case Sound::GlassMedium:
      return glassBreak(0.35f, random);
    case Sound::GlassLarge:
      return glassBreak(0.75f, random);
    case Sound::ShardRain:
      return shardRain(random);
    case Sound::TinkleSmall:
      return tinkle(0.045f, random);
    case Sound::TinkleMedium:
      return tinkle(0.065f, random);
    case Sound::TinkleLarge:
      return tinkle(0.1f, random);
    case Sound::OnStone:
      return knock(Struck::Stone, random);
    case Sound::OnWall:
      return knock(Struck::Wall, random);
    case Sound::OnMetal:
      return knock(Struck::Metal, random);
    case Sound::OnWood:
      return knock(Struck::Wood, random);
    case Sound::OnGlass:
      return knock(Struck::Glass, random);
    case Sound::OnSteel:
      return knock(Struck::Steel, random);
    case Sound::Note:
      return bell(pitchOf(kNoteNumbers[variation]));
    case Sound::Missed:
      return sigh();
    case Sound::Door:
      return door(random);
    case Sound::Crash:
      return crash(random);
    case Sound::Throw:
      return swoosh(random);
    case Sound::PowerUpTaken:
      return powerUpTaken();
    case Sound::PowerUpBegins:
      return powerUpBegins(random);
    case Sound::PowerUpEnds:
      return powerUpEnds(random);
    default:
      return ofModule(sound, random);
  }
}

std::vector<Clip> compute(Sound sound) {
  std::vector<Clip> clips;
  for (std::uint32_t variation = 0; variation < countOf(sound); ++variation) {
    Random random(mixSeed(static_cast<std::uint64_t>(sound), variation));
    clips.emplace_back(synthesize(sound, variation, random));
  }
  return clips;
}

}  // namespace

const char* nameOf(Sound sound) {
  constexpr const char* kNames[] = {
      "glass_small",     "glass_medium",   "glass_large",     "shard_rain",    "tinkle_small", "tinkle_medium",
      "tinkle_large",    "on_stone",       "on_wall",         "on_metal",      "on_wood",      "on_glass",
      "on_steel",        "note",           "missed",          "door",          "crash",        "throw",
      "splash_drip",     "splash_small",   "splash_medium",   "splash_large",  "laser_hum",    "laser_hit",
      "laser_discharge", "power_up_taken", "power_up_begins", "power_up_ends", "blast_small",  "blast_medium",
      "blast_large",     "time_slows",     "time_returns"};
  static_assert(sizeof kNames / sizeof *kNames == static_cast<std::size_t>(Sound::Count));
  return sound < Sound::Count ? kNames[static_cast<std::size_t>(sound)] : "none";
}

Bank::Bank() {
  BR_ZONE("bank");
  for (Sound sound = Sound::GlassSmall; !isLate(sound); sound = static_cast<Sound>(static_cast<int>(sound) + 1))
    clips_[static_cast<std::size_t>(sound)] = compute(sound);
}

const Bank::Clips& Bank::clipsOf(Sound sound) const {
  Clips& clips = clips_[static_cast<std::size_t>(sound)];
  if (clips.empty()) clips = compute(sound);
  return clips;
}

std::size_t Bank::bytes() const {
  std::size_t sum = 0;
  for (const std::vector<Clip>& clips : clips_)
    for (const Clip& clip : clips) sum += clip.bytes();
  return sum;
}

}  // namespace brittle::audio
