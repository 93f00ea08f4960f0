#include "engine/geometry/mesh_pool.h"

#include <gtest/gtest.h>

#include <cstring>

#include "engine/core/random.h"
#include "engine/geometry/make.h"
#include "engine/geometry/split.h"

namespace brittle::geometry {
namespace {

const Convex kBox = makeBox<float>(Vec3::Ones());

/// The pool's mesh is `convex`, but for the slots in its vertices.
void expectHolds(const MeshPool& pool, MeshSlot slot, const Convex& convex) {
  const ConvexView view = pool.view(slot);
  ASSERT_EQ(view.vertices.size(), convex.vertices.size());
  ASSERT_EQ(view.faces.size(), convex.faces.size());
  ASSERT_EQ(view.edges.size(), convex.edges.size());
  for (std::size_t i = 0; i < view.vertices.size(); ++i) {
    ASSERT_EQ(view.vertices[i].point, convex.vertices[i].point);
    ASSERT_EQ(view.vertices[i].slot, slot);
  }
  ASSERT_EQ(std::memcmp(view.edges.data(), convex.edges.data(), view.edges.size_bytes()), 0);
  for (std::size_t i = 0; i < view.faces.size(); ++i)
    ASSERT_EQ(view.faces[i].plane.offset, convex.faces[i].plane.offset);
}

std::vector<unsigned char> bytesOf(const MeshPool& pool) {
  ByteWriter out;
  pool.save(out);
  return out.bytes();
}

TEST(MeshPool, GivesBackWhatItWasGiven) {
  MeshPool pool;
  const Convex cylinder = makeCylinder(1.0f, 1.0f, 30);
  const MeshSlot a = pool.add(kBox, 5, 6, 7);
  const MeshSlot b = pool.add(cylinder, 8, 9);
  expectHolds(pool, a, kBox);
  expectHolds(pool, b, cylinder);
  EXPECT_EQ(pool.info(a).bodySlot, 5u);
  EXPECT_EQ(pool.info(a).material, 6u);
  EXPECT_EQ(pool.info(a).flags, 7u);
  pool.setBody(a, 11);
  pool.setMaterial(a, 12);
  EXPECT_EQ(pool.info(a).bodySlot, 11u);
  EXPECT_EQ(pool.info(a).material, 12u);
  EXPECT_EQ(pool.aliveCount(), 2u);
  pool.remove(a);
  EXPECT_FALSE(pool.isAlive(a));
  EXPECT_TRUE(pool.isAlive(b));
  EXPECT_EQ(pool.aliveCount(), 1u);
}

TEST(MeshPool, ReusesSlotsAndBlocks) {
  MeshPool pool;
  const MeshSlot first = pool.add(kBox, 0, 0);
  pool.add(kBox, 1, 0);
  const Range block = pool.info(first).vertices;
  const std::size_t size = pool.vertices().size();
  pool.remove(first);
  const MeshSlot again = pool.add(kBox, 2, 0);
  EXPECT_EQ(again, first);
  EXPECT_EQ(pool.info(again).vertices.first, block.first);
  EXPECT_EQ(pool.vertices().size(), size);
}

TEST(MeshPool, ReplaceKeepsSlotBodyAndMaterial) {
  MeshPool pool;
  const MeshSlot slot = pool.add(kBox, 3, 4, 5);
  const Convex cylinder = makeCylinder(1.0f, 1.0f, 50);
  pool.replace(slot, cylinder);
  expectHolds(pool, slot, cylinder);
  EXPECT_EQ(pool.info(slot).bodySlot, 3u);
  EXPECT_EQ(pool.info(slot).material, 4u);
  EXPECT_EQ(pool.info(slot).flags, 5u);
  EXPECT_EQ(pool.aliveCount(), 1u);
}

TEST(MeshPool, DirtyRangesAreMergedAndAscending) {
  MeshPool pool;
  MeshSlot slots[6];
  for (MeshSlot& slot : slots) slot = pool.add(kBox, 0, 0);
  ASSERT_EQ(pool.dirtyRanges().size(), 1u);  // 8 vertices fill their block, so the boxes lie side by side
  EXPECT_EQ(pool.dirtyRanges()[0].first, 0u);
  EXPECT_EQ(pool.dirtyRanges()[0].count, 48u);
  pool.clearDirty();
  EXPECT_TRUE(pool.dirtyRanges().empty());
  pool.setColor(slots[4], 0xff0000ffu);
  pool.setColor(slots[1], 0xff0000ffu);
  pool.setColor(slots[2], 0xff0000ffu);
  pool.setColor(slots[1], 0xff00ff00u);
  ASSERT_EQ(pool.dirtyRanges().size(), 2u);
  EXPECT_EQ(pool.dirtyRanges()[0].first, 8u);
  EXPECT_EQ(pool.dirtyRanges()[0].count, 16u);
  EXPECT_EQ(pool.dirtyRanges()[1].first, 32u);
  EXPECT_EQ(pool.dirtyRanges()[1].count, 8u);
  EXPECT_EQ(pool.view(slots[1]).vertices[3].color, 0xff00ff00u);
  pool.markAllDirty();
  ASSERT_EQ(pool.dirtyRanges().size(), 1u);
  EXPECT_EQ(pool.dirtyRanges()[0].count, 48u);
}

/// Pieces of all sizes come and go, about `alive` at a time.
class Churn {
 public:
  explicit Churn(std::uint64_t seed) : random_(seed) {
    for (const int sides : {3, 4, 5, 7, 9, 12, 17, 24, 33}) shapes_.push_back(makeCylinder(1.0f, 1.0f, sides));
  }
  void run(MeshPool& pool, int steps, std::size_t alive) {
    for (int i = 0; i < steps; ++i) {
      const Convex& shape = shapes_[random_.nextBelow(static_cast<std::uint32_t>(shapes_.size()))];
      const std::uint32_t at = slots_.empty() ? 0 : random_.nextBelow(static_cast<std::uint32_t>(slots_.size()));
      if (slots_.size() < alive) {
        slots_.push_back(pool.add(shape, static_cast<std::uint32_t>(i), 1));
      } else if (random_.nextBelow(2) == 0) {
        pool.replace(slots_[at], shape);
      } else {
        pool.remove(slots_[at]);
        slots_[at] = slots_.back();
        slots_.pop_back();
      }
    }
  }

 private:
  Random random_;
  std::vector<Convex> shapes_;
  std::vector<MeshSlot> slots_;
};

TEST(MeshPool, DoesNotGrowInSteadyUse) {
  MeshPool pool;
  Churn churn(1);
  churn.run(pool, 100000, 300);
  const std::size_t vertices = pool.vertices().size();
  const std::uint32_t slots = pool.slotCount();
  churn.run(pool, 200000, 300);
  EXPECT_LE(pool.vertices().size(), vertices + vertices / 20);  // each size has its own high-water mark
  EXPECT_EQ(pool.slotCount(), slots);
}

TEST(MeshPool, RestoredBehavesBitForBitAsSaved) {
  MeshPool pool;
  Churn churn(2);
  churn.run(pool, 5000, 100);
  const std::vector<unsigned char> bytes = bytesOf(pool);
  MeshPool restored;
  ByteReader in(bytes);
  ASSERT_TRUE(restored.restore(in));
  EXPECT_EQ(in.remaining(), 0u);
  EXPECT_EQ(bytesOf(restored), bytes);
  ASSERT_EQ(restored.dirtyRanges().size(), 1u);
  EXPECT_EQ(restored.dirtyRanges()[0].count, restored.vertices().size());
  Churn twin = churn;
  churn.run(pool, 5000, 100);
  twin.run(restored, 5000, 100);
  EXPECT_EQ(bytesOf(restored), bytesOf(pool));
}

TEST(MeshPool, RefusesDamagedBytes) {
  MeshPool pool;
  const MeshSlot removed = pool.add(kBox, 1, 2);
  pool.add(makeCylinder(1.0f, 1.0f, 5), 3, 4);
  pool.remove(removed);
  const std::vector<unsigned char> bytes = bytesOf(pool);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ByteReader in(std::span(bytes.data(), size));
    MeshPool restored;
    ASSERT_FALSE(restored.restore(in)) << size;
    ASSERT_FALSE(in.ok());
    ASSERT_EQ(restored.slotCount(), 0u);
  }
  // A changed byte is refused or gives a pool that is safe to walk.
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const unsigned char mask : {0x01, 0x80, 0xff}) {
      std::vector<unsigned char> changed = bytes;
      changed[at] = static_cast<unsigned char>(changed[at] ^ mask);
      ByteReader in(changed);
      MeshPool restored;
      if (!restored.restore(in)) continue;
      for (MeshSlot slot = 0; slot < restored.slotCount(); ++slot) {
        if (restored.isAlive(slot)) {
          ASSERT_STREQ(findTopologyError(restored.view(slot)), nullptr);
        }
      }
      restored.add(kBox, 0, 0);
    }
  }
}

// Two that share their edges are harmless; half a million would take hours to look at.
TEST(MeshPool, RefusesMeshesThatShareTheirEdges) {
  MeshPool pool;
  pool.add(kBox, 1, 2);
  const std::vector<unsigned char> bytes = bytesOf(pool);
  constexpr std::size_t entry = 33;
  ByteWriter out;
  out.write(std::uint32_t{2});
  for (int i = 0; i < 2; ++i) out.writeBytes(&bytes[4], entry);
  out.writeBytes(&bytes[4 + entry], bytes.size() - 4 - entry - 4);
  out.write(std::uint32_t{2});
  ByteReader in(out.bytes());
  MeshPool restored;
  EXPECT_FALSE(restored.restore(in));
}

TEST(MeshPool, ReservedRoomIsEnough) {
  MeshPool pool;
  pool.reserve(100, 1600, 800, 3200);
  const Vertex* const before = pool.vertices().data();
  for (int i = 0; i < 100; ++i) pool.add(kBox, 0, 0);
  EXPECT_EQ(pool.vertices().data(), before);
}

}  // namespace
}  // namespace brittle::geometry
