#include "game/view/cues.h"

#include <algorithm>
#include <initializer_list>

#include "engine/math/types.h"

namespace brittle::view {
namespace {

using audio::Sound;
using sim::Event;
using sim::EventType;
using sim::Look;

constexpr std::size_t kMostBreaks = 6, kMostHits = 4;  // per tick
constexpr float kTickSeconds = 1.0f / 60.0f;
constexpr float kUncovered = 0.85f;  // of the masking is left after a tick: half of it after 70 ms
constexpr float kCovers = 0.5f;      // what a sound adds to it, of its loudness
constexpr float kCovered = 0.35f;    // sounds below this share of it are not heard
constexpr float kRainSize = 0.2f;    // smaller things fall unheard [m]
constexpr float kLargeBlast = 5.0f;  // of a reach beyond it [m]
constexpr float kShardSize = 0.2f;   // larger pieces do not tinkle, they knock [m]

/// From 0 at rest to 1 at `full`, rising quickly at first as loudness does. [m/s]
float bySpeed(float speed, float full) {
  const float share = clampTo(speed / full, 0.0f, 1.0f);
  return share * (2.0f - share);
}

/// Where an event happened.
Cue cueAt(const Event& event, const sim::Camera& camera, Sound sound, float gain) {
  Cue cue;
  cue.sound = sound;
  cue.placement = audio::placementOf(camera.rotation.conjugate() * (event.point - camera.position));
  cue.gain = gain;
  return cue;
}

/// Heard by the player wherever it happened.
Cue signal(Sound sound, float gain, std::int32_t variation = -1, float delay = 0.0f) {
  Cue cue;
  cue.sound = sound;
  cue.gain = gain;
  cue.variation = variation;
  cue.delay = delay;
  return cue;
}

Sound breakOf(const Event& event) {
  if (event.look == Look::Wood) return Sound::OnWood;
  if (event.look == Look::Metal || event.look == Look::Door) return Sound::OnMetal;
  if (event.look == Look::Stone || event.look == Look::Static) return Sound::OnStone;
  if (event.look == Look::Crystal || event.size < 0.25f) return Sound::GlassSmall;
  return event.size < 0.5f ? Sound::GlassMedium : Sound::GlassLarge;
}

/// `normal`: of the surface, either way.
Sound knockOn(Look look, const Vec3& normal) {
  switch (look) {
    case Look::Metal:
    case Look::Door:
      return Sound::OnMetal;
    case Look::Wood:
      return Sound::OnWood;
    case Look::Glass:
    case Look::Crystal:
    case Look::PowerUp:
      return Sound::OnGlass;
    case Look::Ball:
      return Sound::OnSteel;
    case Look::Static:
    case Look::Stone:
      break;
  }
  const bool isFlat = normal.y() * normal.y() > 0.5f;
  return isFlat ? Sound::OnStone : Sound::OnWall;
}

Cue hitCue(const Event& event, const sim::Camera& camera) {
  const auto cue = [&](Sound sound, float gain) { return cueAt(event, camera, sound, gain); };
  const bool onGlass = event.look == Look::Glass || event.look == Look::Crystal;
  if (event.striker == Look::Ball)
    return cue(knockOn(event.look, event.direction), (onGlass ? 0.4f : 0.8f) * bySpeed(event.speed, 16.0f));
  const float weight = clampTo(event.size / 0.25f, 0.1f, 1.0f);
  const bool isGlass = event.striker == Look::Glass || event.striker == Look::Crystal;
  if (!isGlass) return cue(knockOn(event.striker, event.direction), 0.6f * weight * bySpeed(event.speed, 8.0f));
  if (event.size > kShardSize) return cue(Sound::OnGlass, 0.3f * weight * bySpeed(event.speed, 8.0f));
  const Sound tinkle = event.size < 0.07f   ? Sound::TinkleSmall
                       : event.size < 0.12f ? Sound::TinkleMedium
                                            : Sound::TinkleLarge;
  return cue(tinkle, 0.4f * weight * bySpeed(event.speed, 8.0f));
}

/// By what is pushed aside in a second, about: size squared times speed. A ball at its full speed is a heavy thing.
Cue splashCue(const Event& event, const sim::Camera& camera) {
  const float weight = event.size * event.size * event.speed;
  const Sound sound = weight < 0.01f   ? Sound::SplashDrip
                      : weight < 0.06f ? Sound::SplashSmall
                      : weight < 0.30f ? Sound::SplashMedium
                                       : Sound::SplashLarge;
  return cueAt(event, camera, sound, 0.35f + 0.55f * bySpeed(weight, 0.6f));
}

constexpr std::uint64_t kHumEvery = 48;         // ticks: half of its length
constexpr float kHumReach = 14.0f;              // beams farther away are not heard [m]
constexpr float kBurnReach = 0.6f;              // a crash this near to one is its doing [m]
constexpr float kCrackleChance = 1.0f / 25.0f;  // in a tick

Vec3 nearestOf(const sim::BeamView& beam, const Vec3& to) {
  const Vec3 line = beam.to - beam.from;
  return beam.from + line * clampTo((to - beam.from).dot(line) / maxOf(line.squaredNorm(), 1e-12f), 0.0f, 1.0f);
}

/// The nearest laser hums without a break, crackles now and then where it ends, and bursts when it strikes.
void addLaserCues(const sim::FramePacket& packet, Random& random, std::vector<Cue>& cues) {
  const Vec3 ear = packet.camera.position;
  const sim::BeamView* nearest = nullptr;
  float distance = kHumReach;
  for (const sim::RoomView& room : packet.rooms)
    for (const sim::BeamView& beam : room.beams) {
      const float away = (nearestOf(beam, ear) - ear).norm();
      if (away >= distance) continue;
      distance = away;
      nearest = &beam;
    }
  if (nearest == nullptr) return;
  Event event;
  event.point = nearestOf(*nearest, ear);
  if (packet.tick % kHumEvery == 0) cues.push_back(cueAt(event, packet.camera, Sound::LaserHum, 0.30f));
  const bool struck = std::any_of(packet.events.begin(), packet.events.end(),
                                  [](const Event& e) { return e.type == EventType::Crash; });
  if (struck && distance < kBurnReach) cues.push_back(cueAt(event, packet.camera, Sound::LaserDischarge, 0.8f));
  event.point = nearest->to;
  if (nearest->hits && random.nextFloat() < kCrackleChance)
    cues.push_back(cueAt(event, packet.camera, Sound::LaserHit, 0.35f));
}

struct Cues {
  std::vector<Cue> breaks, hits, others;
};

void addBreak(const Event& event, const sim::Camera& camera, Random& random, Cues& cues) {
  cues.breaks.push_back(cueAt(event, camera, breakOf(event), 0.55f + 0.45f * bySpeed(event.speed, 20.0f)));
  const float fall = random.nextFloat(0.15f, 0.35f);
  if (event.look != Look::Glass || event.size < kRainSize) return;
  Cue rain = cueAt(event, camera, Sound::ShardRain, 0.22f * minOf(event.size / 0.5f, 1.3f));
  rain.delay = fall;
  cues.others.push_back(rain);
}

/// Crystals climb the scale with the streak; at its top they go round its upper notes.
std::int32_t noteOf(std::int32_t streak) {
  constexpr std::int32_t kTop = audio::kNotes, kRound = 5;
  const std::int32_t step = maxOf(streak, 1) - 1;
  return step < kTop ? step : kTop - kRound + (step - kTop) % kRound;
}

void addChord(std::initializer_list<std::int32_t> notes, float apart, float gain, float pitch, std::vector<Cue>& cues) {
  float delay = 0.0f;
  for (const std::int32_t note : notes) {
    cues.push_back(signal(Sound::Note, gain, note, delay));
    cues.back().pitch = pitch;
    delay += apart;
  }
}

void addScriptSound(const Event& event, const sim::FramePacket& packet, std::vector<Cue>& cues) {
  if (event.value < 0 || static_cast<std::size_t>(event.value) >= packet.soundNames.size()) return;
  const std::optional<Sound> sound = soundNamed(packet.soundNames[static_cast<std::size_t>(event.value)]);
  if (sound) cues.push_back(cueAt(event, packet.camera, *sound, 0.8f * event.size));
}

bool isSlowMotion(const Event& event) {
  return event.value == static_cast<std::int32_t>(sim::PowerUp::SlowMotion);
}

/// A cracker where nothing bursts, a nitro ball among glass, a barrel.
Sound blastOf(const Event& event) {
  if (event.size > kLargeBlast) return Sound::BlastLarge;
  return event.value > 0 ? Sound::BlastMedium : Sound::BlastSmall;
}

void addOther(const Event& event, const sim::FramePacket& packet, std::int32_t streakBefore, std::vector<Cue>& cues) {
  switch (event.type) {
    case EventType::Throw:
      if (cues.empty() || cues.back().sound != Sound::Throw) cues.push_back(signal(Sound::Throw, 0.22f));
      break;
    case EventType::Crystal:
      cues.push_back(signal(Sound::Note, 0.22f, noteOf(packet.hud.streak)));
      break;
    case EventType::CrystalMissed:
      if (streakBefore > 0) cues.push_back(signal(Sound::Missed, 0.12f));
      break;
    case EventType::Crash:
      cues.push_back(signal(Sound::Crash, 0.85f));
      break;
    case EventType::Cleared:
      cues.push_back(signal(Sound::Note, 0.12f, event.value));
      break;
    case EventType::DoorOpens:
      cues.push_back(cueAt(event, packet.camera, Sound::Door, 0.7f));
      break;
    case EventType::Multiball:
      addChord({5, 7, 8}, 0.09f, 0.16f, 1.0f, cues);
      break;
    case EventType::Checkpoint:
      addChord({0, 2, 3, 5}, 0.14f, 0.2f, 1.0f, cues);
      break;
    case EventType::GameOver:
      addChord({5, 4, 2, 0}, 0.22f, 0.2f, 0.5f, cues);
      break;
    case EventType::Begin:
      addChord({0, 3, 5}, 0.1f, 0.14f, 1.0f, cues);
      break;
    case EventType::Splash:
      cues.push_back(splashCue(event, packet.camera));
      break;
    case EventType::Sound:
      addScriptSound(event, packet, cues);
      break;
    case EventType::PowerUpCollected:
      cues.push_back(signal(Sound::PowerUpTaken, 0.3f));
      break;
    case EventType::PowerUpUsed:
      cues.push_back(signal(isSlowMotion(event) ? Sound::TimeSlows : Sound::PowerUpBegins, 0.35f));
      break;
    case EventType::PowerUpEnded:
      cues.push_back(signal(isSlowMotion(event) ? Sound::TimeReturns : Sound::PowerUpEnds, 0.3f));
      break;
    case EventType::Explosion:
      cues.push_back(cueAt(event, packet.camera, blastOf(event), 1.0f));
      break;
    default:
      break;
  }
}

float loudnessOf(const Cue& cue) {
  return cue.gain * cue.placement.loudness();
}

/// Leaves the loudest, and of those what is not covered by what was heard already. They did not all happen as the tick
/// began.
void keepHeard(std::vector<Cue>& cues, std::size_t most, Masking& masking, Random& random) {
  std::stable_sort(cues.begin(), cues.end(), [](const Cue& a, const Cue& b) { return loudnessOf(a) > loudnessOf(b); });
  if (cues.size() > most) {
    masking.quiet += cues.size() - most;
    cues.resize(most);
  }
  std::size_t kept = 0;
  for (Cue& cue : cues) {
    cue.delay += kept > 0 ? random.nextFloat(0.0f, kTickSeconds) : 0.0f;
    if (loudnessOf(cue) < kCovered * masking.level) break;
    masking.level += kCovers * loudnessOf(cue);
    ++kept;
  }
  masking.covered += cues.size() - kept;
  cues.resize(kept);
}

}  // namespace

std::vector<Cue> cuesOf(const sim::FramePacket& packet, std::int32_t streakBefore, Masking& masking, Random& random) {
  Cues cues;
  for (const Event& event : packet.events) {
    if (event.type == EventType::Break) {
      addBreak(event, packet.camera, random, cues);
    } else if (event.type == EventType::Hit) {
      cues.hits.push_back(hitCue(event, packet.camera));
    } else {
      addOther(event, packet, streakBefore, cues.others);
    }
  }
  addLaserCues(packet, random, cues.others);
  masking.level *= kUncovered;
  keepHeard(cues.breaks, kMostBreaks, masking, random);
  keepHeard(cues.hits, kMostHits, masking, random);
  for (const std::vector<Cue>* more : {&cues.hits, &cues.others})
    cues.breaks.insert(cues.breaks.end(), more->begin(), more->end());
  return cues.breaks;
}

std::optional<Sound> soundNamed(const std::string& path) {
  struct Word {
    const char* word;
    Sound sound;
  };
  constexpr Word kWords[] = {{"discharge", Sound::LaserDischarge},
                             {"laser", Sound::LaserHit},
                             {"splash", Sound::SplashMedium},
                             {"break", Sound::GlassMedium},
                             {"shatter", Sound::GlassMedium},
                             {"crash", Sound::Crash},
                             {"explo", Sound::Crash},
                             {"boom", Sound::Crash},
                             {"door", Sound::Door},
                             {"open", Sound::Door},
                             {"clear", Sound::Note},
                             {"score", Sound::Note},
                             {"crystal", Sound::Note},
                             {"note", Sound::Note},
                             {"shoot", Sound::Throw},
                             {"swoosh", Sound::Throw},
                             {"metal", Sound::OnMetal},
                             {"wood", Sound::OnWood},
                             {"stone", Sound::OnStone},
                             {"glass", Sound::OnGlass},
                             {"button", Sound::OnMetal},
                             {"hit", Sound::OnStone}};
  for (const Word& known : kWords)
    if (path.find(known.word) != std::string::npos) return known.sound;
  return std::nullopt;
}

}  // namespace brittle::view
