// Every sound of the bank by its numbers. What real glass does was measured on four recordings of breaking windows:
// centroids of 2 to 14 kHz, and 5 to 34 dB less 0.3 s after the peak.
#include "engine/audio/synthesis.h"

#include <gtest/gtest.h>

#include "engine/core/hash.h"
#include "tests/engine/audio/measure.h"
#include "tests/engine/audio/scene.h"

namespace brittle::audio {
namespace {

/// Bounds that every variation keeps.
struct Expected {
  Sound sound;
  double lowCentroid, highCentroid;  // of the 85 ms from the peak on [Hz]
  double lowDecay, highDecay;        // to -60 dB, by the slope to -35 dB [s]
};

constexpr Expected kExpected[] = {
    {Sound::GlassSmall, 5000, 14000, 0.05, 1.0},  {Sound::GlassMedium, 4500, 12000, 0.2, 1.3},
    {Sound::GlassLarge, 3000, 10000, 0.4, 1.8},   {Sound::ShardRain, 2500, 14000, 0.3, 2.0},
    {Sound::TinkleSmall, 4000, 16000, 0.02, 0.5}, {Sound::TinkleMedium, 2500, 12000, 0.02, 0.6},
    {Sound::TinkleLarge, 1200, 8000, 0.05, 0.8},  {Sound::OnStone, 250, 1500, 0.03, 0.3},
    {Sound::OnWall, 400, 2500, 0.05, 0.4},        {Sound::OnMetal, 500, 3000, 0.2, 1.4},
    {Sound::OnWood, 150, 1200, 0.03, 0.25},       {Sound::OnGlass, 1200, 5000, 0.05, 0.5},
    {Sound::OnSteel, 3500, 8000, 0.05, 0.5},      {Sound::Note, 500, 5000, 0.4, 2.5},
    {Sound::Missed, 200, 600, 0.5, 1.5},          {Sound::Door, 300, 2500, 0.2, 2.5},
    {Sound::Crash, 300, 3000, 0.3, 1.6},          {Sound::Throw, 400, 3000, 0.1, 0.6},
    {Sound::PowerUpTaken, 900, 4500, 0.3, 1.5},   {Sound::PowerUpBegins, 300, 3000, 0.3, 1.5},
    {Sound::PowerUpEnds, 250, 2500, 0.2, 1.2},    {Sound::BlastSmall, 150, 1800, 0.2, 1.5},
    {Sound::BlastMedium, 100, 1400, 0.3, 2.2},    {Sound::BlastLarge, 60, 1000, 0.5, 3.5},
    {Sound::TimeSlows, 200, 2000, 0.3, 6.0},      {Sound::TimeReturns, 150, 2500, 0.2, 6.0},
    {Sound::SplashDrip, 1800, 6500, 0.03, 0.6},   {Sound::SplashSmall, 1500, 6500, 0.1, 0.9},
    {Sound::SplashMedium, 700, 5500, 0.2, 1.0},   {Sound::SplashLarge, 300, 4500, 0.4, 1.6},
    {Sound::LaserHum, 120, 300, 0.5, 1.5},        {Sound::LaserHit, 3000, 9000, 0.005, 0.4},
    {Sound::LaserDischarge, 700, 2600, 0.7, 1.8},
};

TEST(Synthesis, EverySoundHasItsSpectrumAndItsDecay) {
  ASSERT_EQ(std::size(kExpected), static_cast<std::size_t>(Sound::Count));
  for (const Expected& expected : kExpected)
    for (std::uint32_t i = 0; i < bank().variations(expected.sound); ++i) {
      SCOPED_TRACE(std::string(nameOf(expected.sound)) + " " + std::to_string(i));
      const std::span<const float> all = samplesOf(bank().clip(expected.sound, i));
      const double peakAt = static_cast<double>(placeOfPeak(all)) / kSampleRate;
      const double centroid = centroidOf(part(all, std::max(0.0, peakAt - 0.005), 0.0854));
      EXPECT_GE(centroid, expected.lowCentroid);
      EXPECT_LE(centroid, expected.highCentroid);
      const double decay = decayTimeOf(part(all, peakAt, 10.0));
      EXPECT_GE(decay, expected.lowDecay);
      EXPECT_LE(decay, expected.highDecay);
    }
}

TEST(Synthesis, EverySoundIsAsLoudAsItCanBeAndEndsInSilence) {
  for (int s = 0; s < static_cast<int>(Sound::Count); ++s)
    for (std::uint32_t i = 0; i < bank().variations(static_cast<Sound>(s)); ++i) {
      SCOPED_TRACE(std::string(nameOf(static_cast<Sound>(s))) + " " + std::to_string(i));
      const std::span<const float> all = samplesOf(bank().clip(static_cast<Sound>(s), i));
      EXPECT_NEAR(peakOf(all), 1.0, 1e-6);
      EXPECT_GT(rmsOf(part(all, 0.0, 0.3)), 0.02);  // -34 dB: more than a click
      EXPECT_LT(std::fabs(all[0]), 0.1);
      EXPECT_EQ(all.back(), 0.0f);
      EXPECT_LT(peakOf(all.last(480)), 0.03) << "cut off";
      double sum = 0.0;
      for (const float sample : all) sum += static_cast<double>(sample);
      EXPECT_LT(std::fabs(sum) / static_cast<double>(all.size()), 0.003) << "pushes the membrane to one side";
    }
}

double meanCentroid(Sound sound) {
  double sum = 0.0;
  for (std::uint32_t i = 0; i < bank().variations(sound); ++i) {
    const std::span<const float> all = samplesOf(bank().clip(sound, i));
    sum += centroidOf(part(all, static_cast<double>(placeOfPeak(all)) / kSampleRate, 0.0854));
  }
  return sum / bank().variations(sound);
}

TEST(Synthesis, SmallGlassIsHigherThanLargeAndMetalThanStone) {
  EXPECT_GT(meanCentroid(Sound::GlassSmall), meanCentroid(Sound::GlassMedium));
  EXPECT_GT(meanCentroid(Sound::GlassMedium), meanCentroid(Sound::GlassLarge));
  EXPECT_GT(meanCentroid(Sound::TinkleSmall), meanCentroid(Sound::TinkleMedium));
  EXPECT_GT(meanCentroid(Sound::TinkleMedium), meanCentroid(Sound::TinkleLarge));
  EXPECT_GT(meanCentroid(Sound::OnMetal), meanCentroid(Sound::OnWall));
  EXPECT_GT(meanCentroid(Sound::OnWall), meanCentroid(Sound::OnStone));
}

TEST(Synthesis, GlassBreaksWithACrackAndRingsOn) {
  for (const Sound sound : {Sound::GlassSmall, Sound::GlassMedium, Sound::GlassLarge})
    for (std::uint32_t i = 0; i < bank().variations(sound); ++i) {
      SCOPED_TRACE(std::string(nameOf(sound)) + " " + std::to_string(i));
      const std::span<const float> all = samplesOf(bank().clip(sound, i));
      EXPECT_LT(placeOfPeak(all), 0.04 * kSampleRate);
      EXPECT_GT(peakOf(part(all, 0.0, 0.003)), 0.3) << "its first 3 ms are not the crack";
      const double peakAt = static_cast<double>(placeOfPeak(all)) / kSampleRate;
      const double later = decibels(rmsOf(part(all, peakAt + 0.3, 0.093)) / rmsOf(part(all, peakAt, 0.093)));
      EXPECT_LT(later, -5.0);
      EXPECT_GT(later, sound == Sound::GlassSmall ? -50.0 : -34.0);
    }
}

// 50 ms after the peak, real breaks have their strong partials at 3.1 to 9 kHz and 8.9 to 16.7 kHz, and large panes at
// 0.57 to 0.79 kHz as well.
TEST(Synthesis, BrokenGlassRingsWhereRealGlassDoes) {
  for (const Sound sound : {Sound::GlassSmall, Sound::GlassMedium, Sound::GlassLarge})
    for (std::uint32_t i = 0; i < bank().variations(sound); ++i) {
      SCOPED_TRACE(std::string(nameOf(sound)) + " " + std::to_string(i));
      const std::span<const float> all = samplesOf(bank().clip(sound, i));
      const double peakAt = static_cast<double>(placeOfPeak(all)) / kSampleRate;
      const std::span<const float> ringing = part(all, peakAt + 0.05, 0.0854);
      EXPECT_GT(shareBetween(ringing, 3100.0, 16700.0), sound == Sound::GlassLarge ? 0.4 : 0.6);
      EXPECT_LT(shareBetween(ringing, 0.0, 570.0), 0.05) << "a thud";
      const double strongest = peakBetween(ringing, 0.0, 24000.0);
      EXPECT_GT(decibels(std::sqrt(peakBetween(ringing, 3100.0, 9000.0) / strongest)), -10.0);
      EXPECT_GT(decibels(std::sqrt(peakBetween(ringing, 8900.0, 16700.0) / strongest)), -25.0);
      if (sound != Sound::GlassLarge) continue;
      EXPECT_GT(decibels(std::sqrt(peakBetween(ringing, 570.0, 790.0) / strongest)), -20.0);
    }
}

TEST(Synthesis, NotesAreInTune) {
  for (std::uint32_t i = 0; i < kNotes; ++i) {
    const double pitch = 440.0 * std::exp2((static_cast<double>(kNoteNumbers[i]) - 69.0) / 12.0);
    EXPECT_NEAR(static_cast<double>(pitchOf(kNoteNumbers[i])), pitch, 1e-4 * pitch);
    EXPECT_NEAR(centsOff(part(samplesOf(bank().clip(Sound::Note, i)), 0.0, 0.8), pitch), 0.0, 3.0) << "note " << i;
  }
}

TEST(Synthesis, VariationsDiffer) {
  for (int s = 0; s < static_cast<int>(Sound::Count); ++s) {
    const auto sound = static_cast<Sound>(s);
    for (std::uint32_t i = 1; i < bank().variations(sound); ++i) {
      const std::span<const float> a = samplesOf(bank().clip(sound, 0)), b = samplesOf(bank().clip(sound, i));
      double product = 0.0;
      for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
        product += static_cast<double>(a[k]) * static_cast<double>(b[k]);
      const double norm =
          rmsOf(a) * rmsOf(b) * std::sqrt(static_cast<double>(a.size())) * std::sqrt(static_cast<double>(b.size()));
      EXPECT_LT(std::fabs(product) / norm, 0.95) << nameOf(sound) << " " << i;
    }
  }
}

TEST(Synthesis, ABlastIsDeeperAndLongerTheLargerItIs) {
  const Sound sizes[] = {Sound::BlastSmall, Sound::BlastMedium, Sound::BlastLarge};
  for (int i = 0; i + 1 < 3; ++i) {
    const std::span<const float> a = samplesOf(bank().clip(sizes[i], 0)), b = samplesOf(bank().clip(sizes[i + 1], 0));
    EXPECT_LT(a.size(), b.size());
    EXPECT_GT(centroidOf(part(a, 0.0, 0.3413)), centroidOf(part(b, 0.0, 0.3413)));
  }
}

TEST(Synthesis, LateSoundsAreComputedWhenTheyAreAskedFor) {
  const Bank fresh;
  const std::size_t before = fresh.bytes();
  EXPECT_GT(fresh.variations(Sound::GlassSmall), 0u);
  EXPECT_EQ(fresh.bytes(), before);
  fresh.prepare(Sound::PowerUpTaken);
  const std::size_t after = fresh.bytes();
  EXPECT_GT(after, before);
  EXPECT_EQ(fresh.variations(Sound::PowerUpTaken), 1u);
  EXPECT_EQ(fresh.bytes(), after);
}

TEST(Synthesis, TheSameSamplesEachTime) {
  const Bank again;
  for (int s = 0; s < static_cast<int>(Sound::Count); ++s)
    for (std::uint32_t i = 0; i < bank().variations(static_cast<Sound>(s)); ++i) {
      const std::span<const float> a = samplesOf(bank().clip(static_cast<Sound>(s), i));
      const std::span<const float> b = samplesOf(again.clip(static_cast<Sound>(s), i));
      ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end())) << nameOf(static_cast<Sound>(s));
    }
}

}  // namespace
}  // namespace brittle::audio
