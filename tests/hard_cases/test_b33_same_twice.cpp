// B33: the same scene gives the same hash in every tick: played alone, interleaved tick by tick with other worlds that
// do other things, on a thread of its own beside another, and as it was recorded. Other compilers, flags and
// processors play the same scene and print the same hashes (tools/cross_hash).
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"
#include "tools/state_hash/scene.h"

namespace brittle::physics {
namespace {

using Hashes = std::vector<std::uint64_t>;

int ticks() {
  return hard::counted(240, kSceneTicks);
}

Hashes play() {
  Scene scene;
  Hashes hashes;
  for (int tick = 1; tick <= ticks(); ++tick) {
    scene.step(tick);
    hashes.push_back(scene.hash());
  }
  return hashes;
}

const Hashes& reference() {
  static const Hashes hashes = play();
  return hashes;
}

void expectAsReference(const Hashes& hashes, const char* how) {
  ASSERT_EQ(hashes.size(), reference().size());
  for (std::size_t i = 0; i < hashes.size(); ++i)
    ASSERT_EQ(hashes[i], reference()[i]) << how << ": differs first after tick " << i + 1;
  hard::reportSum("ticks alike", static_cast<double>(hashes.size()));
}

/// What else goes on in the program: a block of glass broken again and again, each time elsewhere.
class Disturbance {
 public:
  Disturbance() { addFloor(world_); }
  void step(int tick) {
    if (tick % 60 == 1) {
      BodyDef block = bodyAt(Vec3(0.1f * static_cast<float>(tick % 7), 0.6f, 0.0f));
      block.breakable.strength = 1.0f;
      block.breakable.material.pattern = fracture::Pattern::Block;
      const BodyHandle body = addBox(world_, block, Vec3(0.2f, 0.2f, 0.2f), shapeDef(2500.0f));
      world_.breakBody(body, Vec3(0.0f, 0.8f, 0.0f), -Vec3::UnitY(), 10.0f, 0.05f);
    }
    world_.step(kTick);
  }

 private:
  World world_;
};

TEST(B33, OtherWorldsInBetweenChangeNothing) {
  Scene scene;
  Disturbance other;
  Scene twin;  // a second one a second late
  Hashes hashes, late;
  for (int tick = 1; tick <= ticks() + 60; ++tick) {
    other.step(tick);
    if (tick <= ticks()) {
      scene.step(tick);
      hashes.push_back(scene.hash());
    }
    if (tick <= 60) continue;
    twin.step(tick - 60);
    late.push_back(twin.hash());
  }
  expectAsReference(hashes, "interleaved");
  expectAsReference(late, "a second late");
}

TEST(B33, AThreadOfItsOwnChangesNothing) {
  std::vector<Hashes> played(2);
  std::vector<std::thread> threads;
  for (Hashes& hashes : played) threads.emplace_back([&hashes] { hashes = play(); });
  for (std::thread& thread : threads) thread.join();
  for (const Hashes& hashes : played) expectAsReference(hashes, "on a thread");
}

// By seconds, as build/tools/state_hash prints them. They change when results change on purpose, and then only.
TEST(B33, TheHashesAreThoseRecorded) {
  constexpr std::uint64_t kRecorded[] = {0x2f3314522504b332, 0xfab3d69a9b18dc45, 0x04d57e346bab3d6c, 0x11d770cda00530b7,
                                         0xdc6d393d9b1ea4ca, 0xbeeeb805ce46025b, 0xa4bc0e4db9396a2e, 0x14776784957b083b,
                                         0xb9bb2d5e36e54dea, 0x6da0ed8a0c1eabf7};
  for (std::size_t second = 0; second < reference().size() / 60; ++second) {
    const std::uint64_t hash = reference()[60 * second + 59];
    ASSERT_EQ(hash, kRecorded[second]) << "second " << second + 1 << ": now 0x" << std::hex << hash;
  }
}

}  // namespace
}  // namespace brittle::physics
