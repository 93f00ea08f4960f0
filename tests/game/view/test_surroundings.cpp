#include "game/view/surroundings.h"

#include <gtest/gtest.h>

#include "packets.h"

namespace brittle::view {
namespace {

sim::LookBox boxOf(const Vec3& center, const Vec3& half, const Vec3& color) {
  sim::LookBox box;
  box.center = center;
  box.halfExtents = half;
  for (Vec3& face : box.color) face = color;
  return box;
}

/// Segments of 8 m, each a tunnel between x = -width and 2, y = 0 and 3.
sim::FramePacket tunnel(const std::vector<float>& widths) {
  sim::FramePacket packet = packetAt(10);
  packet.rooms[0].segments.clear();
  float start = 0.0f;
  for (const float width : widths) {
    auto look = std::make_shared<sim::SegmentLook>();
    look->length = 8.0f;
    const Vec3 half(4.0f, 0.5f, 4.0f), side(0.5f, 4.0f, 4.0f);
    look->boxes = {boxOf(Vec3(0.0f, -0.5f, -4.0f), half, Vec3(1.0f, 0.0f, 0.0f)),
                   boxOf(Vec3(0.0f, 3.5f, -4.0f), half, Vec3(0.0f, 1.0f, 0.0f)),
                   boxOf(Vec3(-width - 0.5f, 1.0f, -4.0f), side, Vec3(0.0f, 0.0f, 1.0f)),
                   boxOf(Vec3(2.5f, 1.0f, -4.0f), side, Vec3(1.0f, 1.0f, 0.0f))};
    packet.rooms[0].segments.push_back({1, Vec3(0.0f, 0.0f, -start), look});
    start += look->length;
  }
  return packet;
}

TEST(Surroundings, AreTheSidesOfTheRoom) {
  const render::Surroundings seen = surroundingsOf(tunnel({2.0f, 2.0f, 2.0f}), anyBounds());
  EXPECT_LT((seen.low - Vec2(-2.0f, 0.0f)).norm(), 1e-4f);
  EXPECT_LT((seen.high - Vec2(2.0f, 3.0f)).norm(), 1e-4f);
  EXPECT_LT((seen.floor - Vec3(1.0f, 0.0f, 0.0f)).norm(), 1e-4f);
  EXPECT_LT((seen.ceiling - Vec3(0.0f, 1.0f, 0.0f)).norm(), 1e-4f);
  EXPECT_LT((seen.left - Vec3(0.0f, 0.0f, 1.0f)).norm(), 1e-4f);
  EXPECT_LT((seen.right - Vec3(1.0f, 1.0f, 0.0f)).norm(), 1e-4f);
}

TEST(Surroundings, ChangeSmoothlyAsTheCameraFliesOn) {
  sim::FramePacket packet = tunnel({2.0f, 3.0f, 3.0f, 2.0f});
  float last = surroundingsOf(packet, anyBounds()).low.x(), widest = last;
  for (int step = 0; step < 200; ++step) {
    packet.camera.position.z() -= 0.08f;  // of a tick at 5 m/s
    const float low = surroundingsOf(packet, anyBounds()).low.x();
    EXPECT_LT(std::fabs(low - last), 0.02f);
    widest = minOf(widest, low);
    last = low;
  }
  EXPECT_LT(widest, -2.8f);
}

TEST(Surroundings, ListTheNearestLamps) {
  sim::FramePacket packet = tunnel({2.0f, 2.0f});
  auto look = std::make_shared<sim::SegmentLook>(*packet.rooms[0].segments[1].look);
  for (int i = 0; i < 12; ++i) {
    look->boxes.push_back(
        boxOf(Vec3(0.0f, 2.9f, -0.3f * static_cast<float>(i)), Vec3(0.1f, 0.05f, 0.1f), Vec3::Ones()));
    look->boxes.back().glow = 1.0f;
  }
  packet.rooms[0].segments[1].look = look;
  const render::Surroundings seen = surroundingsOf(packet, anyBounds());
  ASSERT_EQ(seen.lamps.size(), render::kMostMirroredLamps);
  EXPECT_FLOAT_EQ(seen.lamps[0].center.z(), -8.0f);
  EXPECT_GT(seen.lamps[0].light, 0.0f);
}

TEST(Surroundings, WithoutRoomsAreTheDefault) {
  EXPECT_EQ(surroundingsOf({}, anyBounds()).low, render::Surroundings().low);
  EXPECT_FALSE(mirrorHeightOf({}));
}

TEST(MirrorHeight, IsThatOfTheLargestPolishedFloor) {
  sim::FramePacket packet = tunnel({2.0f});
  EXPECT_FALSE(mirrorHeightOf(packet));
  auto look = std::make_shared<sim::SegmentLook>(*packet.rooms[0].segments[0].look);
  look->boxes[0].reflects = true;
  look->boxes[1].reflects = true;  // the ceiling: above the camera, it mirrors nothing that could be seen in it
  look->boxes.push_back(boxOf(Vec3(0.0f, 0.1f, -4.0f), Vec3(1.0f, 0.1f, 1.0f), Vec3::Ones()));
  look->boxes.back().reflects = true;
  packet.rooms[0].segments[0].look = look;
  ASSERT_TRUE(mirrorHeightOf(packet));
  EXPECT_FLOAT_EQ(*mirrorHeightOf(packet), 0.0f);
}

}  // namespace
}  // namespace brittle::view
