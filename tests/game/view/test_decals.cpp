#include "game/view/decals.h"

#include <gtest/gtest.h>

#include "packets.h"

namespace brittle::view {
namespace {

std::vector<render::Decal> decalsOf(const sim::FramePacket& packet, const Memory& memory, double tick) {
  render::Frame frame;
  addDecals(packet, memory, tick, frame);
  return frame.decals;
}

/// A ball hits the floor of the packet's room, at y = 0.
Memory hitAt(sim::FramePacket packet, const Vec3& point, float speed, std::int32_t byBall = 1) {
  sim::Event hit = eventOf(sim::EventType::Hit, point);
  hit.look = sim::Look::Static;
  hit.speed = speed;
  hit.value = byBall;
  packet.events.push_back(hit);
  Memory memory;
  memory.tick(packet);
  return memory;
}

TEST(Decals, OfALevelLieWhereItSays) {
  sim::FramePacket packet = packetAt(10);
  auto look = std::make_shared<sim::SegmentLook>(*packet.rooms[0].segments[0].look);
  sim::LookDecal decal;
  decal.position = Vec3(1.0f, 0.0f, -2.0f);
  decal.rotation = rotationAbout(Vec3::UnitX(), -1.5707963f);
  decal.tile = -2;
  decal.blend = 0.0f;
  look->decals.push_back(decal);
  packet.rooms[0].segments[0] = {1, Vec3(0.0f, 0.0f, -16.0f), look};
  const std::vector<render::Decal> seen = decalsOf(packet, {}, 10.0);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_LT((seen[0].position - Vec3(1.0f, 0.0f, -18.0f)).norm(), 0.01f);
  EXPECT_GT(seen[0].position.y(), 0.0f);  // a little above the floor it lies on
  EXPECT_EQ(seen[0].tile, -2);
  EXPECT_EQ(seen[0].cover, 0.0f);
}

TEST(Decals, OfABodyMovesWithIt) {
  sim::FramePacket packet = packetAt(10);
  const Quat turned = rotationAbout(Vec3::UnitY(), 1.5707963f);
  packet.rooms[0].bodies = {{}, {{Vec3(1.0f, 2.0f, -3.0f), turned}, 4}};
  sim::BodyDecal decal;
  decal.body = 1;
  decal.look.position = Vec3(0.0f, 0.0f, 0.5f);
  decal.look.tile = 7;
  packet.rooms[0].bodyDecals = {decal};
  const std::vector<render::Decal> seen = decalsOf(packet, {}, 10.0);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_LT((seen[0].position - Vec3(1.5f, 2.0f, -3.0f)).norm(), 0.01f);
  EXPECT_GT(seen[0].position.x(), 1.5f) << "a little above the face it lies on";
  EXPECT_LT((seen[0].rotation * Vec3::UnitZ() - Vec3::UnitX()).norm(), 1e-5f);
  packet.rooms[0].bodies[1].generation = 0;
  EXPECT_TRUE(decalsOf(packet, {}, 10.0).empty()) << "its body is gone";
  packet.rooms[0].bodyDecals[0].body = 9;
  EXPECT_TRUE(decalsOf(packet, {}, 10.0).empty());
}

TEST(Decals, FastBallsMarkTheFaceTheyHit) {
  const sim::FramePacket packet = packetAt(100);
  const Memory memory = hitAt(packet, Vec3(0.5f, 0.01f, -3.0f), 15.0f);
  const std::vector<render::Decal> seen = decalsOf(packet, memory, 100.0);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_NEAR(seen[0].position.y(), 0.0f, 0.01f);
  EXPECT_LT((seen[0].rotation * Vec3::UnitZ() - Vec3::UnitY()).norm(), 1e-5f);
  EXPECT_LT(decalsOf(packet, memory, 270.0)[0].color >> 24, seen[0].color >> 24);  // it fades
}

TEST(Decals, NothingElseMarks) {
  const sim::FramePacket packet = packetAt(100);
  EXPECT_TRUE(decalsOf(packet, hitAt(packet, Vec3(0.5f, 0.01f, -3.0f), 2.0f), 100.0).empty()) << "too slow";
  EXPECT_TRUE(decalsOf(packet, hitAt(packet, Vec3(0.5f, 0.01f, -3.0f), 15.0f, 0), 100.0).empty()) << "not a ball";
  EXPECT_TRUE(decalsOf(packet, hitAt(packet, Vec3(0.5f, 1.0f, -3.0f), 15.0f), 100.0).empty()) << "no face near";
}

}  // namespace
}  // namespace brittle::view
