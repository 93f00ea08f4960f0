#include "game/view/look.h"

#include <gtest/gtest.h>

#include <iterator>
#include <map>

#include "game/view/lamps.h"
#include "packets.h"

namespace brittle::view {
namespace {

float redOf(const render::StaticVertex& vertex) {
  return static_cast<float>(vertex.color & 0xffu);
}

/// The vertices of triangles that look up at y = 0.
std::vector<render::StaticVertex> floorOf(const render::BakedMesh& mesh) {
  std::vector<render::StaticVertex> result;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const render::StaticVertex corners[] = {mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
                                            mesh.vertices[mesh.indices[i + 2]]};
    const bool isFlat = corners[0].point.y() == 0.0f && corners[1].point.y() == 0.0f && corners[2].point.y() == 0.0f;
    if (isFlat) result.insert(result.end(), std::begin(corners), std::end(corners));
  }
  return result;
}

TEST(Look, EveryLookHasAMaterial) {
  const std::vector<render::Material> table = materials();
  ASSERT_EQ(table.size(), static_cast<std::size_t>(sim::Look::PowerUp) + 1);
  EXPECT_LE(table.size(), render::kMaxMaterials);
  EXPECT_EQ(table[static_cast<std::size_t>(sim::Look::Glass)].look, render::Look::Glass);
  EXPECT_GT(table[static_cast<std::size_t>(sim::Look::Glass)].edge, 0.0f);
  EXPECT_EQ(table[static_cast<std::size_t>(sim::Look::Metal)].look, render::Look::Opaque);
}

TEST(Look, BakesTheSameTwice) {
  const sim::SegmentLook look = *packetAt(0).rooms[0].segments[0].look;
  const render::BakedMesh one = bakerOf(look).finish(), two = bakerOf(look).finish();
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
  const render::BakedMesh mesh = bakerOf(look).finish();
  std::map<float, std::pair<int, int>> range;  // least and most openness by x
  for (const render::StaticVertex& vertex : floorOf(mesh)) {
    const int open = static_cast<int>(vertex.color >> 24);
    auto& [least, most] = range.try_emplace(vertex.point.x(), open, open).first->second;
    least = minOf(least, open);
    most = maxOf(most, open);
  }
  EXPECT_GT(range.size(), 4u);
  EXPECT_LT(range.rbegin()->second.second, 200);  // it does darken by the wall
  for (const auto& [x, openness] : range) EXPECT_LE(openness.second - openness.first, 12) << "x = " << x;
}

TEST(Look, LampsShineOnAsFarBeyondASeamAsBeforeIt) {
  sim::SegmentLook look = *packetAt(0).rooms[0].segments[0].look;
  look.light[2] = 0.4f;
  look.light[4] = 0.0f;  // the front face, whose upper edge lies on the seam, too
  sim::LookBox lamp;
  lamp.halfExtents = Vec3(0.2f, 0.05f, 1.0f);
  lamp.glow = 1.0f;
  lamp.center = Vec3(0.0f, 3.0f, -2.0f);  // nearer to the segment's start than to its end
  look.boxes.push_back(lamp);
  const render::BakedMesh mesh = bakerOf(look).finish();
  float start = 0.0f, end = 0.0f;
  for (const render::StaticVertex& vertex : mesh.vertices) {
    if (vertex.point.y() != 0.0f) continue;
    if (vertex.point.z() == 0.0f) start = maxOf(start, redOf(vertex));
    if (vertex.point.z() == -8.0f) end = maxOf(end, redOf(vertex));
  }
  EXPECT_GT(start, 0.5f * 0.4f * 255.0f + 5.0f);
  EXPECT_NEAR(start, end, 2.0f);
}

TEST(Look, LampsHaveHalos) {
  sim::SegmentLook look = *packetAt(0).rooms[0].segments[0].look;
  std::vector<render::Glow> halos;
  addHalos(look, Vec3::Zero(), halos);
  EXPECT_TRUE(halos.empty());
  look.boxes[0].glow = 1.0f;
  addHalos(look, Vec3(0.0f, 0.0f, -16.0f), halos);
  ASSERT_FALSE(halos.empty());
  EXPECT_NEAR(halos[0].position.z(), -20.0f, 4.0f);
}

}  // namespace
}  // namespace brittle::view
