// Chains, ropes and welds: what hangs together, and that it neither gains energy nor loses momentum.
#include <gtest/gtest.h>

#include "engine/core/random.h"
#include "tests/engine/physics/joint_scene.h"

namespace brittle::physics::test {
namespace {

/// Boxes of 0.2 m along `along`, jointed end to end; the first hangs on the world if `hangs`.
BodyHandle addChain(JointScene& scene, int links, const Vec3& along, bool hangs, float mass = 0.5f) {
  BodyHandle previous;
  for (int i = 0; i < links; ++i) {
    const Vec3 half = along.cwiseAbs() * 0.05f + Vec3::Constant(0.03f);
    const BodyHandle link = scene.addBox(along * (0.2f * static_cast<float>(i) + 0.1f), half, mass);
    if (i > 0 || hangs) scene.join(JointType::Ball, link, previous, along * (0.2f * static_cast<float>(i)));
    previous = link;
  }
  return previous;
}

TEST(JointChain, OfTwentyStaysClosedForTenSeconds) {
  for (const Vec3& along :
       {Vec3(0.0f, -1.0f, 0.0f), Vec3(1.0f, 0.0f, 0.0f)}) {  // hanging and pushed; let fall, cracks like a whip
    JointScene scene;
    const BodyHandle last = addChain(scene, 20, along, true);
    scene.body(last).velocity = Vec3(0.0f, 0.0f, 5.0f);
    const double energy = scene.energy();
    for (int i = 0; i < 600; ++i) {
      scene.step();
      ASSERT_LT(scene.widestGap(), 2e-3f) << "tick " << i;
      ASSERT_LT(scene.energy(), energy + 1e-3) << "tick " << i;
    }
  }
}

TEST(JointChain, CarriesAThousandTimesALinksMass) {
  JointScene scene;
  const BodyHandle last = addChain(scene, 20, Vec3(0.0f, -1.0f, 0.0f), true);
  const BodyHandle weight = scene.addBall(Vec3(0.0f, -4.3f, 0.0f), 0.3f, 500.0f);
  const JointHandle hook = scene.join(JointType::Ball, weight, last, Vec3(0.0f, -4.0f, 0.0f));
  scene.run(2.0f);
  EXPECT_LT(scene.widestGap(), 1e-4f);
  EXPECT_NEAR(scene.joint(hook).linearImpulse.y(), 500.0f * 9.81f * scene.dt, 0.1f);
}

TEST(JointChain, FlyingFreelyNeverGainsEnergyAndKeepsItsMomentum) {
  JointScene scene(Vec3::Zero());
  BodyHandle previous;
  for (int i = 0; i < 5; ++i) {
    const BodyHandle ball = scene.addBall(Vec3(0.2f * static_cast<float>(i), 0.0f, 0.0f), 0.08f, 0.5f);
    if (i > 0) scene.join(JointType::Ball, ball, previous, Vec3(0.2f * static_cast<float>(i) - 0.1f, 0.0f, 0.0f));
    previous = ball;
  }
  Random random(7);
  scene.state.bodies.forEach([&](BodyHandle, Body& b) {
    for (int k = 0; k < 3; ++k) {
      const float v = random.nextFloat();
      const float w = random.nextFloat();
      b.velocity[k] = 2.0f * v - 1.0f;
      b.angularVelocity[k] = 8.0f * w - 4.0f;
    }
  });
  const Vec3d push = scene.momentum();
  const Vec3d spin = scene.angularMomentum();
  const double size = 5 * 0.5 * 0.4;  // of what the links hold singly: mass, speed and distance from the middle
  scene.step();
  EXPECT_LT((scene.momentum() - push).norm(), 1e-5 * push.norm());
  EXPECT_LT((scene.angularMomentum() - spin).norm(), 1e-5 * size);
  double energy = scene.kineticEnergy();
  for (int i = 0; i < 1800; ++i) {
    scene.step();
    ASSERT_LT(scene.kineticEnergy(), energy * (1.0 + 1e-5)) << "tick " << i;
  }
  EXPECT_LT((scene.momentum() - push).norm(), 1e-4 * push.norm());
}

TEST(JointChain, SolvesARingOfHingesWhoseRowsDependOnEachOther) {
  JointScene scene;
  BodyHandle ring[6];
  Vec3 corner[6];
  for (int i = 0; i < 6; ++i)
    corner[i] = Vec3(cosine(kPi / 3.0f * static_cast<float>(i)), sine(kPi / 3.0f * static_cast<float>(i)), 0.0f);
  for (int i = 0; i < 6; ++i) ring[i] = scene.addBall(0.5f * (corner[i] + corner[(i + 1) % 6]), 0.1f, 1.0f);
  for (int i = 0; i < 6; ++i)
    scene.join(JointType::Hinge, ring[i], ring[(i + 1) % 6], corner[(i + 1) % 6], Vec3::UnitZ());
  scene.join(JointType::Ball, ring[0], {}, corner[0]);
  const double energy = scene.energy();
  for (int i = 0; i < 600; ++i) {
    scene.step();
    ASSERT_LT(scene.widestGap(), 1e-3f) << "tick " << i;
    ASSERT_LT(scene.energy(), energy + 1e-3) << "tick " << i;
  }
}

TEST(JointChain, TwoWeldsBetweenTheSameBodiesHoldLikeOne) {
  JointScene scene;
  const BodyHandle a = scene.addBall(Vec3::Zero(), 0.2f, 1.0f);
  const BodyHandle b = scene.addBall(Vec3(1.0f, 0.0f, 0.0f), 0.2f, 1.0f);
  scene.join(JointType::Ball, a, {}, Vec3::Zero());
  scene.join(JointType::Weld, a, b, Vec3(0.5f, 0.0f, 0.0f));
  scene.join(JointType::Weld, a, b, Vec3(0.5f, 0.0f, 0.0f));
  const double energy = scene.energy();
  for (int i = 0; i < 600; ++i) {
    scene.step();
    ASSERT_LT(scene.widestGap(), 1e-4f) << "tick " << i;
    ASSERT_LT(scene.energy(), energy + 0.25)
        << "tick " << i;  // of 10 J; m g v dt/2, as velocities are half a tick ahead
  }
}

TEST(JointChain, LongerThanOneSystemStillHolds) {
  JointScene scene;
  addChain(scene, 120, Vec3(0.0f, -1.0f, 0.0f), true);
  scene.run(5.0f);
  EXPECT_LT(scene.widestGap(), 5e-3f);
}

TEST(JointChain, SameCallsGiveTheSameBits) {
  Vec3 end[2];
  for (Vec3& e : end) {
    JointScene scene;
    const BodyHandle last = addChain(scene, 12, Vec3(1.0f, 0.0f, 0.0f), true);
    scene.run(3.0f);
    e = scene.body(last).center;
  }
  EXPECT_EQ(end[0], end[1]);
}

TEST(JointRope, DoesNothingWhileSlackAndHoldsWhenTaut) {
  JointScene scene;
  const BodyHandle weight = scene.addBall(Vec3(0.3f, 0.0f, 0.0f), 0.1f, 2.0f);
  const JointHandle rope = scene.join(JointType::Rope, weight, {}, Vec3(0.3f, 0.0f, 0.0f), Vec3::UnitY(), Vec3::Zero());
  scene.joint(rope).length = 1.0f;
  float fallen = 0.0f;
  for (int i = 1; scene.body(weight).center.norm() < 0.9f; ++i) {
    scene.step();
    fallen += 9.81f * scene.dt * scene.dt * static_cast<float>(i);
    ASSERT_NEAR(scene.body(weight).center.y(), -fallen, 1e-4f);
    ASSERT_EQ(scene.joint(rope).limitImpulse, 0.0f);
  }
  for (int i = 0; i < 600; ++i) {
    scene.step();
    ASSERT_LT(scene.body(weight).center.norm(), 1.0f + 1e-3f) << "tick " << i;
  }
  EXPECT_LT(scene.joint(rope).limitImpulse, 0.0f);  // pulls A towards B
}

TEST(JointRope, GoingTautSharesTheMomentum) {
  JointScene scene(Vec3::Zero());
  const BodyHandle a = scene.addBall(Vec3::Zero(), 0.1f, 3.0f);
  const BodyHandle b = scene.addBall(Vec3(1.0f, 0.0f, 0.0f), 0.1f, 1.0f);
  const JointHandle rope = scene.join(JointType::Rope, a, b, Vec3::Zero(), Vec3::UnitY(), Vec3(1.0f, 0.0f, 0.0f));
  scene.joint(rope).length = 1.5f;
  scene.body(b).velocity = Vec3(4.0f, 0.0f, 0.0f);
  scene.run(0.1f);
  EXPECT_EQ(scene.body(b).velocity.x(), 4.0f);
  scene.run(0.1f);
  EXPECT_NEAR(scene.body(a).velocity.x(), 1.0f, 1e-5f);
  EXPECT_NEAR(scene.body(b).velocity.x(), 1.0f, 1e-5f);
}

TEST(JointRope, SwingsWithoutLosingEnergy) {
  JointScene scene;
  const BodyHandle weight = scene.addBall(Vec3(0.6f, -0.8f, 0.0f), 0.05f, 1.0f);
  scene.join(JointType::Rope, weight, {}, Vec3(0.6f, -0.8f, 0.0f), Vec3::UnitY(), Vec3::Zero());
  const double energy = scene.energy() + 9.81;
  scene.run(20.0f);
  EXPECT_NEAR((scene.energy() + 9.81) / energy, 1.0, 0.05);
}

TEST(JointWeld, MovesTwoBodiesAsOne) {
  JointScene scene(Vec3::Zero());
  const BodyHandle a = scene.addBall(Vec3::Zero(), 0.2f, 1.0f);
  const BodyHandle b = scene.addBall(Vec3(1.0f, 0.0f, 0.0f), 0.2f, 1.0f);
  scene.join(JointType::Weld, a, b, Vec3(0.5f, 0.0f, 0.0f));
  scene.body(b).velocity = Vec3(0.0f, 2.0f, 0.0f);  // struck at one end
  const Vec3d push = scene.momentum();
  const Vec3d spin = scene.angularMomentum();
  scene.step();
  const float inertia = 2.0f * (0.4f * 0.04f + 0.25f);
  EXPECT_NEAR(scene.body(a).angularVelocity.z(), 0.5f * 2.0f / inertia, 1e-4f);  // about the common centre
  for (int i = 0; i < 600; ++i) {
    scene.step();
    const Transform seen = relativeTo(scene.body(a).pose, scene.body(b).pose);
    ASSERT_LT((seen.position - Vec3(1.0f, 0.0f, 0.0f)).norm(), 1e-4f) << "tick " << i;
    ASSERT_LT(seen.rotation.vec().norm(), 1e-4f) << "tick " << i;
  }
  EXPECT_LT((scene.momentum() - push).norm(), 1e-4 * push.norm());
  EXPECT_LT((scene.angularMomentum() - spin).norm(), 0.01 * spin.norm());
}

TEST(JointWeld, ImpulsesInsideKeepAngularMomentumInEveryTick) {
  JointScene scene(Vec3::Zero());
  const BodyHandle a = scene.addBall(Vec3::Zero(), 0.2f, 1.0f);
  const BodyHandle b = scene.addBall(Vec3(0.4f, 0.3f, 0.1f), 0.1f, 3.0f);
  scene.join(JointType::Weld, a, b, Vec3(0.2f, 0.1f, 0.0f));
  scene.body(a).angularVelocity = Vec3(1.0f, 2.0f, -3.0f);
  scene.body(b).velocity = Vec3(1.0f, -1.0f, 0.5f);
  scene.positionIterations = 0;
  for (int i = 0; i < 60; ++i) {
    const Vec3d spin = scene.angularMomentum();
    scene.step();
    ASSERT_LT((scene.angularMomentum() - spin).norm(), 1e-5 * spin.norm()) << "tick " << i;
  }
}

}  // namespace
}  // namespace brittle::physics::test
