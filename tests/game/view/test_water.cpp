#include "game/view/water.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/math/types.h"
#include "packets.h"

namespace brittle::view {
namespace {

/// Where a function of the distance is largest within [low, high].
template <class Function>
float peakOf(Function function, float low, float high) {
  float best = low;
  for (int i = 0; i <= 4000; ++i) {
    const float x = low + (high - low) * static_cast<float>(i) / 4000.0f;
    if (function(x) > function(best)) best = x;
  }
  return best;
}

TEST(Ripples, CrestsRunAsDeepWaterWavesDo) {
  EXPECT_NEAR(crestSpeed(1.0f), 1.2495f, 1e-3f);  // sqrt(g / 2 pi)
  EXPECT_NEAR(crestSpeed(4.0f), 2.0f * crestSpeed(1.0f), 1e-5f);
  const float length = 0.5f, speed = crestSpeed(length), age = 1.5f;
  const float begin = std::ceil((groupSpeed(length) - speed) * age / length) * length + speed * age;  // of a crest
  const auto crest = [&](float t) {
    const float near = begin + speed * (t - age);
    return peakOf([&](float x) { return groupHeight(x, t, length); }, near - 0.2f, near + 0.2f);
  };
  EXPECT_NEAR((crest(age + 0.1f) - crest(age)) / 0.1f, speed, 0.12f * speed);
}

TEST(Ripples, TheGroupGoesHalfAsFastAsItsCrests) {
  const float length = 0.3f;
  for (const float age : {1.5f, 2.5f}) {
    float sum = 0.0f, moment = 0.0f;  // of the energy a metre of the ring has
    for (float x = 0.01f; x < 6.0f; x += 0.01f) {
      const float h = groupHeight(x, age, length);
      const float energy = h * h * (1.0f + 2.0f * x / length);
      sum += energy;
      moment += energy * x;
    }
    EXPECT_NEAR(moment / sum, 0.5f * crestSpeed(length) * age, 0.1f) << age;
  }
}

TEST(Ripples, OfASplashAreGoneWhenItIsForgotten) {
  Splash splash{Vec2::Zero(), 0.5f, 0.21f, 15.0f};
  float most = 0.0f;
  for (float x = 0.0f; x < 5.0f; x += 0.02f) most = maxOf(most, std::fabs(ringHeight(splash, x)));
  EXPECT_GT(most, 0.02f);
  EXPECT_LT(most, 0.3f);
  splash.age = static_cast<float>(kMemoryTicks) / 60.0f - 0.01f;
  for (float x = 0.0f; x < 5.0f; x += 0.02f) EXPECT_NEAR(ringHeight(splash, x), 0.0f, 1e-3f);
  splash.age += 0.02f;
  EXPECT_EQ(ringHeight(splash, 0.3f), 0.0f);
}

TEST(Ripples, TheSwellStaysLow) {
  for (int i = 0; i < 2000; ++i)
    EXPECT_LE(std::fabs(swellHeight(0.17f * static_cast<float>(i % 37), 0.41 * i, 0.13 * i)), kSwellHeight);
}

class Pool : public ::testing::Test {
 protected:
  static sim::FramePacket packetWithPool(std::uint64_t tick, double originZ = 0.0) {
    sim::FramePacket packet = packetAt(tick);
    packet.originZ = originZ;
    packet.rooms[0].waters.push_back({Vec3(0.0f, -0.5f, -6.0f), Vec2(2.0f, 4.0f), {20, 40}});
    return packet;
  }
  static sim::Event splashAt(const Vec3& point) {
    sim::Event event = eventOf(sim::EventType::Splash, point);
    event.size = 0.21f;
    event.speed = 14.0f;
    event.direction = Vec3(0.0f, -8.0f, -11.0f);
    return event;
  }
  static render::Frame frameOf(const sim::FramePacket& packet, const Memory& memory, double tick) {
    render::Frame frame;
    frame.camera.position = packet.camera.position;
    addWaters(packet, memory, tick, anyBounds(), frame);
    return frame;
  }
};

TEST_F(Pool, WithoutWaterNothingIsShown) {
  sim::FramePacket packet = packetAt(100);
  Memory memory;
  packet.events.push_back(splashAt(Vec3::Zero()));
  memory.tick(packet);
  const render::Frame frame = frameOf(packet, memory, 105.0);
  EXPECT_THAT(frame.waters, ::testing::IsEmpty());
  EXPECT_THAT(frame.glows, ::testing::IsEmpty());
}

TEST_F(Pool, HasACornerMoreThanCells) {
  Memory memory;
  const render::Frame frame = frameOf(packetWithPool(100), memory, 100.0);
  ASSERT_EQ(frame.waters.size(), 1u);
  EXPECT_EQ(frame.waters[0].heights.size(), 21u * 41u);
  EXPECT_EQ(frame.waters[0].foam.size(), 21u * 41u);
  EXPECT_THAT(frame.waters[0].foam, ::testing::Each(0.0f));
}

TEST_F(Pool, IsDisturbedWhereSomethingFellIn) {
  sim::FramePacket packet = packetWithPool(100);
  Memory still, memory;
  packet.events.push_back(splashAt(Vec3(0.4f, -0.5f, -5.0f)));
  memory.tick(packet);
  const render::Frame calm = frameOf(packet, still, 112.0), frame = frameOf(packet, memory, 112.0);
  const auto change = [&](int column, int row) {
    const auto i = static_cast<std::size_t>(row * 21 + column);
    return std::fabs(frame.waters[0].heights[i] - calm.waters[0].heights[i]);
  };
  EXPECT_GT(change(12, 25), 0.01f);  // its place
  EXPECT_LT(change(0, 0), 1e-4f);    // the far corner
  EXPECT_GT(frame.waters[0].foam[25 * 21 + 12], 0.5f);
  EXPECT_GT(frame.glows.size(), 10u) << "drops";
  EXPECT_THAT(frameOf(packet, memory, 100.0 + kMemoryTicks).waters[0].foam, ::testing::Each(0.0f));
}

TEST_F(Pool, LooksTheSameWhereverTheOriginIs) {
  Memory memory;
  sim::FramePacket packet = packetWithPool(100, -640.0);
  const render::Frame before = frameOf(packet, memory, 100.0);
  packet.originZ -= 64.0;
  packet.camera.position.z() += 64.0f;
  packet.rooms[0].waters[0].center.z() += 64.0f;
  const render::Frame after = frameOf(packet, memory, 100.0);
  ASSERT_EQ(after.waters.size(), 1u);
  for (std::size_t i = 0; i < before.waters[0].heights.size(); ++i)
    EXPECT_NEAR(after.waters[0].heights[i], before.waters[0].heights[i], 1e-4f);
}

TEST_F(Pool, WhatIsBehindOrInTheFogIsLeftOut) {
  Memory memory;
  sim::FramePacket packet = packetWithPool(100);
  packet.rooms[0].waters[0].center.z() = 6.0f;
  EXPECT_THAT(frameOf(packet, memory, 100.0).waters, ::testing::IsEmpty());
  packet.rooms[0].waters[0].center.z() = -40.0f;
  EXPECT_THAT(frameOf(packet, memory, 100.0).waters, ::testing::IsEmpty());
}

}  // namespace
}  // namespace brittle::view
