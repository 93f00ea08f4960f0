#include "game/view/sound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/core/log.h"
#include "game/sim/game.h"
#include "packets.h"
#include "tests/game/sim/fixture.h"

namespace brittle::view {
namespace {

const audio::Bank& bank() {
  static const audio::Bank made;
  return made;
}

constexpr std::size_t kPerTick = 2 * audio::kSampleRate / 60;

double levelOf(const std::vector<float>& samples) {
  double sum = 0.0;
  for (const float sample : samples) sum += static_cast<double>(sample) * static_cast<double>(sample);
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

/// What is heard of these packets, left and right in turn.
std::vector<float> heard(const std::vector<sim::FramePacket>& packets) {
  audio::Mixer mixer(bank());
  Sound sound(mixer);
  std::vector<float> all, tick(kPerTick);
  for (const sim::FramePacket& packet : packets) {
    sound.tick(packet);
    mixer.render(tick);
    all.insert(all.end(), tick.begin(), tick.end());
  }
  return all;
}

std::vector<sim::FramePacket> oneBreak(const Vec3& point, int ticks = 30) {
  std::vector<sim::FramePacket> packets;
  for (int i = 0; i < ticks; ++i) packets.push_back(packetAt(static_cast<std::uint64_t>(i)));
  sim::Event event = eventOf(sim::EventType::Break, point);
  event.size = 0.5f;
  event.speed = 20.0f;
  packets[3].events.push_back(event);
  return packets;
}

TEST(Sound, NothingHappensNothingIsHeard) {
  std::vector<sim::FramePacket> packets = oneBreak(Vec3::Zero());
  packets[3].events.clear();
  EXPECT_EQ(levelOf(heard(packets)), 0.0);
}

TEST(Sound, ABreakIsHeardInItsTickAndOnItsSide) {
  const std::vector<float> left = heard(oneBreak(Vec3(-4.0f, 1.0f, -4.0f))),
                           right = heard(oneBreak(Vec3(4.0f, 1.0f, -4.0f)));
  EXPECT_EQ(levelOf({left.begin(), left.begin() + 3 * kPerTick}), 0.0);
  EXPECT_GT(levelOf({left.begin() + 3 * kPerTick, left.begin() + 6 * kPerTick}), 0.01);
  ASSERT_EQ(left.size(), right.size());
  double sums[2] = {};
  for (std::size_t i = 0; i < left.size(); i += 2) {
    sums[0] += std::fabs(static_cast<double>(left[i]));
    sums[1] += std::fabs(static_cast<double>(left[i + 1]));
    ASSERT_NEAR(left[i], right[i + 1], 1e-5f) << "a mirrored scene, a mirrored sound";
  }
  EXPECT_GT(sums[0], 2.0 * sums[1]);
}

TEST(Sound, TheCameraTurnsTheEars) {
  std::vector<sim::FramePacket> packets = oneBreak(Vec3(-4.0f, 1.0f, 0.0f));
  for (sim::FramePacket& packet : packets) packet.camera.rotation = rotationAbout(Vec3::UnitZ(), kPi);
  const std::vector<float> turned = heard(packets), mirrored = heard(oneBreak(Vec3(4.0f, 1.0f, 0.0f)));
  for (std::size_t i = 0; i < turned.size(); ++i) ASSERT_NEAR(turned[i], mirrored[i], 1e-4f);
}

TEST(Sound, FartherIsQuieter) {
  EXPECT_GT(levelOf(heard(oneBreak(Vec3(0.0f, 1.0f, -4.0f)))),
            1.5 * levelOf(heard(oneBreak(Vec3(0.0f, 1.0f, -20.0f)))));
}

TEST(Sound, ALargePaneNearbyIsLoudAndClear) {
  const std::vector<float> mix = heard(oneBreak(Vec3(0.0f, 1.0f, -6.0f)));
  float peak = 0.0f;
  for (const float sample : mix) peak = maxOf(peak, std::fabs(sample));
  EXPECT_GT(peak, 0.15f);
  EXPECT_LT(peak, 0.8f);
}

TEST(Sound, TheRoomIsHeard) {
  std::vector<sim::FramePacket> dry = oneBreak(Vec3(0.0f, 1.0f, -6.0f), 180), wet = dry;
  for (sim::FramePacket& packet : wet) {
    packet.rooms.front().reverb[0] = 0.5f;
    packet.rooms.front().reverb[1] = 1.1f;
  }
  const std::vector<float> dryMix = heard(dry), wetMix = heard(wet);
  const auto late = [](const std::vector<float>& mix) {
    return levelOf({mix.begin() + 90 * kPerTick, mix.begin() + 120 * kPerTick});
  };
  EXPECT_GT(late(wetMix), 3.0 * late(dryMix));
}

TEST(Sound, AnyNumbersOfARoomAreLimited) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<sim::FramePacket> packets = oneBreak(Vec3(0.0f, 1.0f, -6.0f));
  for (sim::FramePacket& packet : packets) {
    sim::RoomView& room = packet.rooms.front();
    for (float& number : room.reverb) number = 1e30f;
    for (float& number : room.echo) number = nan;
    room.lowPass = -nan;
  }
  for (const float sample : heard(packets)) ASSERT_TRUE(std::fabs(sample) <= 1.0f);
}

TEST(Sound, AnUnknownScriptSoundIsReportedOnce) {
  int lines = 0;
  LogSink previous = setLogSink([&](LogLevel, std::string_view text) {
    ++lines;
    EXPECT_NE(text.find("snd/hum.ogg"), std::string_view::npos);
  });
  std::vector<sim::FramePacket> packets = oneBreak(Vec3::Zero());
  for (sim::FramePacket& packet : packets) {
    packet.soundNames = {"snd/hum.ogg"};
    packet.events.push_back(eventOf(sim::EventType::Sound, Vec3::Zero()));
  }
  heard(packets);
  setLogSink(std::move(previous));
  EXPECT_EQ(lines, 1);
}

TEST(Sound, AResetEndsEverything) {
  audio::Mixer mixer(bank());
  Sound sound(mixer);
  std::vector<float> tick(kPerTick);
  for (const sim::FramePacket& packet : oneBreak(Vec3(0.0f, 1.0f, -5.0f), 6)) {
    sound.tick(packet);
    mixer.render(tick);
  }
  EXPECT_GT(levelOf(tick), 0.01);
  sound.reset();
  mixer.render(tick);
  mixer.render(tick);
  EXPECT_EQ(levelOf(tick), 0.0);
}

/// A real game: its sound, and the state after every tick.
struct Played {
  std::vector<float> sound;
  std::vector<std::uint64_t> hashes;
};

Played play(bool listening) {
  const std::unique_ptr<sim::Game> game = sim::newGame(sim::shippedAssets());
  audio::Mixer mixer(bank());
  Sound sound(mixer);
  sim::FramePacket packet;
  Played played;
  std::vector<float> tick(kPerTick);
  for (std::uint64_t i = 0; i < 420; ++i) {
    game->tick(sim::scriptedInput(i));
    played.hashes.push_back(game->stateHash());
    if (!listening) continue;
    game->copyFrame(packet);
    sound.tick(packet);
    mixer.render(tick);
    played.sound.insert(played.sound.end(), tick.begin(), tick.end());
  }
  return played;
}

TEST(Sound, OfAGameIsTheSameEachTimeAndChangesNothingInIt) {
  const Played once = play(true), again = play(true), deaf = play(false);
  EXPECT_EQ(once.sound, again.sound);
  EXPECT_EQ(once.hashes, deaf.hashes);
  EXPECT_GT(levelOf(once.sound), 0.005) << "seven seconds of throwing balls";
  float peak = 0.0f;
  for (const float sample : once.sound) peak = maxOf(peak, std::fabs(sample));
  EXPECT_LE(peak, audio::kCeiling * 1.000001f);
}

TEST(Sound, SlowMotionIsUnderWater) {
  sim::FramePacket packet = packetAt(1);
  EXPECT_EQ(lowPassOf(packet), 0.0f);
  packet.timeShare = 0.25f;
  EXPECT_FLOAT_EQ(lowPassOf(packet), 0.55f);
  packet.timeShare = 0.625f;
  EXPECT_FLOAT_EQ(lowPassOf(packet), 0.275f) << "half way down";
  packet.rooms[0].lowPass = 0.8f;
  EXPECT_FLOAT_EQ(lowPassOf(packet), 0.8f) << "the room's is more";
}

}  // namespace
}  // namespace brittle::view
