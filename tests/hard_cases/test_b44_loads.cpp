// B44: loads at rest on glass, of 0.1 to 3 times what it holds. J is what it takes within 1/60 s: a weight W breaks it
// exactly above W / 60 s = J, within 2 %, whether a tick lasts 1/30 or 1/240 s, on one point or many, on a pane that is
// held and on one that lies. A load that hangs from glass by joints never breaks it, whatever it weighs.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/engine/physics/scene.h"
#include "tests/hard_cases/case.h"

namespace brittle::physics {
namespace {

constexpr float kStrength = 1.9f;  // [N s]
constexpr float kTicks[] = {1.0f / 30.0f, 1.0f / 60.0f, 1.0f / 120.0f, 1.0f / 240.0f};

enum class Load { Box, Ball, Feet };  // four points, one, and a body of three shapes
const char* nameOf(Load load) {
  const char* names[] = {"a box", "a ball", "a body on three feet"};
  return names[static_cast<int>(load)];
}

/// Its lowest point at y = 0.
BodyHandle addLoad(World& world, Load load, float mass) {
  if (load == Load::Ball) return addBall(world, Vec3(0.02f, 0.1f, -0.03f), Vec3::Zero(), 0.1f, mass);
  BodyDef def = bodyAt(Vec3(0.02f, 0.1f, -0.03f));
  if (load == Load::Box) return addBox(world, def, Vec3(0.1f, 0.1f, 0.1f), shapeDef(mass / 0.008f));
  const BodyHandle body = world.createBody(def);
  const float density = mass / (3.0f * 4.0f / 3.0f * kPi * 1e-3f);
  for (const Vec3& foot : {Vec3(0.2f, 0.0f, 0.0f), Vec3(-0.15f, 0.0f, 0.2f), Vec3(-0.15f, 0.0f, -0.2f)})
    world.addSphere(body, shapeDef(density), 0.1f, foot);
  return body;
}

float massOf(float ratio) {
  return ratio * kStrength * 60.0f / 9.81f;
}

/// Glass whose top is at y = 0: held at its rim, or lying on a floor.
BodyHandle addGlass(World& world, bool held) {
  BodyDef pane = bodyAt(Vec3(0.0f, -0.01f, 0.0f), held ? BodyType::Static : BodyType::Dynamic);
  pane.breakable.strength = 1e6f;
  ShapeDef glass = shapeDef(0.1f);  // what a floor bears is the load, and not the pane as well
  glass.anchored = held;
  const BodyHandle body = addBox(world, pane, Vec3(0.5f, 0.01f, 0.5f), glass);
  if (!held) addBox(world, bodyAt(Vec3(0.0f, -0.52f, 0.0f), BodyType::Static), Vec3(5.0f, 0.5f, 5.0f));
  return body;
}

/// Whether a load that has come to rest breaks the glass within two seconds from when it has its strength.
bool breaks(float ratio, Load load, bool held, float dt) {
  World world;
  const BodyHandle glass = addGlass(world, held);
  addLoad(world, load, massOf(ratio));
  const auto ticksIn = [&](float seconds) { return static_cast<int>(seconds / dt + 0.5f); };
  for (int i = 0; i < ticksIn(0.4f); ++i) world.step(dt);
  Breakable breakable = world.body(glass).breaking;
  breakable.strength = kStrength;
  world.setBreakable(glass, breakable);
  for (int i = 0; i < ticksIn(2.0f); ++i) {
    world.step(dt);
    if (world.counters().breaks > 0) return true;
  }
  return false;
}

/// The load at which it begins to break, as a multiple of the limit.
float thresholdOf(Load load, bool held, float dt) {
  float holds = 0.5f, fails = 2.0f;
  for (int i = 0; i < 12; ++i) {
    const float middle = 0.5f * (holds + fails);
    (breaks(middle, load, held, dt) ? fails : holds) = middle;
  }
  return 0.5f * (holds + fails);
}

TEST(B44, GlassBreaksExactlyAboveItsLimitWhateverTheTick) {
  for (const bool held : {true, false}) {
    for (const Load load : {Load::Box, Load::Ball, Load::Feet}) {
      for (const float dt : kTicks) {
        SCOPED_TRACE(std::string(nameOf(load)) + (held ? " on a held pane" : " on a lying one") + ", dt 1/" +
                     std::to_string(1.0f / dt));
        for (const float ratio : {0.1f, 0.3f, 0.6f, 0.9f, 0.98f}) EXPECT_FALSE(breaks(ratio, load, held, dt)) << ratio;
        for (const float ratio : {1.02f, 1.1f, 1.5f, 2.0f, 3.0f}) EXPECT_TRUE(breaks(ratio, load, held, dt)) << ratio;
        const float threshold = thresholdOf(load, held, dt);
        EXPECT_NEAR(threshold, 1.0f, 0.02f);
        hard::reportWorst("limit off by", 100.0 * std::abs(static_cast<double>(threshold) - 1.0), "%");
      }
    }
  }
}

/// Glass with a load hung under it. Held: a ceiling pane. Else: a pane that hangs by ropes itself.
std::uint32_t breaksWhenHung(float ratio, JointType type, bool held, float dt) {
  World world;
  BodyDef pane = bodyAt(Vec3::Zero(), held ? BodyType::Static : BodyType::Dynamic);
  pane.breakable.strength = kStrength;
  ShapeDef glass = shapeDef(2500.0f);
  glass.anchored = held;
  const ShapeHandle shape = world.body(addBox(world, pane, Vec3(0.5f, 0.01f, 0.5f), glass)).firstShape;
  for (int i = 0; !held && i < 4; ++i) {
    JointDef rope;
    rope.type = JointType::Rope;
    rope.a = shape;
    rope.anchorA = Vec3(i % 2 == 0 ? 0.45f : -0.45f, 0.0f, i < 2 ? 0.45f : -0.45f);
    rope.anchorB = rope.anchorA + Vec3(0.0f, 1.0f, 0.0f);
    world.createJoint(rope);
  }
  const BodyHandle load = addBall(world, Vec3(0.1f, -0.6f, 0.0f), Vec3::Zero(), 0.1f, massOf(ratio));
  JointDef joint;
  joint.type = type;
  joint.a = world.body(load).firstShape;
  joint.b = shape;
  joint.anchorA = type == JointType::Rope ? Vec3(0.1f, -0.5f, 0.0f) : Vec3(0.1f, 0.0f, 0.0f);
  joint.anchorB = Vec3(0.1f, 0.0f, 0.0f);
  joint.axis = Vec3::UnitZ();
  world.createJoint(joint);
  world.applyImpulse(load, Vec3(0.5f, 0.0f, 0.3f) * massOf(ratio), world.body(load).center);  // it swings
  std::uint32_t breaks = 0;
  for (int i = 0; i < static_cast<int>(3.0f / dt); ++i) {
    world.step(dt);
    breaks += world.counters().breaks;
  }
  return breaks;
}

TEST(B44, JointsNeverBreakGlass) {
  for (const float dt : kTicks) {
    for (const JointType type : {JointType::Ball, JointType::Hinge, JointType::Weld, JointType::Rope}) {
      for (const bool held : {true, false}) {
        for (const float ratio : {0.1f, 1.0f, 3.0f, 30.0f}) {
          EXPECT_EQ(breaksWhenHung(ratio, type, held, dt), 0u)
              << "joint " << static_cast<int>(type) << ", held " << held << ", " << ratio << " times the limit, dt 1/"
              << 1.0f / dt;
          hard::reportSum("hung", 1);
        }
      }
    }
  }
}

}  // namespace
}  // namespace brittle::physics
