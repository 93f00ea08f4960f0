#include "engine/core/slot_pool.h"

#include <gtest/gtest.h>

#include "engine/core/archive.h"
#include "engine/core/random.h"

namespace brittle {
namespace {

struct ThingTag;
using ThingHandle = Handle<ThingTag>;

struct Thing {
  int value = 0;
  template <class A>
  void serialize(A& a) {
    a(value);
  }
};
using Pool = SlotPool<Thing, ThingHandle>;

TEST(SlotPool, AHandleGoesStaleWhenItsValueIsErased) {
  Pool pool;
  const ThingHandle first = pool.insert({1});
  EXPECT_TRUE(pool.contains(first));
  pool.erase(first);
  EXPECT_FALSE(pool.contains(first));
  const ThingHandle second = pool.insert({2});
  EXPECT_EQ(second.index, first.index);
  EXPECT_FALSE(pool.contains(first));
  EXPECT_EQ(pool.find(first), nullptr);
  EXPECT_EQ(pool[second].value, 2);
}

TEST(SlotPool, TheNullHandleIsNeverContained) {
  Pool pool;
  pool.insert({1});
  EXPECT_FALSE(pool.contains(ThingHandle{}));
  EXPECT_FALSE(static_cast<bool>(ThingHandle{}));
}

TEST(SlotPool, SlotsAreReusedLastFreedFirst) {
  Pool pool;
  const ThingHandle a = pool.insert({1}), b = pool.insert({2});
  pool.erase(a);
  pool.erase(b);
  EXPECT_EQ(pool.insert({3}).index, b.index);
  EXPECT_EQ(pool.insert({4}).index, a.index);
}

TEST(SlotPool, IteratesInSlotOrder) {
  Pool pool;
  std::vector<ThingHandle> handles;
  for (int i = 0; i < 10; ++i) handles.push_back(pool.insert({i}));
  for (int i = 1; i < 10; i += 3) pool.erase(handles[static_cast<std::size_t>(i)]);
  std::vector<int> seen;
  pool.forEach([&](ThingHandle, const Thing& thing) { seen.push_back(thing.value); });
  EXPECT_EQ(seen, (std::vector<int>{0, 2, 3, 5, 6, 8, 9}));
  EXPECT_EQ(pool.size(), seen.size());
}

// After any history, a restored pool hands out the same handles as the one that was saved.
TEST(SlotPool, ARestoredPoolContinuesAsTheSavedOne) {
  Pool pool;
  std::vector<ThingHandle> alive;
  Random random(7);
  for (int i = 0; i < 1000; ++i) {
    const std::uint32_t choice = random.nextBelow(3);
    if (choice == 0 && !alive.empty()) {
      const std::uint32_t which = random.nextBelow(static_cast<std::uint32_t>(alive.size()));
      pool.erase(alive[which]);
      alive.erase(alive.begin() + which);
    } else {
      alive.push_back(pool.insert({i}));
    }
  }
  ByteWriter out;
  SaveArchive save(out);
  pool.serialize(save);
  Pool copy;
  ByteReader in(out.bytes());
  RestoreArchive restore(in);
  copy.serialize(restore);
  ASSERT_TRUE(in.ok());
  EXPECT_EQ(in.remaining(), 0u);
  EXPECT_EQ(copy.size(), pool.size());
  for (const ThingHandle handle : alive) ASSERT_EQ(copy[handle].value, pool[handle].value);
  for (int i = 0; i < 500; ++i) ASSERT_EQ(copy.insert({i}), pool.insert({i}));
}

// An empty slot is five bytes in a snapshot and a whole value in memory.
TEST(SlotPool, ASnapshotOfMoreEmptySlotsThanAnyPoolHasIsRefused) {
  for (const std::size_t slots : {kMostRestoredSlots, kMostRestoredSlots + 1}) {
    ByteWriter out;
    out.write(std::uint32_t{0});
    out.write(static_cast<std::uint32_t>(slots));
    for (std::size_t i = 0; i < slots; ++i) {
      out.write(std::uint32_t{1});
      out.write(false);
    }
    ByteReader in(out.bytes());
    RestoreArchive restore(in);
    Pool pool;
    pool.serialize(restore);
    EXPECT_EQ(in.ok(), slots == kMostRestoredSlots);
    EXPECT_EQ(pool.capacity(), slots == kMostRestoredSlots ? slots : 0u);
  }
}

}  // namespace
}  // namespace brittle
