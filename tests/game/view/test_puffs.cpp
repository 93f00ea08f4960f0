#include "game/view/smoke.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "packets.h"

namespace brittle::view {
namespace {

TEST(Puffs, GrowWithTheRootOfTheirAge) {
  const float start = puffRadius(0.0f);
  EXPECT_GT(start, 0.0f);
  EXPECT_NEAR(puffRadius(2.0f) - start, 2.0f * (puffRadius(0.5f) - start), 1e-6f);
}

TEST(Puffs, AreStoppedByTheAir) {
  EXPECT_NEAR(puffDrift(0.01f), 0.01f, 1e-3f);
  const float h = 1e-3f;  // its speed falls as exp(-1.6 t)
  const auto speed = [&](float t) { return (puffDrift(t + h) - puffDrift(t - h)) / (2.0f * h); };
  EXPECT_NEAR(speed(1.0f), std::exp(-1.6f), 2e-3f);
  EXPECT_NEAR(speed(2.0f) / speed(1.0f), std::exp(-1.6f), 5e-3f);
}

TEST(Puffs, FadeToNothingBeforeTheyAreForgotten) {
  EXPECT_LT(kPuffSeconds * 60.0f, static_cast<float>(kMemoryTicks));
  for (float age = 0.2f; age < kPuffSeconds; age += 0.1f) EXPECT_GT(puffCover(age), puffCover(age + 0.1f));
  EXPECT_EQ(puffCover(kPuffSeconds), 0.0f);
  EXPECT_LT(puffCover(kPuffSeconds - 0.05f), 0.01f);
}

TEST(Puffs, OfRememberedEventsAreDrawnFarthestFirst) {
  Memory memory;
  for (std::uint64_t tick = 40; tick < 60; ++tick) {
    sim::FramePacket packet = packetAt(tick);
    packet.events.push_back(eventOf(sim::EventType::Smoke, Vec3(0.0f, 1.0f, tick % 2 == 0 ? -3.0f : -6.0f)));
    packet.events.back().direction = Vec3(0.0f, 1.0f, 0.0f);
    memory.tick(packet);
  }
  render::Frame frame;
  const sim::FramePacket packet = packetAt(60);
  frame.camera.position = packet.camera.position;
  addSmoke(packet, memory, 60.0, anyBounds(), frame);
  ASSERT_EQ(frame.puffs.size(), 20u);
  for (std::size_t i = 1; i < frame.puffs.size(); ++i)
    EXPECT_LE((frame.puffs[i].position - frame.camera.position).norm(),
              (frame.puffs[i - 1].position - frame.camera.position).norm());
  for (const render::Puff& puff : frame.puffs) EXPECT_GT(puff.position.y(), 0.9f) << "they rise";
  render::Frame later;
  addSmoke(packet, memory, 60.0 + 60.0 * static_cast<double>(kPuffSeconds), anyBounds(), later);
  EXPECT_THAT(later.puffs, ::testing::IsEmpty());
}

}  // namespace
}  // namespace brittle::view
