// A blast as it is seen; glareOf and addExplosion stand in game/view/power_ups.h.
#include <gtest/gtest.h>

#include "game/view/power_ups.h"
#include "packets.h"

namespace brittle::view {
namespace {

render::Frame blast(float age, float size = 9.0f, std::uint64_t key = 7) {
  sim::Event event = eventOf(sim::EventType::Explosion, Vec3(0.0f, 1.0f, -6.0f));
  event.size = size;
  render::Frame frame;
  addExplosion(event, event.point, age, key, frame);
  return frame;
}

TEST(ExplosionLook, BeginsAsLightAndEndsAsSmoke) {
  EXPECT_GT(blast(0.5f).glows.size(), 10u);
  EXPECT_FALSE(blast(20.0f).beams.empty()) << "glowing bits";
  for (const render::Glow& glow : blast(80.0f).glows) EXPECT_GT(glow.cover, 0.5f) << "smoke hides what is behind it";
  EXPECT_FALSE(blast(80.0f).glows.empty());
  EXPECT_TRUE(blast(kBlastTicks).glows.empty());
}

TEST(ExplosionLook, ALargerOneIsLargerAndAnotherOneIsAnother) {
  const auto reach = [](const render::Frame& frame) {
    float farthest = 0.0f;
    for (const render::Beam& beam : frame.beams) farthest = maxOf(farthest, (beam.to - Vec3(0.0f, 1.0f, -6.0f)).norm());
    return farthest;
  };
  EXPECT_GT(reach(blast(20.0f, 9.0f)), 1.3f * reach(blast(20.0f, 3.0f)));
  EXPECT_EQ(reach(blast(20.0f, 9.0f, 7)), reach(blast(20.0f, 9.0f, 7)));
  EXPECT_NE(blast(20.0f, 9.0f, 7).beams[0].to, blast(20.0f, 9.0f, 8).beams[0].to);
}

TEST(ExplosionLook, ANearOneLightsUpThePictureForAnInstant) {
  sim::Event event;
  event.size = 9.0f;
  EXPECT_GT(glareOf(event, 0.0f, 1.0f), 0.8f);
  EXPECT_GT(glareOf(event, 0.0f, 1.0f), glareOf(event, 0.0f, 15.0f));
  EXPECT_EQ(glareOf(event, 0.0f, 30.0f), 0.0f);
  EXPECT_EQ(glareOf(event, 15.0f, 1.0f), 0.0f);
}

}  // namespace
}  // namespace brittle::view
