#include "game/view/look.h"

#include <gtest/gtest.h>

#include "game/view/lamps.h"
#include "packets.h"

namespace brittle::view {
namespace {

float redOf(const render::StaticVertex& vertex) {
  return static_cast<float>(vertex.color & 0xffu);
}

/// Openness of the floor's vertex nearest to a point.
std::uint32_t opennessNear(const render::BakedMesh& mesh, const Vec3& point) {
  const render::StaticVertex* nearest = &mesh.vertices[0];
  for (const render::StaticVertex& vertex : mesh.vertices)
    if ((vertex.point - point).squaredNorm() < (nearest->point - point).squaredNorm()) nearest = &vertex;
  return nearest->color >> 24;
}

TEST(Look, EveryLookHasAMaterial) {
  const std::vector<render::Material> table = materials();
  ASSERT_EQ(table.size(), static_cast<std::size_t>(sim::Look::Door) + 1);
  EXPECT_LE(table.size(), render::kMaxMaterials);
  EXPECT_EQ(table[static_cast<std::size_t>(sim::Look::Glass)].look, render::Look::Glass);
  EXPECT_GT(table[static_cast<std::size_t>(sim::Look::Glass)].edge, 0.0f);
  EXPECT_EQ(table[static_cast<std::size_t>(sim::Look::Metal)].look, render::Look::Opaque);
}

TEST(Look, BakesTheSameTwice) {
  const sim::SegmentLook look = *packetAt(0).rooms[0].segments[0].look;
  const render::BakedMesh one = bakeSegment(look), two = bakeSegment(look);
  ASSERT_FALSE(one.indices.empty());
  ASSERT_EQ(one.vertices.size(), two.vertices.size());
  for (std::size_t i = 0; i < one.vertices.size(); ++i) EXPECT_EQ(one.vertices[i].color, two.vertices[i].color);
}

TEST(Look, WallsDarkenAsMuchAtASeamAsInTheMiddle) {
  sim::SegmentLook look = *packetAt(0).rooms[0].segments[0].look;
  look.length = 16.0f;
  look.boxes[0].center.z() = -8.0f;
  look.boxes[0].halfExtents.z() = 8.0f;
  sim::LookBox wall = look.boxes[0];
  wall.center = Vec3(2.5f, 2.0f, -8.0f);
  wall.halfExtents = Vec3(0.5f, 2.0f, 8.0f);
  look.boxes.push_back(wall);
  const render::BakedMesh mesh = bakeSegment(look);
  const auto middle = static_cast<int>(opennessNear(mesh, Vec3(1.0f, 0.0f, -8.0f)));
  EXPECT_LT(middle, 240);
  EXPECT_NEAR(static_cast<int>(opennessNear(mesh, Vec3(1.0f, 0.0f, 0.0f))), middle, 12);
  EXPECT_NEAR(static_cast<int>(opennessNear(mesh, Vec3(1.0f, 0.0f, -16.0f))), middle, 12);
}

TEST(Lamps, ShineOnWhatFacesThem) {
  sim::SegmentLook look = *packetAt(0).rooms[0].segments[0].look;
  look.light[2] = 0.5f;
  const render::BakedMesh dark = bakeSegment(look);
  sim::LookBox lamp;
  lamp.center = Vec3(0.0f, 3.0f, -4.0f);
  lamp.halfExtents = Vec3(0.2f, 0.05f, 1.0f);
  lamp.glow = 1.0f;
  look.boxes.push_back(lamp);
  const render::BakedMesh lit = bakeSegment(look);
  float most = 0.0f;
  for (std::size_t i = 0; i < dark.vertices.size(); ++i) {
    ASSERT_EQ(lit.vertices[i].point, dark.vertices[i].point);
    EXPECT_GE(redOf(lit.vertices[i]), redOf(dark.vertices[i]));
    most = maxOf(most, redOf(lit.vertices[i]) - redOf(dark.vertices[i]));
  }
  EXPECT_GT(most, 10.0f);
  EXPECT_EQ(lit.vertices.back().color & 0xffffffu, 0x808080u);  // the lamp itself is as bright as white gets

  std::vector<render::Glow> halos;
  addHalos(look, Vec3::Zero(), halos);
  EXPECT_FALSE(halos.empty());
}

TEST(Lamps, WithoutThemNothingChanges) {
  const sim::SegmentLook look = *packetAt(0).rooms[0].segments[0].look;
  render::BakedMesh mesh = bakeSegment(look);
  const std::uint32_t before = mesh.vertices[0].color;
  lightByLamps(look, mesh);
  EXPECT_EQ(mesh.vertices[0].color, before);
}

}  // namespace
}  // namespace brittle::view
