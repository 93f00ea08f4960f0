#include "game/view/ready_mesh.h"

#include <gtest/gtest.h>

#include "game/view/look.h"
#include "packets.h"

namespace brittle::view {
namespace {

/// Two boxes side by side whose tops lie at y = 0; the right one reflects.
sim::SegmentLook twoFloors() {
  sim::SegmentLook look;
  look.name = "floors";
  look.length = 2.0f;
  for (const float x : {-1.0f, 1.0f}) {
    sim::LookBox box;
    box.center = Vec3(x, -0.5f, -1.0f);
    box.halfExtents = Vec3(1.0f, 0.5f, 1.0f);
    box.reflects = x > 0.0f;
    look.boxes.push_back(box);
  }
  return look;
}

/// Their tops, a quad each, seen from above counter-clockwise or, `flipped`, clockwise. The reflecting one first.
content::BakedMesh tops(bool flipped) {
  content::BakedMesh mesh;
  for (const float left : {0.0f, -2.0f}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& [x, z] : {std::pair(0.0f, 0.0f), {2.0f, 0.0f}, {2.0f, -2.0f}, {0.0f, -2.0f}})
      mesh.vertices.push_back({Vec3(left + x, 0.0f, z), 0.0f, 0.0f, 0x80402010u});
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
  }
  if (flipped)
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 2]);
  return mesh;
}

float heightOfNormal(const render::BakedMesh& mesh, std::size_t first) {
  const Vec3& a = mesh.vertices[mesh.indices[first]].point;
  const Vec3& b = mesh.vertices[mesh.indices[first + 1]].point;
  const Vec3& c = mesh.vertices[mesh.indices[first + 2]].point;
  return (b - a).cross(c - a).y();
}

TEST(ReadyMesh, IsSeenFromOutsideHoweverItWasWound) {
  for (const bool flipped : {false, true}) {
    const render::BakedMesh mesh = readyMesh(tops(flipped), twoFloors());
    ASSERT_EQ(mesh.indices.size(), 12u);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) EXPECT_GT(heightOfNormal(mesh, i), 0.0f) << flipped;
    EXPECT_EQ(mesh.vertices[0].color, 0x80402010u);
  }
}

TEST(ReadyMesh, WhatLiesOnNoBoxStaysAsItIsWound) {
  sim::SegmentLook elsewhere = twoFloors();
  for (sim::LookBox& box : elsewhere.boxes) box.center.y() -= 1.0f;
  for (const bool flipped : {false, true}) {
    const render::BakedMesh mesh = readyMesh(tops(flipped), elsewhere);
    EXPECT_EQ(heightOfNormal(mesh, 0) < 0.0f, flipped);
    EXPECT_EQ(mesh.polished, 0u);
  }
}

TEST(ReadyMesh, FacesThatReflectStandLast) {
  const render::BakedMesh mesh = readyMesh(tops(false), twoFloors());
  EXPECT_EQ(mesh.polished, 6u);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(mesh.vertices[mesh.indices[i]].point.x() >= 0.0f && i >= 6, i >= 6);
}

TEST(ReadyMesh, AddingToOneKeepsWhatReflectsLast) {
  render::BakedMesh mesh = readyMesh(tops(false), twoFloors());
  append(readyMesh(tops(false), twoFloors()), mesh);
  EXPECT_EQ(mesh.vertices.size(), 16u);
  EXPECT_EQ(mesh.indices.size(), 24u);
  EXPECT_EQ(mesh.polished, 12u);
  for (std::size_t i = 0; i < 24; ++i) {
    ASSERT_LT(mesh.indices[i], 16u);
    const float x = mesh.vertices[mesh.indices[i]].point.x();
    EXPECT_TRUE(i < 12 ? x <= 0.0f : x >= 0.0f) << i;
  }
}

TEST(ReadyMesh, OnlyStonesAreBakedBesideIt) {
  sim::SegmentLook look = twoFloors();
  EXPECT_TRUE(bakerOf(look, Baked::Stones).finish().indices.empty());
  sim::LookBox stone = look.boxes[0];
  stone.center.y() = 0.5f;
  stone.isStone = true;
  look.boxes.push_back(stone);
  const render::BakedMesh mesh = bakerOf(look, Baked::Stones).finish();
  ASSERT_FALSE(mesh.indices.empty());
  for (const render::StaticVertex& vertex : mesh.vertices) EXPECT_LE(std::abs(vertex.point.y() - 0.5f), 0.5f);
}

}  // namespace
}  // namespace brittle::view
