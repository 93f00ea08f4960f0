#include "engine/render/mesh_store.h"

#include <gtest/gtest.h>

#include "engine/geometry/make.h"
#include "engine/render/gl_null.h"

namespace brittle::render {
namespace {

constexpr std::uint64_t kBytes = sizeof(geometry::Vertex);

geometry::Convex box(float half = 0.5f) {
  return geometry::makeBox<float>(Vec3(half, half, half));
}

class MeshStoreOnNull : public ::testing::Test {
 protected:
  NullGl null_;
  geometry::MeshPool pool_;
  MeshStore store_{null_.table()};
};

TEST_F(MeshStoreOnNull, UploadsEverythingOnceAndThenNothing) {
  for (int i = 0; i < 10; ++i) pool_.add(box(), 0, 0);
  EXPECT_EQ(store_.syncVertices(pool_), pool_.vertices().size());
  EXPECT_EQ(store_.syncVertices(pool_), 0u);
  EXPECT_TRUE(pool_.dirtyRanges().empty());
  EXPECT_TRUE(null_.complaints().empty());
}

TEST_F(MeshStoreOnNull, UploadsOnlyWhatChanged) {
  std::vector<geometry::MeshSlot> slots;
  for (int i = 0; i < 60; ++i) slots.push_back(pool_.add(box(), 0, 0));
  store_.syncVertices(pool_);
  null_.clearRecord();
  pool_.replace(slots[30], box(0.25f));
  const std::uint32_t uploaded = store_.syncVertices(pool_);
  EXPECT_GE(uploaded, 8u);
  EXPECT_LE(uploaded, 16u);  // a box has 8 vertices; blocks come in size classes
  EXPECT_EQ(null_.calls("BufferSubData"), 1u);
  EXPECT_EQ(null_.bytesTo(GL_ARRAY_BUFFER), uploaded * kBytes);
}

TEST_F(MeshStoreOnNull, JoinsNeighbouringRangesAndKeepsFarOnesApart) {
  std::vector<geometry::MeshSlot> slots;
  for (int i = 0; i < 60; ++i) slots.push_back(pool_.add(box(), 0, 0));
  store_.syncVertices(pool_);
  null_.clearRecord();
  pool_.setColor(slots[2], 1);
  pool_.setColor(slots[4], 1);   // close to the first
  pool_.setColor(slots[50], 1);  // far away
  store_.syncVertices(pool_);
  EXPECT_EQ(null_.calls("BufferSubData"), 2u);
}

TEST_F(MeshStoreOnNull, GrowsWithThePool) {
  pool_.add(box(), 0, 0);
  store_.syncVertices(pool_);
  for (int i = 0; i < 1000; ++i) pool_.add(box(), 0, 0);
  EXPECT_EQ(store_.syncVertices(pool_), pool_.vertices().size());
  pool_.markAllDirty();
  EXPECT_EQ(store_.syncVertices(pool_), pool_.vertices().size());
  EXPECT_TRUE(null_.complaints().empty());
}

TEST_F(MeshStoreOnNull, SendsOnlyTableRowsThatDiffer) {
  MeshGroup group;
  group.pool = &pool_;
  group.bodies.resize(600);  // two texels each: two rows of 1024
  for (std::uint32_t i = 0; i < 3; ++i) group.meshes.push_back({pool_.add(box(), i, 0), i, kGlass, kWhite});
  store_.syncTables(group);
  EXPECT_EQ(null_.calls("TexSubImage2D"), 3u);  // two rows of bodies, one of shapes
  null_.clearRecord();
  store_.syncTables(group);
  EXPECT_EQ(null_.calls("TexSubImage2D"), 0u);
  group.bodies[599].position.x() = 1.0f;
  store_.syncTables(group);
  EXPECT_EQ(null_.calls("TexSubImage2D"), 1u);
  group.meshes[1].tint = 7;
  store_.syncTables(group);
  EXPECT_EQ(null_.calls("TexSubImage2D"), 2u);
  EXPECT_TRUE(null_.complaints().empty());
}

}  // namespace
}  // namespace brittle::render
