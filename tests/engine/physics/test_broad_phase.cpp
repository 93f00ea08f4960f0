#include "engine/physics/broad_phase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/core/random.h"

namespace brittle::physics {
namespace {

Aabb randomBox(Random& random, float size) {
  Vec3 center, half;
  for (int i = 0; i < 3; ++i) center[i] = random.nextFloat(-20.0f, 20.0f);
  for (int i = 0; i < 3; ++i) half[i] = random.nextFloat(0.01f, size);
  return {center - half, center + half};
}

std::vector<std::uint32_t> found(const DynamicTree& tree, const Aabb& box) {
  std::vector<std::uint32_t> result;
  tree.query(box, [&](std::uint32_t user) {
    result.push_back(user);
    return true;
  });
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::uint32_t> expected(const std::map<std::uint32_t, Aabb>& boxes, const Aabb& box) {
  std::vector<std::uint32_t> result;
  for (const auto& [user, other] : boxes)
    if (other.overlaps(box)) result.push_back(user);
  return result;
}

TEST(DynamicTree, FindsWhatBruteForceFindsThroughRandomChurn) {
  Random random(7);
  DynamicTree tree;
  std::map<std::uint32_t, Aabb> boxes;
  std::map<std::uint32_t, std::uint32_t> proxies;
  std::uint32_t nextUser = 0;
  for (int round = 0; round < 6000; ++round) {
    const std::uint32_t what = random.nextBelow(4);
    if (what < 2 || boxes.empty()) {
      boxes[nextUser] = randomBox(random, 2.0f);
      proxies[nextUser] = tree.insert(boxes[nextUser], nextUser);
      ++nextUser;
    } else {
      auto chosen = boxes.begin();
      std::advance(chosen, random.nextBelow(static_cast<std::uint32_t>(boxes.size())));
      const std::uint32_t user = chosen->first;
      if (what == 2) {
        chosen->second = randomBox(random, 2.0f);
        tree.move(proxies[user], chosen->second);
      } else {
        tree.remove(proxies[user]);
        proxies.erase(user);
        boxes.erase(chosen);
      }
    }
    if (round % 50 == 0) {
      ASSERT_EQ(tree.findError(), nullptr) << "round " << round;
      const Aabb probe = randomBox(random, 5.0f);
      ASSERT_EQ(found(tree, probe), expected(boxes, probe));
    }
  }
  ASSERT_EQ(tree.leafCount(), boxes.size());
  for (const auto& [user, proxy] : proxies) tree.remove(proxy);
  EXPECT_EQ(tree.leafCount(), 0u);
  EXPECT_EQ(tree.findError(), nullptr);
}

TEST(DynamicTree, StaysLowWhateverTheOrder) {
  for (int kind = 0; kind < 4; ++kind) {
    Random random(11);
    DynamicTree tree;
    const int count = 3000;
    for (int i = 0; i < count; ++i) {
      const float x = static_cast<float>(i);
      Aabb box{Vec3::Zero(), Vec3::Ones()};                                    // all the same
      if (kind == 1) box = {Vec3(x, 0.0f, 0.0f), Vec3(x + 0.5f, 1.0f, 1.0f)};  // a sorted row
      if (kind == 2) box = {Vec3::Zero(), Vec3::Constant(1.0f + x)};           // each holds all before
      if (kind == 3) box = randomBox(random, 1.0f);
      tree.insert(box, static_cast<std::uint32_t>(i));
    }
    EXPECT_EQ(tree.findError(), nullptr);
    EXPECT_LT(tree.height(), 2.0 * std::log2(count)) << "kind " << kind;
  }
}

TEST(DynamicTree, StaysBalancedWithLeavesFarFromAllOthers) {
  Random random(17);
  DynamicTree tree;
  for (std::uint32_t i = 0; i < 300; ++i) {
    Aabb box = randomBox(random, 1.0f);
    const Vec3 away = Vec3::Constant(i % 60 == 59 ? 1000.0f * static_cast<float>(i) : 0.0f);
    tree.insert({box.low + away, box.high + away}, i);
    ASSERT_EQ(tree.findError(), nullptr) << i << " leaves";
  }
}

TEST(DynamicTree, StopsAQueryWhenTheVisitorHasEnough) {
  Random random(3);
  DynamicTree tree;
  for (std::uint32_t i = 0; i < 400; ++i) tree.insert(randomBox(random, 0.2f), i);
  int seen = 0;
  tree.query({Vec3::Constant(-30.0f), Vec3::Constant(30.0f)}, [&](std::uint32_t) { return ++seen < 10; });
  EXPECT_EQ(seen, 10);
}

TEST(DynamicTree, RaysMissNothing) {
  Random random(5);
  DynamicTree tree;
  std::map<std::uint32_t, Aabb> boxes;
  for (std::uint32_t i = 0; i < 500; ++i) {
    boxes[i] = randomBox(random, 1.0f);
    tree.insert(boxes[i], i);
  }
  for (int round = 0; round < 300; ++round) {
    const Vec3 from = randomBox(random, 1.0f).center();
    Vec3 to = randomBox(random, 1.0f).center();
    if (round % 3 == 0) to = Vec3(from.x(), from.y(), to.z());  // along an axis
    std::vector<bool> touched(boxes.size(), false);
    tree.castRay(from, to, [&](std::uint32_t user) {
      touched[user] = true;
      return 1.0f;
    });
    for (const auto& [user, box] : boxes)
      for (int step = 0; step <= 200; ++step) {
        const bool inside = box.contains(Vec3(from + (to - from) * (static_cast<float>(step) / 200.0f)));
        EXPECT_TRUE(touched[user] || !inside);
      }
  }
}

TEST(DynamicTree, RaysStopWhereTheVisitorSays) {
  DynamicTree tree;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const float x = static_cast<float>(i);
    tree.insert({Vec3(x, 0.0f, 0.0f), Vec3(x + 0.1f, 1.0f, 1.0f)}, i);
  }
  std::uint32_t farthest = 0, visits = 0;
  tree.castRay(Vec3(-1.0f, 0.5f, 0.5f), Vec3(99.0f, 0.5f, 0.5f), [&](std::uint32_t user) {
    farthest = std::max(farthest, user);
    ++visits;
    return 0.105f;
  });
  EXPECT_GE(visits, 10u);
  EXPECT_LT(visits, 30u);
  visits = 0;
  tree.castRay(Vec3(-1.0f, 0.5f, 0.5f), Vec3(99.0f, 0.5f, 0.5f), [&](std::uint32_t) {
    ++visits;
    return 0.0f;
  });
  EXPECT_EQ(visits, 1u);
}

TEST(DynamicTree, AWideRayTouchesItsNeighbours) {
  DynamicTree tree;
  tree.insert({Vec3(5.0f, 1.0f, 0.0f), Vec3(6.0f, 2.0f, 1.0f)}, 1);
  int thin = 0, wide = 0;
  tree.castRay(Vec3::Zero(), Vec3(10.0f, 0.0f, 0.0f), [&](std::uint32_t) { return ++thin, 1.0f; });
  tree.castRay(
      Vec3::Zero(), Vec3(10.0f, 0.0f, 0.0f), [&](std::uint32_t) { return ++wide, 1.0f; }, 1.1f);
  EXPECT_EQ(thin, 0);
  EXPECT_EQ(wide, 1);
}

TEST(DynamicTree, ShiftsAllBoxes) {
  Random random(9);
  DynamicTree tree;
  const Aabb box = randomBox(random, 1.0f);
  const std::uint32_t proxy = tree.insert(box, 4);
  for (std::uint32_t i = 0; i < 50; ++i) tree.insert(randomBox(random, 1.0f), i + 10);
  tree.shift(Vec3(256.0f, 0.0f, -128.0f));
  EXPECT_EQ(tree.findError(), nullptr);
  EXPECT_TRUE(tree.box(proxy).low.isApprox(box.low + Vec3(256.0f, 0.0f, -128.0f)));
  EXPECT_EQ(tree.userData(proxy), 4u);
}

TEST(DynamicTree, BehavesAfterRestoringAsTheSavedOne) {
  Random random(13);
  DynamicTree saved;
  std::vector<std::uint32_t> proxies;
  for (std::uint32_t i = 0; i < 300; ++i) proxies.push_back(saved.insert(randomBox(random, 1.0f), i));
  for (std::uint32_t i = 0; i < 300; i += 3) saved.remove(proxies[i]);
  ByteWriter writer;
  SaveArchive save(writer);
  save(saved);
  DynamicTree restored;
  ByteReader reader(writer.bytes());
  RestoreArchive restore(reader);
  restore(restored);
  ASSERT_TRUE(restore.ok());
  for (std::uint32_t i = 0; i < 100; ++i) {
    const Aabb box = randomBox(random, 1.0f);
    EXPECT_EQ(saved.insert(box, i), restored.insert(box, i));
  }
  HashArchive a, b;
  a(saved);
  b(restored);
  EXPECT_EQ(a.value(), b.value());
  EXPECT_EQ(restored.findError(), nullptr);
}

TEST(DynamicTree, NoticesDamage) {
  Random random(17);
  DynamicTree tree;
  for (std::uint32_t i = 0; i < 40; ++i) tree.insert(randomBox(random, 1.0f), i);
  ByteWriter writer;
  SaveArchive save(writer);
  save(tree);
  int noticed = 0;
  std::vector<std::uint8_t> bytes(writer.bytes().begin(), writer.bytes().end());
  for (std::size_t at = 4; at < bytes.size(); ++at) {  // every byte but the size
    std::vector<std::uint8_t> damaged = bytes;
    damaged[at] ^= 0x81;
    DynamicTree broken;
    ByteReader reader(damaged);
    RestoreArchive restore(reader);
    restore(broken);
    noticed += broken.findError() != nullptr ? 1 : 0;
  }
  EXPECT_GT(noticed, static_cast<int>(bytes.size() / 3));  // boxes may change and stay legal, links may not
}

}  // namespace
}  // namespace brittle::physics
