#include "game/view/cues.h"

#include <gtest/gtest.h>

#include "packets.h"

namespace brittle::view {
namespace {

using audio::Sound;
using sim::EventType;
using sim::Look;

std::vector<Cue> cuesFor(const std::vector<sim::Event>& events, std::int32_t streak = 0, std::int32_t before = 0) {
  sim::FramePacket packet = packetAt(7);
  packet.events = events;
  packet.hud.streak = streak;
  packet.soundNames = {"snd/fanfare.ogg", "snd/door_open.ogg"};
  Random random(1);
  Masking masking;
  return cuesOf(packet, before, masking, random);
}

sim::Event breakOf(Look look, float size, float speed = 15.0f) {
  sim::Event event = eventOf(EventType::Break, Vec3(0.0f, 1.0f, -8.0f));
  event.look = look;
  event.size = size;
  event.speed = speed;
  return event;
}

sim::Event hitOf(Look striker, Look look, float speed, float size = 0.05f) {
  sim::Event event = eventOf(EventType::Hit, Vec3(0.0f, 0.0f, -5.0f));
  event.striker = striker;
  event.look = look;
  event.speed = speed;
  event.size = size;
  event.direction = Vec3::UnitY();
  return event;
}

bool has(const std::vector<Cue>& cues, Sound sound) {
  for (const Cue& cue : cues)
    if (cue.sound == sound) return true;
  return false;
}

TEST(Cues, GlassBreaksBySizeAndRainsWhenLarge) {
  EXPECT_TRUE(has(cuesFor({breakOf(Look::Glass, 0.15f)}), Sound::GlassSmall));
  EXPECT_TRUE(has(cuesFor({breakOf(Look::Glass, 0.4f)}), Sound::GlassMedium));
  EXPECT_TRUE(has(cuesFor({breakOf(Look::Glass, 0.8f)}), Sound::GlassLarge));
  EXPECT_TRUE(has(cuesFor({breakOf(Look::Crystal, 0.8f)}), Sound::GlassSmall));
  EXPECT_FALSE(has(cuesFor({breakOf(Look::Glass, 0.15f)}), Sound::ShardRain));
  for (const Cue& cue : cuesFor({breakOf(Look::Glass, 0.8f)}))
    EXPECT_TRUE(cue.sound != Sound::ShardRain || cue.delay > 0.1f);
}

TEST(Cues, ABlastHasThreeSizes) {
  sim::Event blast = eventOf(EventType::Explosion, Vec3(0.0f, 1.0f, -6.0f));
  blast.size = 3.0f;
  EXPECT_TRUE(has(cuesFor({blast}), Sound::BlastSmall)) << "nothing burst";
  blast.value = 2;
  EXPECT_TRUE(has(cuesFor({blast}), Sound::BlastMedium));
  blast.size = 9.0f;
  EXPECT_TRUE(has(cuesFor({blast}), Sound::BlastLarge));
}

TEST(Cues, SlowMotionHasSoundsOfItsOwn) {
  for (const auto kind : {sim::PowerUp::BallFrenzy, sim::PowerUp::SlowMotion}) {
    const bool isSlow = kind == sim::PowerUp::SlowMotion;
    sim::Event used = eventOf(EventType::PowerUpUsed, Vec3::Zero()),
               ended = eventOf(EventType::PowerUpEnded, Vec3::Zero());
    used.value = ended.value = static_cast<std::int32_t>(kind);
    EXPECT_TRUE(has(cuesFor({used}), isSlow ? Sound::TimeSlows : Sound::PowerUpBegins));
    EXPECT_TRUE(has(cuesFor({ended}), isSlow ? Sound::TimeReturns : Sound::PowerUpEnds));
  }
  EXPECT_TRUE(has(cuesFor({eventOf(EventType::PowerUpCollected, Vec3::Zero())}), Sound::PowerUpTaken));
}

TEST(Cues, ABallSoundsLikeWhatItHits) {
  const std::pair<Look, Sound> expected[] = {{Look::Static, Sound::OnStone}, {Look::Stone, Sound::OnStone},
                                             {Look::Metal, Sound::OnMetal},  {Look::Door, Sound::OnMetal},
                                             {Look::Wood, Sound::OnWood},    {Look::Glass, Sound::OnGlass},
                                             {Look::Ball, Sound::OnSteel}};
  for (const auto& [look, sound] : expected) {
    const std::vector<Cue> cues = cuesFor({hitOf(Look::Ball, look, 10.0f)});
    ASSERT_EQ(cues.size(), 1u);
    EXPECT_EQ(cues[0].sound, sound);
    EXPECT_FLOAT_EQ(cues[0].placement.loudness(), audio::placementOf(Vec3(0.0f, -1.0f, -5.0f)).loudness());
  }
}

TEST(Cues, FloorsAndWallsDiffer) {
  sim::Event hit = hitOf(Look::Ball, Look::Static, 10.0f);
  for (const float sign : {-1.0f, 1.0f}) {
    hit.direction = sign * Vec3::UnitY();
    EXPECT_EQ(cuesFor({hit})[0].sound, Sound::OnStone);
    hit.direction = sign * Vec3::UnitX();
    EXPECT_EQ(cuesFor({hit})[0].sound, Sound::OnWall);
  }
}

TEST(Cues, ShardsTinkleBySizeAndBigPiecesKnock) {
  EXPECT_EQ(cuesFor({hitOf(Look::Glass, Look::Static, 3.0f, 0.05f)})[0].sound, Sound::TinkleSmall);
  EXPECT_EQ(cuesFor({hitOf(Look::Glass, Look::Static, 3.0f, 0.1f)})[0].sound, Sound::TinkleMedium);
  EXPECT_EQ(cuesFor({hitOf(Look::Glass, Look::Static, 3.0f, 0.15f)})[0].sound, Sound::TinkleLarge);
  EXPECT_EQ(cuesFor({hitOf(Look::Glass, Look::Static, 3.0f, 0.4f)})[0].sound, Sound::OnGlass);
}

TEST(Cues, FasterIsLouder) {
  float before = 0.0f;
  for (const float speed : {0.5f, 2.0f, 6.0f, 12.0f}) {
    const float gain = cuesFor({hitOf(Look::Ball, Look::Static, speed)})[0].gain;
    EXPECT_GT(gain, before);
    before = gain;
  }
  EXPECT_LT(cuesFor({hitOf(Look::Ball, Look::Static, 1e9f)})[0].gain, 1.0f);
}

TEST(Cues, OnlyTheLoudestOfMany) {
  std::vector<sim::Event> hits(100, hitOf(Look::Glass, Look::Static, 2.0f, 0.1f));
  hits.push_back(hitOf(Look::Ball, Look::Static, 14.0f));
  EXPECT_LE(cuesFor(hits).size(), 4u);
  EXPECT_TRUE(has(cuesFor(hits), Sound::OnStone));
  const std::size_t breaks = cuesFor(std::vector<sim::Event>(20, breakOf(Look::Glass, 0.15f))).size();
  EXPECT_LE(breaks, 6u);
  EXPECT_GE(breaks, 2u);
}

TEST(Cues, LoudSoundsCoverQuietOnesForAWhile) {
  sim::FramePacket packet = packetAt(1);
  Random random(1);
  Masking masking;
  packet.events = {breakOf(Look::Glass, 0.8f)};
  cuesOf(packet, 0, masking, random);
  packet.events = {hitOf(Look::Glass, Look::Static, 1.0f)};
  EXPECT_TRUE(cuesOf(packet, 0, masking, random).empty());
  packet.events.clear();
  for (int tick = 0; tick < 60; ++tick) cuesOf(packet, 0, masking, random);
  packet.events = {hitOf(Look::Glass, Look::Static, 1.0f)};
  EXPECT_EQ(cuesOf(packet, 0, masking, random).size(), 1u);
}

TEST(Cues, OfManyAlikeAboutOneATickIsHeard) {
  sim::FramePacket packet = packetAt(1);
  Random random(1);
  Masking masking;
  packet.events.assign(8, hitOf(Look::Glass, Look::Static, 3.0f, 0.1f));
  std::size_t heard = 0;
  for (int tick = 0; tick < 600; ++tick) heard += cuesOf(packet, 0, masking, random).size();
  EXPECT_GT(heard, 200u);
  EXPECT_LT(heard, 900u);
}

TEST(Cues, CrystalsClimbWithTheStreak) {
  const sim::Event crystal = eventOf(EventType::Crystal, Vec3::Zero());
  for (std::int32_t streak = 1; streak <= 12; ++streak) EXPECT_EQ(cuesFor({crystal}, streak)[0].variation, streak - 1);
  for (std::int32_t streak = 13; streak < 60; ++streak) {
    const std::int32_t note = cuesFor({crystal}, streak)[0].variation;
    EXPECT_GE(note, 7);
    EXPECT_LE(note, 11);
    EXPECT_NE(note, cuesFor({crystal}, streak - 1)[0].variation);
  }
}

TEST(Cues, AMissedCrystalIsHeardOnlyWhenItCostAStreak) {
  const sim::Event missed = eventOf(EventType::CrystalMissed, Vec3::Zero());
  EXPECT_TRUE(cuesFor({missed}, 0, 0).empty());
  EXPECT_TRUE(has(cuesFor({missed}, 0, 4), Sound::Missed));
}

TEST(Cues, AVolleyIsOneSwoosh) {
  const sim::Event thrown = eventOf(EventType::Throw, Vec3::Zero());
  EXPECT_EQ(cuesFor({thrown, thrown, thrown}).size(), 1u);
}

TEST(Cues, TheClearedNoteIsTheSimulations) {
  sim::Event cleared = eventOf(EventType::Cleared, Vec3::Zero());
  cleared.value = 9;
  EXPECT_EQ(cuesFor({cleared})[0].variation, 9);
  EXPECT_EQ(cuesFor({cleared})[0].sound, Sound::Note);
}

TEST(Cues, ScriptSoundsGoByTheirNames) {
  EXPECT_EQ(soundNamed("snd/glass_break3.ogg"), Sound::GlassMedium);
  EXPECT_EQ(soundNamed("snd/door.ogg"), Sound::Door);
  EXPECT_EQ(soundNamed("snd/laser/discharge.ogg"), Sound::LaserDischarge);
  EXPECT_FALSE(soundNamed("snd/fanfare.ogg").has_value());
  sim::Event asked = eventOf(EventType::Sound, Vec3::Zero());
  asked.size = 0.5f;
  asked.value = 1;
  ASSERT_EQ(cuesFor({asked}).size(), 1u);
  EXPECT_EQ(cuesFor({asked})[0].sound, Sound::Door);
  for (const std::int32_t silent : {0, -1, 2, 1000}) {
    asked.value = silent;
    EXPECT_TRUE(cuesFor({asked}).empty());
  }
}

TEST(Cues, EveryEventCanBeHeardOrIsKnownToBeSilent) {
  for (int type = 0; type <= static_cast<int>(EventType::Splash); ++type) {
    const auto event = static_cast<EventType>(type);
    const bool silent = event == EventType::RoomEntered || event == EventType::LevelDone || event == EventType::Sound ||
                        event == EventType::Smoke || event == EventType::Glow;
    EXPECT_EQ(cuesFor({eventOf(event, Vec3::Zero())}, 1, 1).empty(), silent) << type;
  }
}

}  // namespace
}  // namespace brittle::view
