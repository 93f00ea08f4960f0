#include "engine/audio/voices.h"

#include <gtest/gtest.h>

#include "tests/engine/audio/measure.h"

namespace brittle::audio {
namespace {

Clip tone(double frequency, float seconds) {
  Samples samples(samplesIn(seconds));
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<float>(std::sin(2.0 * M_PI * frequency * static_cast<double>(i) / kSampleRate));
  return Clip(samples);
}

VoiceDef defOf(const Clip& clip, float gain = 1.0f) {
  VoiceDef def;
  def.clip = &clip;
  def.left = def.right = gain;
  return def;
}

/// The left side of so many blocks.
std::vector<float> take(Voices& voices, int blocks, float rate = 1.0f) {
  std::vector<float> left;
  for (int i = 0; i < blocks; ++i) {
    Block block;
    voices.render(rate, block, nullptr);
    left.insert(left.end(), block.left, block.left + kBlockFrames);
  }
  return left;
}

TEST(Voices, AnUnchangedClipComesOutBitForBit) {
  const Clip clip = tone(1000.0, 0.1f);
  Voices voices;
  ASSERT_TRUE(voices.play(defOf(clip)));
  const std::vector<float> out = take(voices, 200);
  for (std::size_t i = 0; i < clip.size(); ++i) ASSERT_EQ(out[i], *clip.at(i)) << i;
  for (std::size_t i = clip.size(); i < out.size(); ++i) ASSERT_EQ(out[i], 0.0f) << i;
  EXPECT_EQ(voices.active(), 0u);
}

TEST(Voices, BeginsToTheSample) {
  const Clip clip(Samples(1000, 1.0f));
  for (const std::uint32_t delay : {0u, 1u, 31u, 32u, 33u, 1000u}) {
    Voices voices;
    VoiceDef def = defOf(clip);
    def.delay = delay;
    voices.play(def);
    const std::vector<float> out = take(voices, 80);
    for (std::size_t i = 0; i < delay; ++i) ASSERT_EQ(out[i], 0.0f);
    EXPECT_EQ(out[delay], 1.0f) << delay;
  }
}

TEST(Voices, PitchAndRateMoveTheTone) {
  const Clip clip = tone(1000.0, 0.5f);
  for (const auto& [pitch, rate] :
       {std::pair{1.5f, 1.0f}, std::pair{0.7f, 1.0f}, std::pair{1.0f, 0.5f}, std::pair{2.0f, 0.4f}}) {
    Voices voices;
    VoiceDef def = defOf(clip);
    def.pitch = pitch;
    voices.play(def);
    const std::vector<float> out = take(voices, 2000, rate);
    EXPECT_NEAR(centsOff(part(out, 0.0, 0.3), 1000.0 * static_cast<double>(pitch * rate)), 0.0, 1.0);
    std::size_t length = out.size();
    while (length > 0 && out[length - 1] == 0.0f) --length;
    EXPECT_NEAR(static_cast<double>(length), static_cast<double>(clip.size()) / static_cast<double>(pitch * rate), 4.0);
  }
}

TEST(Voices, InterpolationAddsLittle) {
  const Clip clip = tone(5000.0, 0.5f);
  Voices voices;
  VoiceDef def = defOf(clip);
  def.pitch = 1.06f;
  voices.play(def);
  std::vector<float> out = take(voices, 300);
  const double wanted = energyAt(part(out, 0.05, 0.1), 5300.0),
               mirrored = energyAt(part(out, 0.05, 0.1), 48000.0 * 0.06 - 5300.0);
  EXPECT_LT(10.0 * std::log10(mirrored / wanted), -48.0);
  EXPECT_NEAR(peakOf(part(out, 0.05, 0.1)), 1.0, 0.03);
}

TEST(Voices, CutoffDulls) {
  const Clip clip = tone(8000.0, 0.2f);
  Voices open, shut;
  VoiceDef def = defOf(clip);
  open.play(def);
  def.cutoff = 1000.0f;
  shut.play(def);
  const double fall = decibels(rmsOf(part(take(shut, 200), 0.05, 0.05)) / rmsOf(part(take(open, 200), 0.05, 0.05)));
  EXPECT_NEAR(fall, -18.0, 2.0);  // three octaves at 6 dB
}

TEST(Voices, PlaceAndRoomHaveTheirShares) {
  const Clip clip(Samples(1000, 1.0f));
  Voices voices;
  VoiceDef def = defOf(clip);
  def.left = 0.5f;
  def.right = 0.25f;
  def.send = 0.5f;
  voices.play(def);
  Block dry, send;
  voices.render(1.0f, dry, &send);
  EXPECT_EQ(dry.left[7], 0.5f);
  EXPECT_EQ(dry.right[7], 0.25f);
  EXPECT_EQ(send.left[7], 0.25f);
  EXPECT_EQ(send.right[7], 0.125f);
}

TEST(Voices, WhenAllAreTakenTheQuietestGivesWay) {
  const Clip clip(Samples(48000, 1.0f));
  Voices voices;
  for (std::size_t i = 0; i < kVoices; ++i) ASSERT_TRUE(voices.play(defOf(clip, i == 40 ? 0.05f : 0.1f)));
  EXPECT_NEAR(take(voices, 1).back(), 63 * 0.1f + 0.05f, 1e-4f);
  EXPECT_FALSE(voices.play(defOf(clip, 0.05f))) << "no louder than the quietest";
  EXPECT_TRUE(voices.play(defOf(clip, 0.3f)));
  EXPECT_NEAR(take(voices, 1).back(), 63 * 0.1f + 0.3f, 1e-4f);
  EXPECT_EQ(voices.active(), kVoices);
  EXPECT_EQ(voices.refused(), 1u);
  EXPECT_EQ(voices.ended(), 1u);
}

TEST(Voices, QuietIsWhatWillStaySo) {
  Samples swells(48000, 0.01f);
  swells[40000] = 1.0f;
  const Clip later(swells), fades = tone(500.0, 0.2f);
  Voices voices;
  voices.play(defOf(later, 0.2f));
  for (std::size_t i = 1; i < kVoices; ++i) voices.play(defOf(fades, 0.1f));
  take(voices, 10);
  ASSERT_TRUE(voices.play(defOf(fades, 0.15f)));  // takes a tone's voice, not the one that is quiet as yet
  take(voices, 40000 / kBlockFrames - 10);
  EXPECT_NEAR(peakOf(take(voices, 2)), 0.2, 0.01);
}

TEST(Voices, StopEndsThemAll) {
  const Clip clip(Samples(48000, 1.0f));
  Voices voices;
  voices.play(defOf(clip));
  voices.stop();
  EXPECT_EQ(peakOf(take(voices, 2)), 0.0);
}

}  // namespace
}  // namespace brittle::audio
