#include "engine/render/bake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/render/bake_lines.h"
#include "engine/render/bake_shade.h"

namespace brittle::render {
namespace {

float openness(const StaticVertex& v) {
  return static_cast<float>(v.color >> 24) / 255.0f;
}

BakeBox box(const Vec3& center, const Vec3& half) {
  BakeBox b;
  b.center = center;
  b.halfExtents = half;
  return b;
}

TEST(Bake, CutsFacesIntoTilesWithAShortLastOne) {
  BakeBox b = box(Vec3::Zero(), Vec3(1.25f, 0.5f, 0.5f));  // 2.5 x 1 x 1
  b.tile = {9, 9, 9};
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
    const Vec3 normal =
        (mesh.vertices[mesh.indices[i + 1]].point - p).cross(mesh.vertices[mesh.indices[i + 2]].point - p);
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
  EXPECT_GT(corner, 0.2f);  // half the sky is the wall's
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

TEST(Bake, AFloorIsAsOpenOnTheLineOfAWallAsBeforeIt) {
  // The wall's side does not come out of the sum of centre and half extents as a round number.
  const std::vector<BakeBox> boxes = {box(Vec3(0.0f, -0.5f, 0.0f), Vec3(5.0f, 0.5f, 2.0f)),
                                      box(Vec3(-4.2f, 1.5f, 0.0f), Vec3(0.2f, 2.5f, 2.0f))};
  float least = 1.0f;
  for (const StaticVertex& v : bake(boxes, {}).vertices)
    if (v.point.y() == 0.0f && std::fabs(v.point.x() + 4.0f) < 1e-4f) least = minOf(least, openness(v));
  EXPECT_GT(least, 0.2f);
}

TEST(Bake, LampsShineOnWhatFacesThem) {
  std::vector<BakeBox> boxes = {box(Vec3(0.0f, -0.5f, 0.0f), Vec3(2.0f, 0.5f, 2.0f))};
  const BakeDef dim{.light = {.top = 0.4f, .front = 0.4f}};
  const BakedMesh dark = bake(boxes, dim);
  boxes.push_back(box(Vec3(0.0f, 2.0f, 0.0f), Vec3(0.2f, 0.05f, 1.0f)));
  boxes.back().glow = 1.0f;
  const BakedMesh lit = bake(boxes, dim);
  int most = 0;
  for (const StaticVertex& v : lit.vertices) {
    if (v.point.y() > 0.5f) continue;  // of the lamp
    EXPECT_EQ(openness(v), 1.0f) << "a lamp casts no shade";
    EXPECT_GE(v.color & 0xffu, dark.vertices[0].color & 0xffu);
    if (v.point.y() == 0.0f) most = maxOf(most, static_cast<int>(v.color & 0xffu) - 51);
  }
  EXPECT_GT(most, 10);
  EXPECT_EQ(lit.vertices.back().color, 0xff808080u) << "the lamp itself is as bright as white gets";
}

TEST(Bake, LampsDoNotShineThroughThings) {
  std::vector<BakeBox> boxes = {box(Vec3(0.0f, -0.5f, 0.0f), Vec3(2.0f, 0.5f, 2.0f)),
                                box(Vec3(0.0f, 3.0f, 0.0f), Vec3(0.2f, 0.05f, 0.2f))};
  boxes[1].glow = 4.0f;
  const auto redInTheMiddle = [](const BakedMesh& mesh) {
    for (const StaticVertex& v : mesh.vertices)
      if (v.point == Vec3::Zero()) return static_cast<int>(v.color & 0xffu);
    return -1;
  };
  const BakeDef dim{.light = {.top = 0.4f}};
  const int lit = redInTheMiddle(bake(boxes, dim));
  boxes.push_back(box(Vec3(0.0f, 1.5f, 0.0f), Vec3(1.0f, 0.1f, 1.0f)));
  EXPECT_GT(lit, 60);
  EXPECT_EQ(redInTheMiddle(bake(boxes, dim)), 51);  // 0.4 / 2, nothing more
}

TEST(Bake, LightBeyondWhiteKeepsItsOrder) {
  std::vector<BakeBox> boxes = {box(Vec3(0.0f, -0.5f, 0.0f), Vec3(2.0f, 0.5f, 2.0f))};
  const auto redAt = [&boxes](float light) { return bake(boxes, {.light = {.top = light}}).vertices[0].color & 0xffu; };
  EXPECT_LT(redAt(0.9f), redAt(1.2f));
  EXPECT_LT(redAt(1.2f), redAt(3.0f));
  EXPECT_LT(redAt(100.0f), 128u);
}

TEST(Bake, AFaceAtATimeGivesTheSame) {
  std::vector<BakeBox> boxes = {box(Vec3(0.0f, -0.5f, 0.0f), Vec3(2.0f, 0.5f, 2.0f)),
                                box(Vec3(0.0f, 3.0f, 0.0f), Vec3(0.2f, 0.05f, 0.2f))};
  boxes[1].glow = 1.0f;
  const BakedMesh whole = bake(boxes, {.beyond = boxes});
  std::vector<BakeBox> gone = boxes;
  Baker baker(gone, {.beyond = gone});
  gone.clear();  // it keeps what it needs
  gone.shrink_to_fit();
  int faces = 0;
  while (baker.step()) ++faces;
  EXPECT_EQ(faces, 4);  // top and front of the floor, underside and front of the lamp
  const BakedMesh mesh = baker.finish();
  EXPECT_EQ(mesh.indices, whole.indices);
  ASSERT_EQ(mesh.vertices.size(), whole.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) EXPECT_EQ(mesh.vertices[i].color, whole.vertices[i].color);
}

TEST(Bake, PolishedFacesComeLast) {
  std::vector<BakeBox> boxes = {box(Vec3(0.0f, -0.5f, 0.0f), Vec3(0.5f, 0.5f, 0.5f)),
                                box(Vec3(3.0f, -0.5f, 0.0f), Vec3(0.5f, 0.5f, 0.5f))};
  EXPECT_EQ(bake(boxes, {}).polished, 0u);
  boxes[0].reflects = true;
  const BakedMesh mesh = bake(boxes, {});
  ASSERT_GT(mesh.polished, 0u);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    EXPECT_EQ(mesh.vertices[mesh.indices[i]].point.x() < 1.0f, i >= mesh.indices.size() - mesh.polished);
}

TEST(Bake, CutsWhatIsEvenOnlyAtTiles) {
  BakeBox b = box(Vec3(0.0f, -3.0f, 0.0f), Vec3(8.0f, 0.5f, 8.0f));
  EXPECT_EQ(bake(std::span(&b, 1), {.allFaces = true}).vertices.size(), 6u * 4);  // a plain tile has no end
  b.tile = {9, 9, 9};
  b.tileSize = {4.0f, 4.0f, 4.0f};
  EXPECT_EQ(bake(std::span(&b, 1), {.allFaces = true}).vertices.size(), (4u * 4 + 2 * 16) * 4);
}

TEST(Bake, TilesRunOnAcrossTheCutsBetweenThem) {
  std::vector<BakeBox> boxes = {box(Vec3(0.0f, -0.5f, 0.0f), Vec3(2.0f, 0.5f, 2.0f)),
                                box(Vec3(0.3f, 0.5f, 0.2f), Vec3(0.3f, 0.5f, 0.4f))};
  boxes[0].tile = {9, 9, 9};
  boxes[0].tileSize = {4.0f, 4.0f, 4.0f};
  const BakedMesh mesh = bake(boxes, {});
  std::size_t onTop = 0;
  for (const StaticVertex& v : mesh.vertices) {
    if (v.point.y() != 0.0f || v.u < 0.125f || v.v < 0.125f || v.point.z() == 2.0f) continue;  // of the floor's top
    ++onTop;
    // One tile of 4 m: its texture coordinates are an even function of the place.
    EXPECT_NEAR(v.u, 0.125f + 1.0f / 256 + (v.point.z() + 2.0f) / 4.0f * (0.125f - 2.0f / 256), 1e-4f);
  }
  EXPECT_GT(onTop, 20u);
}

std::uint32_t grey(std::uint32_t level) {
  return level * 0x010101u | 0xff000000u;
}

TEST(Shade, EvenPartsBecomeOneRectangle) {
  Shade shade{{0.0f, 1.0f, 2.0f, 3.0f, 4.0f}, {0.0f, 1.0f, 2.0f}, {}};
  for (const std::uint32_t level : {0u, 50u, 100u, 20u, 20u, 0u, 51u, 99u, 20u, 20u, 0u, 50u, 100u, 20u, 60u})
    shade.colors.push_back(grey(level));
  const std::vector<Patch> patches = evenPatches(shade, {0, 4, 0, 2});
  ASSERT_EQ(patches.size(), 4u);  // the ramp, the step down, the plain cell and the one with a bright corner
  EXPECT_EQ(patches[0].right, 2u);
  EXPECT_EQ(patches[0].high, 2u);
  std::size_t cells = 0;
  for (const Patch& p : patches) cells += (p.right - p.left) * (p.high - p.low);
  EXPECT_EQ(cells, 8u);
}

TEST(Bake, NeighboursShareTheCornersOnTheirBorders) {
  std::vector<BakeBox> boxes = {box(Vec3(0.0f, -0.5f, 0.0f), Vec3(4.0f, 0.5f, 4.0f)),
                                box(Vec3(0.7f, 0.5f, 0.2f), Vec3(0.3f, 0.5f, 0.4f))};
  boxes[0].tile = {9, 9, 9};
  boxes[0].tileSize = {2.0f, 2.0f, 2.0f};
  const BakedMesh mesh = bake(boxes, {});
  // Each border between two triangles of the floor has the same two ends on both sides: none ends within another.
  std::map<std::array<float, 4>, int> borders;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 a = mesh.vertices[mesh.indices[t + k]].point, b = mesh.vertices[mesh.indices[t + (k + 1) % 3]].point;
      const Vec3 c = mesh.vertices[mesh.indices[t + (k + 2) % 3]].point;
      if (a.y() != 0.0f || b.y() != 0.0f || c.y() != 0.0f) continue;
      const bool turned = std::pair(a.x(), a.z()) > std::pair(b.x(), b.z());
      const Vec3 &p = turned ? b : a, &q = turned ? a : b;
      borders[{p.x(), p.z(), q.x(), q.z()}] += turned ? 1 : -1;
    }
  }
  for (const auto& [ends, balance] : borders) {
    const bool onRim =
        (std::fabs(ends[0]) == 4.0f && ends[0] == ends[2]) || (std::fabs(ends[1]) == 4.0f && ends[1] == ends[3]);
    EXPECT_TRUE(onRim || balance == 0) << ends[0] << " " << ends[1] << " to " << ends[2] << " " << ends[3];
  }
  EXPECT_GT(borders.size(), 40u);
}

TEST(CutLines, KeepTilesAndOutlinesAndSpareSlivers) {
  const Aabb face{Vec3(0.0f, 0.0f, 0.0f), Vec3(6.0f, 0.0f, 4.0f)};
  const Aabb pillar{Vec3(2.03f, 0.0f, 1.0f), Vec3(2.5f, 3.0f, 1.5f)};
  const std::vector<float> lines = cutLines({face, 1, 0, 2.0f}, std::span(&pillar, 1));
  for (const float at : {0.0f, 2.0f, 2.03f, 2.5f, 4.0f, 6.0f})
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [at](float x) { return std::fabs(x - at) < 1e-3f; })) << at;
  EXPECT_EQ(lines.front(), 0.0f);
  EXPECT_EQ(lines.back(), 6.0f);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    EXPECT_GT(lines[i], lines[i - 1]);
    EXPECT_LE(lines[i] - lines[i - 1], kLongestQuad + 1e-3f);
  }
  EXPECT_LT(lines.size(), 18u);
}

TEST(CutLines, OfAFarBoxDoNotMatter) {
  const Aabb face{Vec3(0.0f, 0.0f, 0.0f), Vec3(3.0f, 0.0f, 1.0f)};
  const Aabb above{Vec3(1.2f, 2.0f, 0.0f), Vec3(1.4f, 3.0f, 1.0f)};
  EXPECT_EQ(cutLines({face, 1, 0, 1.0f}, std::span(&above, 1)), (std::vector<float>{0.0f, 1.0f, 2.0f, 3.0f}));
}

}  // namespace
}  // namespace brittle::render
