// B38: the origin shifts before, in and after the tick of a break. The world goes on bit for bit as one that was not
// shifted: pieces, velocities, contacts with their impulses, joints, the tree; the shift itself loses no contact. A
// float holds places on a grid that is finer nearer the origin, so bits can be equal only where the grid is: here all
// places are between 64 and 128 m before and after, 2^-17 m apart, and the shift is a multiple of 2^-8 m, that is of
// twice the grid (so that halves are rounded to the same side). Everything then is relative to shapes, and the same
// bits.
#include <gtest/gtest.h>

#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

const Vec3 kPlace(110.0f, 100.0f, 90.0f);      // of the scene [m]
const Vec3 kShift(16.5f, 8.25f, 3.00390625f);  // [m]

/// A pane that is shot, glass blocks on a floor behind it, one on a rope.
struct Room {
  World world;

  explicit Room(int phase) {
    Accuracy accuracy;
    accuracy.minVolumeScale = 0.0f;  // every piece is a body
    world.setAccuracy(accuracy);
    addBox(world, bodyAt(kPlace + Vec3(0.0f, -1.0f, 0.0f), BodyType::Static), Vec3(6.0f, 0.5f, 6.0f));
    addPane(world, kPlace, Vec3(0.45f, 0.45f, 0.01f), 1.9f);
    for (int i = 0; i < 4; ++i) {
      BodyDef block = bodyAt(kPlace + Vec3(0.0f, -0.4f + 0.2f * static_cast<float>(i), -0.4f));
      block.breakable.strength = 30.0f;  // more than the blocks weigh, less than the ball brings
      block.breakable.material.pattern = fracture::Pattern::Block;
      addBox(world, block, Vec3(0.1f, 0.1f, 0.1f), shapeDef(2500.0f));
    }
    hang();
    const float gap = 0.7f + 20.0f * kTick * static_cast<float>(phase) / 64.0f;
    addBall(world, kPlace + Vec3(0.02f, -0.1f, 0.06f + gap), Vec3(0.0f, 0.0f, -20.0f), 0.05f, 1.0f);
  }
  void hang() {
    const BodyHandle cube = addBox(world, bodyAt(kPlace + Vec3(0.8f, 0.0f, 0.0f)), Vec3(0.1f, 0.1f, 0.1f));
    JointDef rope;
    rope.type = JointType::Rope;
    rope.a = world.body(cube).firstShape;
    rope.anchorA = kPlace + Vec3(0.8f, 0.1f, 0.0f);
    rope.anchorB = kPlace + Vec3(0.9f, 0.8f, 0.0f);
    world.createJoint(rope);
  }
};

/// The hash that this world would have after a shift.
std::uint64_t hashShifted(const World& world, const Vec3& offset) {
  ByteWriter out;
  world.save(out);
  World copy;
  ByteReader in(out.bytes());
  EXPECT_TRUE(copy.restore(in));
  copy.shiftOrigin(offset);
  return copy.stateHash();
}

int tickOfTheBreak(int phase) {
  Room room(phase);
  int tick = 0;
  do {
    room.world.step(kTick);
    ++tick;
  } while (room.world.counters().breaks == 0 && tick < 60);
  return tick;
}

void expectOneGrid(const World& world) {
  world.forEachBody([](BodyHandle, const Body& body) {
    ASSERT_GE(body.center.minCoeff(), 64.0f);
    ASSERT_LT(body.center.maxCoeff(), 128.0f);
  });
}

void playBoth(int phase, int shiftBefore, int ticks) {
  Room still(phase), shifted(phase);
  std::uint32_t breaks = 0;
  for (int tick = 1; tick <= ticks; ++tick) {
    if (tick == shiftBefore) {
      const std::size_t contacts = shifted.world.state().contacts.size();
      shifted.world.shiftOrigin(kShift);
      EXPECT_EQ(shifted.world.state().contacts.size(), contacts);
    }
    still.world.step(kTick);
    shifted.world.step(kTick);
    breaks += shifted.world.counters().breaks;
    expectOneGrid(still.world);
    expectOneGrid(shifted.world);
    ASSERT_EQ(shifted.world.counters().contacts, still.world.counters().contacts) << "tick " << tick;
    ASSERT_EQ(shifted.world.counters().breaks, still.world.counters().breaks) << "tick " << tick;
    const Vec3 offset = tick < shiftBefore ? Vec3(Vec3::Zero()) : kShift;
    ASSERT_EQ(shifted.world.stateHash(), hashShifted(still.world, offset)) << "tick " << tick;
  }
  EXPECT_GE(breaks, 1u);
  hard::reportSum("ticks alike", ticks);
  hard::reportSum("breaks", breaks);
}

TEST(B38, AShiftInTheTickOfABreakChangesNothing) {
  const int phases = hard::counted(4, 64);
  for (int i = 0; i < phases; ++i) {
    const int phase = i * 64 / phases;
    const int broke = tickOfTheBreak(phase);
    for (const int before : {broke - 1, broke, broke + 1}) {
      SCOPED_TRACE("phase " + std::to_string(phase) + ", breaks in tick " + std::to_string(broke) +
                   ", shifted before tick " + std::to_string(before));
      playBoth(phase, before, broke + 15);
    }
  }
}

}  // namespace
}  // namespace brittle::physics
