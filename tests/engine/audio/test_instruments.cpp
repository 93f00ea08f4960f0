#include "engine/audio/instruments.h"

#include <gtest/gtest.h>

#include "engine/audio/synthesis.h"
#include "engine/audio/voices.h"
#include "tests/engine/audio/measure.h"

namespace brittle::audio {
namespace {

Instruments& instruments() {
  static Instruments made;
  return made;
}

/// A tone as the mixer plays it.
std::vector<float> played(Instrument instrument, float note, double seconds) {
  const Instruments::Tone tone = instruments().tone(instrument, note);
  VoiceDef def;
  def.clip = tone.clip;
  def.pitch = tone.pitch;
  Voices voices;
  voices.play(def);
  std::vector<float> out;
  while (out.size() < seconds * kSampleRate) {
    Block block;
    voices.render(1.0f, block, nullptr);
    out.insert(out.end(), block.left, block.left + kBlockFrames);
  }
  return out;
}

TEST(Instruments, EveryNoteIsInTune) {
  for (float note = 36.0f; note <= 84.0f; note += 5.0f) {
    const Instrument instrument = note < 48.0f ? Instrument::Bass : note < 60.0f ? Instrument::Pad : Instrument::Mallet;
    const bool isPad = instrument == Instrument::Pad;
    const std::vector<float> out = played(instrument, note, isPad ? 5.0 : 1.0);
    // A pad's two halves are 2 cents to either side and beat slowly: only a long look tells them apart from one tone.
    EXPECT_NEAR(centsOff(part(out, 0.02, isPad ? 5.0 : 0.8), static_cast<double>(pitchOf(note))), 0.0, 3.0) << note;
  }
}

TEST(Instruments, APadSwellsAndFallsAndAMalletIsThereAtOnce) {
  const std::vector<float> pad = played(Instrument::Pad, 60.0f, 7.0), mallet = played(Instrument::Mallet, 67.0f, 1.5);
  EXPECT_LT(peakOf(part(pad, 0.0, 0.1)), 0.05);
  EXPECT_GT(rmsOf(part(pad, 2.0, 1.0)), 0.2);
  EXPECT_LT(peakOf(part(pad, 6.2, 0.5)), 0.2);
  EXPECT_LT(placeOfPeak(mallet), 0.03 * kSampleRate);
}

TEST(Instruments, TonesAreSoft) {
  EXPECT_LT(centroidOf(part(played(Instrument::Pad, 60.0f, 3.0), 2.0, 0.1)), 900.0);
  EXPECT_LT(centroidOf(part(played(Instrument::Bass, 36.0f, 1.0), 0.1, 0.1)), 300.0);
}

TEST(Instruments, AToneIsMadeWhenItIsFirstAskedFor) {
  Instruments fresh;
  EXPECT_EQ(fresh.bytes(), 0u);
  EXPECT_FALSE(fresh.isMade(Instrument::Pad, 60.0f));
  const Clip* const clip = fresh.tone(Instrument::Pad, 60.0f).clip;
  const std::size_t one = fresh.bytes();
  EXPECT_EQ(one, clip->bytes());
  EXPECT_TRUE(fresh.isMade(Instrument::Pad, 59.0f));  // by its rate
  EXPECT_FALSE(fresh.isMade(Instrument::Pad, 72.0f));
  EXPECT_FALSE(fresh.isMade(Instrument::Bass, 36.0f));
  for (float note = 30.0f; note < 90.0f; note += 1.0f)
    for (const Instrument any : {Instrument::Pad, Instrument::Bass, Instrument::Mallet}) fresh.tone(any, note);
  EXPECT_EQ(fresh.tone(Instrument::Pad, 60.0f).clip, clip) << "a voice may be reading it";
  EXPECT_LT(fresh.bytes(), 4u << 20);
}

}  // namespace
}  // namespace brittle::audio
