#include "game/content/baked_mesh.h"

#include "content_helpers.h"
#include "mesh_baker.h"

#include "game/content/check.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <limits>

namespace brittle::content {
namespace {

using testing::HasSubstr;

/// A floor whose top is at y = 0, and a wall on its left.
Segment room() {
  return readSegment(
      "<segment size=\"12 10 4\" lightTop=\"1.2\" lightRight=\"0.5\">"
      "<box pos=\"0 -0.5 -2\" size=\"2 0.5 2\" color=\"1 0.5 0.25\" tile=\"9\"/>"
      "<box pos=\"-1.5 1 -2\" size=\"0.5 1 2\"/></segment>",
      "room.xml", {});
}

BakedMesh baked() {
  const Segment segment = room();
  return MeshBaker(segment).mesh();
}

/// The one line that is said of these bytes.
std::string faultOf(const std::string& bytes) {
  const BakedMesh mesh = readBakedMesh(bytes, "a.mesh");
  EXPECT_TRUE(mesh.vertices.empty() && mesh.indices.empty());
  EXPECT_EQ(mesh.problems.size(), 1u);
  return listed(mesh.problems);
}

/// Of the room's bytes with four of them changed.
template <class T>
std::string faultWith(std::size_t at, T value) {
  std::string bytes = meshBytes(baked(), 0);
  std::memcpy(bytes.data() + at, &value, sizeof value);
  return faultOf(archived(bytes));
}

TEST(BakedMesh, IsReadAsItWasBaked) {
  const BakedMesh wanted = baked();
  const BakedMesh mesh = readBakedMesh(meshFile(wanted), "a.mesh");
  EXPECT_EQ(listed(mesh.problems), "");
  ASSERT_EQ(mesh.vertices.size(), wanted.vertices.size());
  ASSERT_GE(mesh.vertices.size(),
            4u * (4u * 4u + 4u * 2u));  // the floor's top and the wall's right side, in tiles of 1 m
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    EXPECT_EQ(mesh.vertices[i].point, wanted.vertices[i].point);
    EXPECT_EQ(mesh.vertices[i].u, wanted.vertices[i].u);
    EXPECT_EQ(mesh.vertices[i].v, wanted.vertices[i].v);
    EXPECT_EQ(mesh.vertices[i].color, wanted.vertices[i].color);
  }
  EXPECT_EQ(mesh.indices, wanted.indices);
}

TEST(BakedMesh, ColorsAreHalfOfColorTimesLightAndAlphaIsOpenness) {
  const BakedMesh mesh = readBakedMesh(meshFile(baked()), "a.mesh");
  int open = 0, corner = 0;
  for (const BakedVertex& vertex : mesh.vertices) {
    if (vertex.point.y() != 0.0f || (vertex.color & 0xffu) != 153u) continue;  // the floor: 1 * 1.2 / 2 * 255
    EXPECT_EQ(vertex.color >> 8 & 0xffu, 76u);
    if (vertex.point.x() == 2.0f) open += vertex.color >> 24 > 230 ? 1 : 0;
    if (vertex.point.x() == -1.0f && vertex.point.z() == -2.0f) corner += vertex.color >> 24 < 160 ? 1 : 0;
  }
  EXPECT_GT(open, 0);
  EXPECT_GT(corner, 0);
}

TEST(BakedMesh, TheCountBeforeTheIndicesIsNotTrusted) {
  const BakedMesh wanted = baked();
  for (const std::uint32_t count : {0u, 1u, static_cast<std::uint32_t>(2 * wanted.vertices.size()), 0xffffffffu}) {
    const BakedMesh mesh = readBakedMesh(archived(meshBytes(wanted, count)), "a.mesh");
    EXPECT_EQ(listed(mesh.problems), "") << count;
    EXPECT_EQ(mesh.indices, wanted.indices) << count;
  }
}

TEST(BakedMesh, AnyArchiveOfZlibIsRead) {
  const std::string bytes = meshBytes(baked(), 0);
  for (const std::string& stored : {archived(bytes, 15), archived(bytes, 9), archived(archived(bytes), 15 + 16)})
    EXPECT_EQ(readBakedMesh(stored, "a.mesh").indices, baked().indices);
}

TEST(BakedMesh, OneWithoutATriangleIsNoFault) {
  const BakedMesh mesh = readBakedMesh(archived(std::string(8, '\0')), "a.mesh");
  EXPECT_EQ(listed(mesh.problems), "");
  EXPECT_TRUE(mesh.vertices.empty() && mesh.indices.empty());
}

TEST(BakedMesh, EveryFaultIsOneLineThatSaysWhatIsExpected) {
  const std::string whole = meshFile(baked()), bytes = meshBytes(baked(), 0);
  const std::string archive = "expected a zlib archive of at most 8388608 bytes\n";
  EXPECT_EQ(faultOf(""), "a.mesh: baked mesh: a damaged or cut archive, " + archive);
  EXPECT_EQ(faultOf("<segment/>"), "a.mesh: baked mesh: a damaged or cut archive, " + archive);
  EXPECT_EQ(faultOf(whole.substr(0, whole.size() / 2)), "a.mesh: baked mesh: a damaged or cut archive, " + archive);
  EXPECT_EQ(faultOf(archived(std::string(9u << 20, '\0'))),
            "a.mesh: baked mesh: longer than 8388608 bytes once unpacked, " + archive);
  EXPECT_EQ(faultOf(archived("")), "a.mesh: baked mesh: it is empty, expected a vertex count\n");
  EXPECT_EQ(faultOf(archived(bytes.substr(0, 4 + 24 * 3))), "a.mesh: baked mesh: vertex count, got '" +
                                                                std::to_string(baked().vertices.size()) +
                                                                "', expected up to the 3 it holds\n");
  EXPECT_EQ(faultOf(archived(bytes.substr(0, 4 + 24 * baked().vertices.size()))),
            "a.mesh: baked mesh: it ends after its vertices, expected a count and indices\n");
  EXPECT_EQ(faultOf(archived(bytes + std::string(4, '\0'))), "a.mesh: baked mesh: bytes of indices, got '" +
                                                                 std::to_string(4 * baked().indices.size() + 4) +
                                                                 "', expected 12 for each triangle\n");
  EXPECT_EQ(faultWith(4 + 24 + 4, std::numeric_limits<float>::quiet_NaN()),
            "a.mesh: baked mesh: vertex 1, got 'nan', expected numbers up to 10000\n");
  EXPECT_THAT(faultWith(4 + 8, -std::numeric_limits<float>::infinity()), HasSubstr("vertex 0, got '-inf'"));
  EXPECT_THAT(faultWith(4 + 16, 20000.0f), HasSubstr("vertex 0, got '20000.000000'"));
  EXPECT_EQ(faultWith(bytes.size() - 4, static_cast<std::uint32_t>(baked().vertices.size())),
            "a.mesh: baked mesh: index " + std::to_string(baked().indices.size() - 1) + ", got '" +
                std::to_string(baked().vertices.size()) + "', expected a vertex, of which there are " +
                std::to_string(baked().vertices.size()) + "\n");
}

TEST(BakedMesh, DamageGivesAMeshThatCanBeDrawnOrOneProblem) {
  BakedMesh small = baked();
  small.vertices.resize(4);
  small.indices.resize(6);
  const auto expectSound = [](const std::string& bytes) {
    const BakedMesh mesh = readBakedMesh(bytes, "a.mesh");
    ASSERT_LE(mesh.problems.size(), 1u);
    ASSERT_TRUE(mesh.problems.empty() || (mesh.vertices.empty() && mesh.indices.empty()));
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
    for (const BakedVertex& vertex : mesh.vertices) ASSERT_TRUE(isFinite(vertex.point));
  };
  forEachDamage(meshFile(small), expectSound);
  forEachDamage(meshBytes(small, 2), [&](const std::string& bytes) { expectSound(archived(bytes)); });
}

TEST(BakedMesh, CheckReadsThemByAllTheirNames) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "brittle_meshes";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder / "segments");
  const std::string good = meshFile(baked());
  std::ofstream(folder / "segments/a.mesh", std::ios::binary) << good;
  std::ofstream(folder / "segments/b.mesh.mp3", std::ios::binary) << good.substr(0, 40);
  std::ofstream(folder / "segments/c.mesh.gz.mp3", std::ios::binary) << archived(good, 15 + 16);
  const CheckReport report = checkPath(folder.string());
  EXPECT_EQ(report.meshes, 3);
  EXPECT_EQ(report.skipped, 0);
  EXPECT_EQ(listed(report.problems), (folder / "segments/b.mesh.mp3").string() +
                                         ": baked mesh: a damaged or cut archive, expected a zlib archive of at most "
                                         "8388608 bytes\n");
}

}  // namespace
}  // namespace brittle::content
