// A snapshot from a file may hold anything: it is refused, or the world it gives can be stepped.
#include <gtest/gtest.h>

#include <cstring>

#include "engine/core/random.h"
#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

/// Shortly after a pane was broken: pieces, contacts, debris, a tree of many leaves.
std::vector<unsigned char> crowdedSnapshot() {
  WorldDef def;
  def.accuracy.patternDensity = 0.1f;
  World world(def);
  addFloor(world);
  addPane(world, Vec3(0.0f, 1.0f, 0.0f), Vec3(1.0f, 1.0f, 0.02f), 1.9f);
  addBox(world, bodyAt(Vec3(0.3f, 0.2f, -1.0f)), Vec3(0.2f, 0.2f, 0.2f));
  addBall(world, Vec3(0.1f, 1.1f, 5.0f), Vec3(0.0f, 1.0f, -20.0f), 0.1f, 1.0f);
  for (int i = 0; i < 30; ++i) world.step(kTick);
  EXPECT_GT(world.counters().totalBreaks, 0u);
  ByteWriter out;
  world.save(out);
  return out.bytes();
}

/// The places of small whole numbers: counts, slots, handles and links.
std::vector<std::size_t> placesOfSmallNumbers(const std::vector<unsigned char>& bytes) {
  std::vector<std::size_t> places;
  for (std::size_t i = 4; i + 4 <= bytes.size(); ++i) {
    std::uint32_t value = 0;
    std::memcpy(&value, &bytes[i], 4);
    if (value > 0 && value < 1000) places.push_back(i);
  }
  return places;
}

bool restoresAndSteps(const std::vector<unsigned char>& bytes) {
  World world;
  ByteReader in(bytes);
  if (!world.restore(in)) return false;
  for (int i = 0; i < 2; ++i) world.step(kTick);
  return true;
}

TEST(StateError, ASoundSnapshotIsRestored) {
  EXPECT_TRUE(restoresAndSteps(crowdedSnapshot()));
}

/// Where a number of 32 bits comes after some others, in the bytes of a snapshot; 0 if it does not.
std::size_t placeAfter(const std::vector<unsigned char>& bytes, const std::vector<float>& before) {
  for (std::size_t i = 4; i + 4 * before.size() + 4 <= bytes.size(); ++i)
    if (std::memcmp(&bytes[i], before.data(), 4 * before.size()) == 0) return i + 4 * before.size();
  return 0;
}

TEST(StateError, AnAnchorOfMorePointsThanItHoldsIsRefused) {
  World world;
  const BodyHandle floor = addFloor(world);
  const BodyHandle pane = addPane(world, Vec3(0.0f, 1.0f, 0.0f), Vec3(1.0f, 1.0f, 0.02f), 1.9f);
  (void)floor;
  ASSERT_GT(world.anchor(pane), 0u);
  ByteWriter out;
  world.save(out);
  std::vector<unsigned char> bytes = out.bytes();
  ASSERT_TRUE(restoresAndSteps(bytes));
  const physics::Shape& shape = world.shape(world.body(pane).firstShape);
  ASSERT_GT(shape.anchorCount, 0u);
  std::vector<float> corner(3);
  for (int i = 0; i < 3; ++i) corner[static_cast<std::size_t>(i)] = shape.anchors[0].points[0][i];
  const std::size_t count = placeAfter(bytes, corner) - 16;
  const std::uint32_t had = shape.anchors[0].pointCount, nine = 9;
  std::memcpy(&bytes[count], &nine, 4);  // of which eight are read
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(count) + 4, 12 * (8 - had), 0);
  EXPECT_FALSE(restoresAndSteps(bytes));
}

TEST(StateError, AForgedSnapshotIsRefusedOrCanBeStepped) {
  const std::vector<unsigned char> good = crowdedSnapshot();
  const std::vector<std::size_t> places = placesOfSmallNumbers(good);
  constexpr std::uint32_t numbers[] = {0, 1, 7, 300, 100'000, 0x7fffffff, 0xfffffffe, 0xffffffff};
  Random random(11);
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<unsigned char> bytes = good;
    const std::size_t place = places[random.nextBelow(static_cast<std::uint32_t>(places.size()))];
    std::memcpy(&bytes[place], &numbers[random.nextBelow(8)], 4);
    SCOPED_TRACE("byte " + std::to_string(place));
    refused += restoresAndSteps(bytes) ? 0 : 1;
  }
  EXPECT_GT(refused, 60) << "it was 79 to 100 of the 200 so far: where the numbers fall is chance";
}

}  // namespace
}  // namespace brittle::physics
