// B29: mass ratios of 1 to 1e4: a glass box of 1 kg under one of 1e4 kg, and a stack of ten that alternate. They stand
// for 10 s with overlaps below 5 % of a box, the impulses reported add up to weight x dt within 5 %, and nothing breaks
// at a limit of 2x the static load.
#include <gtest/gtest.h>

#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr float kHalf = 0.5f;      // [m]
constexpr float kLight = 1.0f;     // [kg]
constexpr float kHeavy = 1e4f;     // [kg]
constexpr float kGravity = 9.81f;  // [m/s2]

struct Stack {
  World world;
  std::vector<BodyHandle> boxes;
  std::vector<float> borne;  // weight above and of each box [N]
  Stack(int count, const WorldDef& def) : world(def) {
    addFloor(world);
    for (int i = 0; i < count; ++i) {
      const float mass = i % 2 == 0 ? kLight : kHeavy;
      BodyDef body = bodyAt(Vec3(0.0f, kHalf + 2.0f * kHalf * static_cast<float>(i), 0.0f));
      float load = 0.0f;
      for (int k = i; k < count; ++k) load += (k % 2 == 0 ? kLight : kHeavy) * kGravity;
      if (i % 2 == 0) body.breakable.strength = 2.0f * load * kTick;
      boxes.push_back(addBox(world, body, Vec3(kHalf, kHalf, kHalf), shapeDef(mass)));
      borne.push_back(load);
    }
  }
  /// What the contacts between box i and what is below it carried in the last tick [N s].
  float impulseUnder(std::size_t i) const {
    float sum = 0.0f;
    const State& state = world.state();
    state.contacts.forEach([&](ContactHandle, const Contact& contact) {
      const Body& a = state.bodyOf(state.shapes[contact.a]);
      const Body& b = state.bodyOf(state.shapes[contact.b]);
      const Body& box = world.body(boxes[i]);
      const bool isBox = &a == &box || &b == &box;
      const Body& other = &a == &box ? b : a;
      if (!isBox || other.center.y() > box.center.y()) return;
      for (int p = 0; p < contact.manifold.count; ++p) sum += contact.manifold.points[p].normalImpulse;
    });
    return sum;
  }
};

class B29 : public testing::TestWithParam<std::tuple<int, bool>> {};

TEST_P(B29, StandsAndReportsItsWeight) {
  const auto [count, deactivation] = GetParam();
  WorldDef def;
  def.accuracy.deactivation = deactivation;
  Stack stack(count, def);
  std::uint32_t breaks = 0;
  for (int tick = 0; tick < 600; ++tick) {
    stack.world.step(kTick);
    breaks += stack.world.counters().breaks;
  }
  EXPECT_EQ(breaks, 0u);
  // At rest for good they keep their place; solved anew for 600 ticks they may creep (measured 0.24 m) but stay on each
  // other.
  const float creep = deactivation ? 0.05f : kHalf;
  float below = 0.0f;  // top of the box below
  for (std::size_t i = 0; i < stack.boxes.size(); ++i) {
    const Body& box = stack.world.body(stack.boxes[i]);
    EXPECT_GT(box.center.y() - kHalf, below - 0.05f * 2.0f * kHalf) << "box " << i;
    EXPECT_LT(Vec2(box.center.x(), box.center.z()).norm(), creep) << "box " << i;
    EXPECT_NEAR(stack.impulseUnder(i), stack.borne[i] * kTick, 0.05f * stack.borne[i] * kTick) << "box " << i;
    hard::reportWorst("overlap", 100.0 * double((below - box.center.y() + kHalf) / (2.0f * kHalf)), "%");
    hard::reportWorst("impulses off by",
                      100.0 * double(std::abs(stack.impulseUnder(i) / (stack.borne[i] * kTick) - 1.0f)), "%");
    below = box.center.y() + kHalf;
  }
}

INSTANTIATE_TEST_SUITE_P(Stacks, B29, testing::Combine(testing::Values(2, 10), testing::Bool()));

}  // namespace
}  // namespace brittle::physics
