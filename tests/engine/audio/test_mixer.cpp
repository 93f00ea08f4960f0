#include "engine/audio/mixer.h"

#include <gtest/gtest.h>

#include <thread>

#include "engine/core/random.h"
#include "tests/allocations.h"
#include "tests/engine/audio/measure.h"
#include "tests/engine/audio/scene.h"

namespace brittle::audio {
namespace {

Acoustics hall() {
  Acoustics acoustics;
  acoustics.reverb = {0.5f, 0.7f, 0.2f};
  acoustics.echo = {0.3f, 0.2f, 0.4f, 0.2f};
  return acoustics;
}

/// Two seconds of a busy game, tick by tick.
std::vector<float> busyMix(std::size_t chunk) {
  Mixer mixer(bank());
  Random random(5);
  std::vector<float> all;
  mixer.setAcoustics(hall());
  for (int tick = 0; tick < 120; ++tick) {
    const std::uint32_t sounds = random.nextBelow(4);
    for (std::uint32_t i = 0; i < sounds; ++i) {
      VoiceDef def =
          voiceOf(static_cast<Sound>(random.nextBelow(static_cast<std::uint32_t>(Sound::Count))), random.next());
      def.left = random.nextFloat();
      def.right = random.nextFloat();
      def.pitch = random.nextFloat(0.9f, 1.1f);
      def.cutoff = random.nextFloat(1000.0f, 20000.0f);
      def.send = 0.5f;
      def.delay = random.nextBelow(800);
      mixer.play(def);
    }
    std::vector<float> stereo(1600);
    for (std::size_t i = 0; i < stereo.size(); i += chunk)
      mixer.render(std::span(stereo).subspan(i, std::min(chunk, stereo.size() - i)));
    all.insert(all.end(), stereo.begin(), stereo.end());
  }
  return all;
}

TEST(Mixer, TheSameSamplesEachTimeHoweverMuchIsAskedAtOnce) {
  const std::vector<float> once = busyMix(1600);
  EXPECT_GT(rmsOf(once), 0.05);
  EXPECT_EQ(busyMix(1600), once);
  EXPECT_EQ(busyMix(74), once);
  EXPECT_EQ(busyMix(2), once);
}

TEST(Mixer, SixtyFourBreaksAtOnceDoNotClip) {
  Mixer mixer(bank());
  mixer.setAcoustics(hall());
  for (std::uint32_t i = 0; i < 64; ++i) mixer.play(voiceOf(Sound::GlassLarge, i));
  const std::vector<float> mix = take(mixer, 2.0);
  EXPECT_LE(peakOf(mix), static_cast<double>(kCeiling) * 1.000001);
  EXPECT_GT(peakOf(mix), 0.8);
  EXPECT_GT(rmsOf(part(leftOf(mix), 0.0, 0.3)), 0.1);
}

TEST(Mixer, SilenceInSilenceOut) {
  Mixer mixer(bank());
  EXPECT_EQ(peakOf(take(mixer, 0.1)), 0.0);
  mixer.setAcoustics(hall());
  VoiceDef def = voiceOf(Sound::GlassMedium);
  def.send = 1.0f;
  mixer.play(def);
  EXPECT_GT(peakOf(take(mixer, 1.0)), 0.3);
  take(mixer, 6.0);
  EXPECT_EQ(peakOf(take(mixer, 0.5)), 0.0) << "a tail that never ends";
  EXPECT_EQ(mixer.activeVoices(), 0u);
}

TEST(Mixer, TheRoomIsHeard) {
  std::vector<float> tails[2];
  for (const bool inHall : {false, true}) {
    Mixer mixer(bank());
    if (inHall) mixer.setAcoustics(hall());
    VoiceDef def = voiceOf(Sound::OnStone);
    def.send = 1.0f;
    mixer.play(def);
    take(mixer, 0.45);
    tails[inHall ? 1 : 0] = take(mixer, 0.3);
  }
  EXPECT_EQ(peakOf(tails[0]), 0.0);
  EXPECT_GT(rmsOf(tails[1]), 1e-3);
}

TEST(Mixer, ALeftRoomRingsOutAndIsThenGivenBack) {
  Mixer mixer(bank());
  EXPECT_EQ(mixer.spaceBytes(), 0u);
  mixer.setAcoustics(hall());
  EXPECT_GT(mixer.spaceBytes(), 50000u);
  VoiceDef def = voiceOf(Sound::OnStone);
  def.send = 1.0f;
  mixer.play(def);
  take(mixer, 0.5);
  mixer.setAcoustics({});
  EXPECT_GT(rmsOf(take(mixer, 0.2)), 1e-3) << "the reverb was cut off at the door";
  EXPECT_TRUE(mixer.hasSpace());
  take(mixer, 4.0);
  EXPECT_FALSE(mixer.hasSpace()) << "a stage that nobody asks for still runs";
  mixer.setAcoustics({});
  EXPECT_EQ(mixer.spaceBytes(), 0u);
}

TEST(Mixer, TheLowPassOfARoomDullsEverything) {
  double centroids[2];
  for (const bool underWater : {false, true}) {
    Mixer mixer(bank());
    Acoustics acoustics;
    acoustics.lowPass = underWater ? 0.6f : 0.0f;
    mixer.setAcoustics(acoustics);
    take(mixer, 0.5);
    mixer.play(voiceOf(Sound::GlassLarge));
    centroids[underWater ? 1 : 0] = centroidOf(leftOf(take(mixer, 0.1)));
  }
  EXPECT_LT(centroids[1], 0.35 * centroids[0]);
}

TEST(Mixer, ALowPassOfItsOwnLastsUntilTheNextRoom) {
  const auto centroidAfter = [](bool entersRoom) {
    Mixer mixer(bank());
    mixer.setLowPass(0.6f);
    take(mixer, 0.5);
    if (entersRoom) mixer.setAcoustics({});
    take(mixer, 1.0);
    mixer.play(voiceOf(Sound::GlassLarge));
    return centroidOf(leftOf(take(mixer, 0.1)));
  };
  EXPECT_LT(centroidAfter(false), 0.35 * centroidAfter(true));
}

TEST(Mixer, SlowMotionLowersEverything) {
  Mixer mixer(bank());
  mixer.setRate(0.5f);
  mixer.play(voiceOf(Sound::Note, 5));
  const double pitch = 440.0 * std::exp2((84.0 - 69.0) / 12.0);
  EXPECT_NEAR(centsOff(part(leftOf(take(mixer, 1.0)), 0.0, 0.8), 0.5 * pitch), 0.0, 3.0);
}

TEST(Mixer, SilenceEndsEverythingAtOnce) {
  Mixer mixer(bank());
  mixer.setAcoustics(hall());
  mixer.play(voiceOf(Sound::Crash));
  take(mixer, 0.2);
  mixer.silence();
  take(mixer, 0.01);  // what the limiter still held
  EXPECT_EQ(peakOf(take(mixer, 0.5)), 0.0);
  EXPECT_FALSE(mixer.hasSpace());
}

TEST(Mixer, RenderingDoesNotAllocate) {
  Mixer mixer(bank());
  mixer.setAcoustics(hall());
  for (std::uint32_t i = 0; i < 100; ++i) mixer.play(voiceOf(Sound::GlassLarge, i));
  mixer.setAcoustics({});
  mixer.setAcoustics(hall());
  mixer.setRate(0.8f);
  std::vector<float> stereo(48000);
  const std::size_t before = allocationCount();
  mixer.render(stereo);
  mixer.render(stereo);
  EXPECT_EQ(allocationCount(), before);
}

TEST(Mixer, WhatDoesNotFitIntoTheQueueIsCounted) {
  Mixer mixer(bank());
  for (int i = 0; i < 1100; ++i) mixer.play(voiceOf(Sound::TinkleSmall));
  EXPECT_EQ(mixer.refused(), 1100u - 1023u);
  mixer.setAcoustics(hall());
  EXPECT_EQ(mixer.spaceBytes(), 0u) << "a refused room's memory is kept";
  take(mixer, 0.01);
  mixer.play(voiceOf(Sound::TinkleSmall));
  EXPECT_EQ(mixer.refused(), 1100u - 1023u + 1u);
  std::vector<NamedCount> counts;
  mixer.omissions(counts);
  ASSERT_GE(counts.size(), 2u);
  EXPECT_STREQ(counts[0].name, nameOf(Omission::Order));
  EXPECT_EQ(counts[0].count, mixer.refused());
  EXPECT_STREQ(counts[1].name, nameOf(Omission::RefusedVoice)) << "of a thousand sounds alike 64 have a voice";
  EXPECT_EQ(counts[1].count, 1023u - kVoices);
}

TEST(Mixer, OneThreadTellsTheOtherTakes) {
  Mixer mixer(bank());
  std::atomic<bool> done = false;
  std::atomic<int> blocks = 0;  // taken
  double loudest = 0.0;
  std::thread device([&] {
    std::vector<float> stereo(512);
    while (!done) {
      mixer.render(stereo);
      loudest = std::max(loudest, peakOf(stereo));
      ++blocks;
      std::this_thread::yield();
    }
  });
  for (int i = 0; i < 2000; ++i) {
    mixer.play(voiceOf(Sound::TinkleMedium, static_cast<std::uint32_t>(i)));
    if (i % 50 == 0) mixer.setAcoustics(i % 100 == 0 ? hall() : Acoustics{});
    if (i % 100 == 0) std::this_thread::yield();
  }
  const int last = blocks;
  while (blocks < last + 10) std::this_thread::yield();
  done = true;
  device.join();
  EXPECT_GT(loudest, 0.1);
}

}  // namespace
}  // namespace brittle::audio
