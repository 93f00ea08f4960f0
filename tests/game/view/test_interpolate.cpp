#include "game/view/interpolate.h"

#include <gtest/gtest.h>

#include "packets.h"

namespace brittle::view {
namespace {

/// Two ticks in which everything moves by (1, 0, 0) / 4 and turns by a tenth.
struct TwoTicks {
  TwoTicks() : before(packetAt(7)), now(packetAt(8)) {
    for (int i = 0; i < 2; ++i) {
      sim::FramePacket& packet = i == 0 ? before : now;
      const float step = static_cast<float>(i);
      const Transform pose{Vec3(0.25f * step, 1.0f, -3.0f), rotationAbout(Vec3::UnitY(), 0.1f * step)};
      packet.camera.position = pose.position;
      packet.camera.rotation = pose.rotation;
      packet.balls.push_back({3, pose, 0.13f});
      packet.rooms[0].bodies.push_back({pose, 5});
      packet.rooms[0].crumbs.push_back({pose.position, 0.01f, 0xffffffff});
      packet.rooms[0].ropes.push_back({pose.position, pose.position + Vec3::UnitY()});
    }
  }
  sim::FramePacket before, now, seen;
};

TEST(Interpolate, EndsAtTheLaterPacketBitForBit) {
  TwoTicks t;
  interpolate(t.before, t.now, 1.0f, t.seen);
  EXPECT_EQ(t.seen.camera.position, t.now.camera.position);
  EXPECT_EQ(t.seen.camera.rotation.coeffs(), t.now.camera.rotation.coeffs());
  EXPECT_EQ(t.seen.balls[0].pose.rotation.coeffs(), t.now.balls[0].pose.rotation.coeffs());
  EXPECT_EQ(t.seen.rooms[0].bodies[0].pose.position, t.now.rooms[0].bodies[0].pose.position);
}

TEST(Interpolate, BeginsAtTheEarlierPacket) {
  TwoTicks t;
  interpolate(t.before, t.now, 0.0f, t.seen);
  EXPECT_EQ(t.seen.camera.position, t.before.camera.position);
  EXPECT_EQ(t.seen.balls[0].pose.position, t.before.balls[0].pose.position);
  EXPECT_EQ(t.seen.rooms[0].bodies[0].pose.position, t.before.rooms[0].bodies[0].pose.position);
  EXPECT_EQ(t.seen.rooms[0].crumbs[0].position, t.before.rooms[0].crumbs[0].position);
  EXPECT_EQ(t.seen.rooms[0].ropes[0].from, t.before.rooms[0].ropes[0].from);
  EXPECT_LT(t.seen.camera.rotation.angularDistance(t.before.camera.rotation), 1e-4f);
}

TEST(Interpolate, IsHalfwayInTheMiddle) {
  TwoTicks t;
  interpolate(t.before, t.now, 0.5f, t.seen);
  EXPECT_FLOAT_EQ(t.seen.rooms[0].bodies[0].pose.position.x(), 0.125f);
  const Quat half = rotationAbout(Vec3::UnitY(), 0.05f);
  EXPECT_LT(t.seen.rooms[0].bodies[0].pose.rotation.angularDistance(half), 1e-4f);
  EXPECT_FLOAT_EQ(t.seen.camera.rotation.norm(), 1.0f);
}

TEST(Interpolate, TurnsTheShortWayRound) {
  TwoTicks t;
  t.before.camera.rotation.coeffs() = -t.before.camera.rotation.coeffs();  // the same attitude
  interpolate(t.before, t.now, 0.5f, t.seen);
  EXPECT_LT(t.seen.camera.rotation.angularDistance(rotationAbout(Vec3::UnitY(), 0.05f)), 1e-4f);
}

TEST(Interpolate, AnOriginShiftMovesNothing) {
  TwoTicks t, shifted;
  const float shift = 64.0f;
  shifted.before.originZ = 1'000'064.0;  // the earlier frame's origin lies 64 m behind the later one's
  shifted.now.originZ = 1'000'000.0;
  for (sim::BodyPose& body : shifted.before.rooms[0].bodies) body.pose.position.z() -= shift;
  shifted.before.camera.position.z() -= shift;
  interpolate(t.before, t.now, 0.25f, t.seen);
  interpolate(shifted.before, shifted.now, 0.25f, shifted.seen);
  EXPECT_EQ(shifted.seen.camera.position, t.seen.camera.position);
  EXPECT_EQ(shifted.seen.rooms[0].bodies[0].pose.position, t.seen.rooms[0].bodies[0].pose.position);
}

TEST(Interpolate, WhatIsNewStandsWhereItIs) {
  TwoTicks t;
  t.now.rooms[0].bodies[0].generation = 6;
  t.now.balls[0].id = 4;
  t.now.rooms[0].crumbs[0].position.y() = 9.0f;  // a recycled place
  interpolate(t.before, t.now, 0.0f, t.seen);
  EXPECT_EQ(t.seen.rooms[0].bodies[0].pose.position, t.now.rooms[0].bodies[0].pose.position);
  EXPECT_EQ(t.seen.balls[0].pose.position, t.now.balls[0].pose.position);
  EXPECT_EQ(t.seen.rooms[0].crumbs[0].position, t.now.rooms[0].crumbs[0].position);
}

TEST(Interpolate, FollowsARoomIntoTheFirstPlace) {
  TwoTicks t;
  t.before.rooms.push_back(t.before.rooms[0]);  // what is the first room now was the second
  t.before.rooms[1].number = t.now.rooms[0].number = 12;
  t.before.rooms[0].bodies[0].pose.position.x() = -100.0f;
  interpolate(t.before, t.now, 0.0f, t.seen);
  EXPECT_EQ(t.seen.rooms[0].bodies[0].pose.position.x(), 0.0f);
}

TEST(Interpolate, DoesNotBlendOverAGap) {
  TwoTicks t;
  t.before.tick = 6;
  interpolate(t.before, t.now, 0.0f, t.seen);
  EXPECT_EQ(t.seen.camera.position, t.now.camera.position);
}

}  // namespace
}  // namespace brittle::view
