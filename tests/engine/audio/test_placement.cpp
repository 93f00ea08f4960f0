#include "engine/audio/placement.h"

#include <gtest/gtest.h>

namespace brittle::audio {
namespace {

TEST(Placement, AheadIsInTheMiddle) {
  const Placement p = placementOf(Vec3(0.0f, 0.0f, -6.0f));
  EXPECT_FLOAT_EQ(p.left, p.right);
  EXPECT_NEAR(p.loudness(), 0.5f, 1e-5f);
}

TEST(Placement, ASideIsLouderAndTheWholeAsLoud) {
  const Placement right = placementOf(Vec3(4.0f, 0.0f, -3.0f)), left = placementOf(Vec3(-4.0f, 0.0f, -3.0f));
  EXPECT_GT(right.right, 2.0f * right.left);
  EXPECT_FLOAT_EQ(right.right, left.left);
  EXPECT_FLOAT_EQ(right.left, left.right);
  EXPECT_NEAR(right.loudness(), placementOf(Vec3(0.0f, 0.0f, -5.0f)).loudness(), 1e-5f);
}

TEST(Placement, FarIsQuieterDullerAndMoreOfTheRoom) {
  Placement before = placementOf(Vec3::Zero());
  EXPECT_NEAR(before.loudness(), 1.0f, 1e-5f);
  for (float distance = 2.0f; distance < 40.0f; distance += 2.0f) {
    const Placement p = placementOf(Vec3(0.0f, 0.0f, -distance));
    EXPECT_LT(p.loudness(), before.loudness());
    EXPECT_LT(p.cutoff, before.cutoff);
    EXPECT_GT(p.send, before.send);
    EXPECT_LT(p.send * p.loudness(), before.send * before.loudness()) << "the room's share falls too, but slower";
    before = p;
  }
}

TEST(Placement, PassesTheHeadWithoutAJump) {
  float before = placementOf(Vec3(-0.2f, 0.0f, 0.0f)).right;
  for (float x = -0.19f; x < 0.2f; x += 0.01f) {
    const float now = placementOf(Vec3(x, 0.0f, 0.0f)).right;
    EXPECT_NEAR(now, before, 0.02f);
    before = now;
  }
}

}  // namespace
}  // namespace brittle::audio
