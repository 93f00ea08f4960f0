#include "game/view/music.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "game/view/sound.h"
#include "packets.h"

namespace brittle::view {
namespace {

using audio::Instrument;

struct Placed {
  std::int32_t tick;
  MusicNote note;
};

std::vector<Placed> scoreOf(const std::string& name, std::int32_t ticks = kMusicTicks) {
  std::vector<Placed> score;
  for (std::int32_t tick = 0; tick < ticks; ++tick)
    for (const MusicNote& note : notesAt(name, tick)) score.push_back({tick, note});
  return score;
}

int count(const std::vector<Placed>& score, Instrument instrument, std::int32_t from = 0,
          std::int32_t to = kMusicTicks) {
  int sum = 0;
  for (const Placed& placed : score)
    sum += placed.note.instrument == instrument && placed.tick >= from && placed.tick < to ? 1 : 0;
  return sum;
}

const char* const kNames[] = {"hall", "gallery", "0", "1", "17", "44", "boss_in", "a room of one's own"};

TEST(Music, LastsAsLongAsARoomAndThenBeginsAgain) {
  EXPECT_EQ(kMusicTicks, 32 * 60);
  const std::vector<Placed> twice = scoreOf("hall", 2 * kMusicTicks), once = scoreOf("hall");
  ASSERT_EQ(twice.size(), 2 * once.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(twice[once.size() + i].tick, once[i].tick + kMusicTicks);
    EXPECT_EQ(twice[once.size() + i].note.note, once[i].note.note);
  }
}

TEST(Music, IsOnTheBeatAndInKey) {
  const std::set<int> major = {0, 2, 4, 5, 7, 9, 11};
  for (const char* name : kNames)
    for (const Placed& placed : scoreOf(name)) {
      EXPECT_EQ(placed.tick % kStepTicks, 0);
      EXPECT_TRUE(major.contains(static_cast<int>(placed.note.note) % 12)) << name << " " << placed.note.note;
      EXPECT_GE(placed.note.note, 36.0f);
      EXPECT_LE(placed.note.note, 96.0f);
    }
}

TEST(Music, AChordEveryTwoBarsWithoutRubbing) {
  for (const char* name : kNames) {
    const std::vector<Placed> score = scoreOf(name);
    for (std::int32_t chord = 0; chord < kChords; ++chord) {
      const std::int32_t at = chord * kStepsPerChord * kStepTicks;
      EXPECT_EQ(count(score, Instrument::Pad, at, at + 1), 4);
      EXPECT_EQ(count(score, Instrument::Bass, at, at + 1), 1);
    }
    EXPECT_EQ(count(score, Instrument::Pad), 4 * kChords);
    for (const Placed& a : score)
      for (const Placed& b : score) {
        if (a.tick != b.tick || a.note.instrument != Instrument::Pad || b.note.instrument != Instrument::Pad) continue;
        EXPECT_NE(std::fabs(a.note.note - b.note.note), 1.0f) << name << ": two tones of a chord a semitone apart";
      }
  }
}

TEST(Music, FillsTheRoomAndEmptiesBeforeTheDoor) {
  for (const char* name : kNames) {
    const std::vector<Placed> score = scoreOf(name);
    constexpr std::int32_t kQuarter = kMusicTicks / 4;
    EXPECT_EQ(count(score, Instrument::Mallet, 0, kQuarter / 2), 0);
    EXPECT_GT(count(score, Instrument::Mallet, 2 * kQuarter, 3 * kQuarter), 6);
    EXPECT_LT(count(score, Instrument::Mallet, kMusicTicks - kQuarter / 2, kMusicTicks),
              count(score, Instrument::Mallet, 2 * kQuarter, 3 * kQuarter));
  }
}

TEST(Music, AnotherNameIsAnotherPiece) {
  std::set<std::string> pieces;
  for (const char* name : kNames) {
    std::string notes;
    for (const Placed& placed : scoreOf(name))
      notes += std::to_string(placed.tick) + ":" + std::to_string(placed.note.note) + " ";
    pieces.insert(notes);
  }
  EXPECT_EQ(pieces.size(), std::size(kNames));
}

TEST(Music, SilentRoomsAndTicksBeforeTheRoomHaveNone) {
  EXPECT_TRUE(scoreOf("").empty());
  EXPECT_TRUE(scoreOf("silent").empty());
  EXPECT_TRUE(notesAt("hall", -15).empty());
  EXPECT_TRUE(notesAt("hall", -1920).empty());
}

/// What is heard of a room in which nothing happens but its music.
std::vector<float> heard(const std::string& name, int ticks, std::int32_t stopsAt = 1 << 20) {
  static const audio::Bank bank;
  audio::Mixer mixer(bank);
  Sound sound(mixer);
  std::vector<float> all, block(1600);
  for (int i = 0; i < ticks; ++i) {
    sim::FramePacket packet = packetAt(static_cast<std::uint64_t>(i));
    packet.rooms.front().music = name;
    packet.rooms.front().ticks = minOf(i, stopsAt);
    sound.tick(packet);
    mixer.render(block);
    all.insert(all.end(), block.begin(), block.end());
  }
  return all;
}

double decibels(const std::vector<float>& samples, std::size_t fromTick, std::size_t toTick) {
  double sum = 0.0;
  for (std::size_t i = 1600 * fromTick; i < 1600 * toTick; ++i)
    sum += static_cast<double>(samples[i]) * static_cast<double>(samples[i]);
  return 10.0 * std::log10(std::max(sum / (1600.0 * static_cast<double>(toTick - fromTick)), 1e-20));
}

TEST(Music, StaysInTheBackground) {
  for (const char* name : {"hall", "gallery"}) {
    const std::vector<float> mix = heard(name, kMusicTicks);
    float peak = 0.0f;
    for (const float sample : mix) peak = maxOf(peak, std::fabs(sample));
    EXPECT_LT(peak, 0.3f) << name;
    for (std::size_t second = 2; second < 32; ++second) {
      EXPECT_GT(decibels(mix, 60 * second, 60 * second + 60), -42.0) << name << " second " << second;
      EXPECT_LT(decibels(mix, 60 * second, 60 * second + 60), -22.0) << name << " second " << second;
    }
  }
}

TEST(Music, MakesAToneOfItsFirstChordATick) {
  static const audio::Bank bank;
  audio::Mixer mixer(bank);
  Sound sound(mixer);
  std::vector<float> block(1600);
  sim::FramePacket packet = packetAt(0);
  packet.rooms.front().ticks = -1;
  sound.tick(packet);
  EXPECT_EQ(sound.instruments().bytes(), 0u) << "without music";
  packet.rooms.front().music = "hall";
  audio::Instruments own;  // made all at once
  int makes = 0;
  for (int tick = 0; tick < 6; ++tick) {
    const std::size_t before = sound.instruments().bytes();
    packet.rooms.front().ticks = tick;
    sound.tick(packet);
    mixer.render(block);
    makes += sound.instruments().bytes() != before ? 1 : 0;
    EXPECT_GT(mixer.activeVoices(), 0u);
    if (tick == 0) {
      EXPECT_LT(mixer.activeVoices(), notesAt("hall", 0).size());
    }
  }
  for (const MusicNote& note : notesAt("hall", 0)) own.tone(note.instrument, note.note);
  EXPECT_EQ(sound.instruments().bytes(), own.bytes());
  EXPECT_GT(makes, 2);
  EXPECT_EQ(mixer.activeVoices(), notesAt("hall", 0).size()) << "all of it plays within a tenth of a second";
}

TEST(Music, FallsSilentWhereTheGameStandsStill) {
  const std::vector<float> mix = heard("hall", 1000, 480);
  EXPECT_GT(decibels(mix, 480, 500), -45.0);
  EXPECT_LT(decibels(mix, 980, 1000), -90.0);
}

}  // namespace
}  // namespace brittle::view
