#include "engine/render/bake.h"

#include <gtest/gtest.h>

namespace brittle::render {
namespace {

float openness(const StaticVertex& v) { return static_cast<float>(v.color >> 24) / 255.0f; }

BakeBox box(const Vec3& center, const Vec3& half) {
  BakeBox b;
  b.center = center;
  b.halfExtents = half;
  return b;
}

TEST(Bake, CutsFacesIntoTilesWithAShortLastOne) {
  BakeBox b = box(Vec3::Zero(), Vec3(1.25f, 0.5f, 0.5f));  // 2.5 x 1 x 1
  const BakedMesh mesh = bake(std::span(&b, 1), {.allFaces = true});
  // X faces: 1 quad each; Y and Z faces: 3 each.
  EXPECT_EQ(mesh.vertices.size(), (2u * 1 + 4u * 3) * 4);
  EXPECT_EQ(mesh.indices.size(), mesh.vertices.size() / 4 * 6);
}

TEST(Bake, TrianglesLookOutwards) {
  BakeBox b = box(Vec3(1.0f, 2.0f, 3.0f), Vec3(0.5f, 0.7f, 0.9f));
  const BakedMesh mesh = bake(std::span(&b, 1), {.allFaces = true});
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3& p = mesh.vertices[mesh.indices[i]].point;
    const Vec3 normal = (mesh.vertices[mesh.indices[i + 1]].point - p).cross(mesh.vertices[mesh.indices[i + 2]].point - p);
    EXPECT_GT(normal.dot(p - b.center), 0.0f);
  }
}

TEST(Bake, LeavesOutFacesTheTravellingCameraNeverSees) {
  BakeBox floor = box(Vec3(0.0f, -0.5f, 0.0f), Vec3(0.5f, 0.5f, 0.5f));
  const BakedMesh mesh = bake(std::span(&floor, 1), {});
  bool hasTop = false;
  for (const StaticVertex& v : mesh.vertices) hasTop |= v.point.y() == 0.0f;
  EXPECT_TRUE(hasTop);
  EXPECT_EQ(mesh.vertices.size(), 2u * 4);  // top and front; its sides are on the camera's side of nothing
}

TEST(Bake, DarkensCornersAndLeavesOpenPlacesOpen) {
  const std::vector<BakeBox> boxes = {box(Vec3(0.0f, -0.5f, 0.0f), Vec3(6.0f, 0.5f, 6.0f)),
                                      box(Vec3(6.5f, 2.0f, 0.0f), Vec3(0.5f, 3.0f, 6.0f))};
  const BakedMesh mesh = bake(boxes, {});
  float corner = 1.0f, open = 0.0f;
  for (const StaticVertex& v : mesh.vertices) {
    if (v.point.y() != 0.0f) continue;  // the floor
    if (v.point.x() == 6.0f) corner = minOf(corner, openness(v));
    if (v.point.x() < 0.0f) open = maxOf(open, openness(v));
  }
  EXPECT_FLOAT_EQ(open, 1.0f);
  EXPECT_GT(corner, 0.3f);  // half the sky is the wall's
  EXPECT_LT(corner, 0.75f);
}

TEST(Bake, StoresHalfTheColourTimesTheLightOfTheFace) {
  BakeBox b = box(Vec3(0.0f, -3.0f, 0.0f), Vec3(0.5f, 0.5f, 0.5f));
  b.color[1] = Rgb(1.0f, 0.5f, 0.0f);
  const BakedMesh mesh = bake(std::span(&b, 1), {.light = {.top = 0.8f}});
  for (const StaticVertex& v : mesh.vertices) {
    if (v.point.y() != -2.5f || v.point.z() != -0.5f) continue;
    EXPECT_EQ(v.color & 0xff, 102u);  // 1 * 0.8 / 2
    EXPECT_EQ(v.color >> 8 & 0xff, 51u);
  }
}

TEST(Bake, TurnsTilesByQuarters) {
  BakeBox b = box(Vec3(0.0f, -3.0f, 0.0f), Vec3(0.5f, 0.5f, 0.5f));
  b.tile = {9, 9, 9};
  const BakedMesh plain = bake(std::span(&b, 1), {});
  b.tileRotation = {1, 1, 1};
  const BakedMesh turned = bake(std::span(&b, 1), {});
  EXPECT_FLOAT_EQ(plain.vertices[0].u, turned.vertices[3].u);
  for (const StaticVertex& v : plain.vertices) {  // tile 9 is in the second row and column
    EXPECT_GT(v.u, 0.125f);
    EXPECT_LT(v.u, 0.25f);
    EXPECT_GT(v.v, 0.125f);
    EXPECT_LT(v.v, 0.25f);
  }
}

}  // namespace
}  // namespace brittle::render
