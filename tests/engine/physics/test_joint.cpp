// Ball, hinge and slider against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/physics/joint_scene.h"

namespace brittle::physics::test {
namespace {

/// Swings a ball on a 1 m arm from `angle` [rad]; the mean time between downward passes over `seconds`.
double swingPeriod(float angle, float seconds, double& energyKept) {
  JointScene scene;
  const BodyHandle ball = scene.addBall(Vec3(std::sin(angle), -std::cos(angle), 0.0f), 0.1f, 1.0f);
  scene.join(JointType::Hinge, ball, {}, Vec3::Zero(), Vec3::UnitZ());
  const double lowest = -9.81;
  const double energy = scene.energy() - lowest;
  double first = -1.0, last = 0.0;
  int passes = 0;
  for (int i = 0; i < static_cast<int>(seconds / scene.dt); ++i) {
    const double before = scene.body(ball).center.x();
    scene.step();
    const double after = scene.body(ball).center.x();
    if (!(before > 0.0 && after <= 0.0)) continue;
    last = (i + before / (before - after)) * scene.dt;
    if (passes++ == 0) first = last;
  }
  energyKept = (scene.energy() - lowest) / energy;
  return (last - first) / (passes - 1);
}

constexpr double kSmallPeriod =
    2.0 * 3.14159265358979 * 0.319915;  // 2 pi sqrt((l^2 + 0.4 r^2) / (g l)), l = 1, r = 0.1

TEST(JointHinge, SmallSwingsHaveThePeriodOfAPhysicalPendulum) {
  double kept = 0.0;
  EXPECT_NEAR(swingPeriod(0.1f, 30.0f, kept) / (kSmallPeriod * (1.0 + 0.01 / 16.0)), 1.0, 3e-4);
}

TEST(JointHinge, LargeSwingsHaveThePeriodOfTheEllipticIntegralAndKeepTheirEnergy) {
  double kept = 0.0;
  const double elliptic = 1.68575035481260;  // K(sin(60 degrees / 2))
  EXPECT_NEAR(swingPeriod(kPi / 3.0f, 30.0f, kept) / (kSmallPeriod * elliptic * 2.0 / kPi), 1.0, 5e-4);
  EXPECT_NEAR(kept, 1.0, 0.03);  // fourteen swings; holding J v = 0 at the old arms alone keeps a third
}

TEST(JointHinge, KeepsItsAxis) {
  JointScene scene;
  const Vec3 axis = Vec3(1.0f, 0.2f, 0.1f).normalized();
  const BodyHandle arm = scene.addBox(Vec3(0.0f, 0.0f, 0.5f), Vec3(0.1f, 0.05f, 0.5f), 2.0f);
  const JointHandle hinge = scene.join(JointType::Hinge, arm, {}, Vec3(0.05f, 0.0f, 0.0f), axis);
  scene.body(arm).angularVelocity = axis * 3.0f;
  scene.body(arm).velocity = scene.body(arm).angularVelocity.cross(scene.body(arm).center - Vec3(0.05f, 0.0f, 0.0f));
  for (int i = 0; i < 600; ++i) {
    scene.step();
    ASSERT_LT(scene.body(arm).pose.rotate(scene.joint(hinge).localAxisA).cross(axis).norm(), 1e-4f) << "tick " << i;
    ASSERT_LT(scene.gap(hinge), 1e-4f) << "tick " << i;
  }
}

TEST(JointHinge, MotorReachesItsSpeedInTheTimeThatTorqueOverInertiaGives) {
  for (const float arm : {0.0f, 0.4f}) {  // turning about its centre, and about a point beside it
    JointScene scene(Vec3::Zero());
    const BodyHandle wheel = scene.addBall(Vec3(arm, 0.0f, 0.0f), 0.5f, 2.0f);
    const JointHandle hinge = scene.join(JointType::Hinge, wheel, {}, Vec3::Zero(), Vec3::UnitZ());
    scene.joint(hinge).motor = true;
    scene.joint(hinge).motorSpeed = 2.0f;
    scene.joint(hinge).motorLimit = 1.5f;
    const float inertia = 0.4f * 2.0f * 0.25f + 2.0f * arm * arm;
    const float reached = inertia * 2.0f / 1.5f;
    const int halfway = static_cast<int>(0.5f * reached / scene.dt);
    for (int i = 0; i < halfway; ++i) scene.step();
    EXPECT_NEAR(scene.body(wheel).angularVelocity.z(), 1.5f / inertia * static_cast<float>(halfway) * scene.dt, 2e-3f)
        << arm;
    scene.run(0.5f * reached + 0.1f);
    EXPECT_NEAR(scene.body(wheel).angularVelocity.z(), 2.0f, 1e-3f) << arm;
    EXPECT_NEAR(scene.joint(hinge).motorImpulse, 0.0f, 1e-3f) << arm;
  }
}

TEST(JointHinge, MotorBetweenFreeBodiesTurnsThemAgainstEachOther) {
  JointScene scene(Vec3::Zero());
  const BodyHandle a = scene.addBall(Vec3::Zero(), 0.3f, 1.0f);
  const BodyHandle b = scene.addBall(Vec3(0.0f, 0.7f, 0.0f), 0.5f, 4.0f);
  const JointHandle hinge = scene.join(JointType::Hinge, a, b, Vec3(0.0f, 0.3f, 0.0f));
  scene.joint(hinge).motor = true;
  scene.joint(hinge).motorSpeed = 5.0f;
  scene.joint(hinge).motorLimit = 1.0f;
  scene.run(2.0f);
  EXPECT_NEAR(scene.body(a).angularVelocity.y() - scene.body(b).angularVelocity.y(), 5.0f, 1e-4f);
  EXPECT_LT(scene.angularMomentum().norm(), 1e-5);
}

TEST(JointHinge, LimitsHold) {
  JointScene scene;
  const BodyHandle arm = scene.addBox(Vec3(0.5f, 0.0f, 0.0f), Vec3(0.5f, 0.05f, 0.05f), 1.0f);
  const JointHandle hinge = scene.join(JointType::Hinge, arm, {}, Vec3::Zero(), Vec3::UnitZ());
  scene.joint(hinge).limited = true;
  scene.joint(hinge).lower = -0.5f;
  scene.joint(hinge).upper = 1.0f;
  scene.body(arm).angularVelocity = Vec3(0.0f, 0.0f, 20.0f);
  scene.body(arm).velocity = Vec3(0.0f, 10.0f, 0.0f);
  float highest = 0.0f;
  for (int i = 0; i < 300; ++i) {
    scene.step();
    const float angle = arcTangent(scene.body(arm).center.y(), scene.body(arm).center.x());
    highest = maxOf(highest, angle);
    ASSERT_GT(angle, -0.5f - 1e-3f) << "tick " << i;
    ASSERT_LT(angle, 1.0f + 1e-3f) << "tick " << i;
  }
  EXPECT_GT(highest, 0.99f);
  EXPECT_NEAR(arcTangent(scene.body(arm).center.y(), scene.body(arm).center.x()), -0.5f, 1e-3f);
  EXPECT_GT(scene.joint(hinge).limitImpulse, 0.0f);
}

TEST(JointSlider, FallsAlongAnInclinedAxisWithTheAccelerationOfTheSlope) {
  JointScene scene;
  const Vec3 axis = Vec3(0.8f, -0.6f, 0.0f);
  const BodyHandle block = scene.addBox(Vec3(0.0f, 5.0f, 0.0f), Vec3(0.2f, 0.3f, 0.1f), 3.0f);
  scene.join(JointType::Slider, block, {}, Vec3(0.3f, 5.4f, 0.2f), axis);  // beside the centre: gravity also twists it
  for (int i = 1; i <= 120; ++i) {
    scene.step();
    const float speed = 9.81f * 0.6f * static_cast<float>(i) * scene.dt;
    ASSERT_LT((scene.body(block).velocity - axis * speed).norm(), 1e-3f) << "tick " << i;
    const Vec3 way = scene.body(block).center - Vec3(0.0f, 5.0f, 0.0f);
    ASSERT_LT((way - axis * way.dot(axis)).norm(), 1e-4f) << "tick " << i;
    ASSERT_LT(scene.body(block).pose.rotation.vec().norm(), 1e-4f) << "tick " << i;
  }
}

TEST(JointSlider, MotorPushesToTheLimitAndHoldsThere) {
  JointScene scene;
  const BodyHandle lift = scene.addBox(Vec3::Zero(), Vec3::Constant(0.2f), 2.0f);
  const JointHandle slider = scene.join(JointType::Slider, lift, {}, Vec3::Zero());
  Joint& joint = scene.joint(slider);
  joint.motor = joint.limited = true;
  joint.motorSpeed = 1.0f;
  joint.motorLimit = 40.0f;  // twice the weight
  joint.lower = -1.0f;
  joint.upper = 0.5f;
  scene.run(0.25f);
  EXPECT_NEAR(scene.body(lift).velocity.y(), 1.0f, 1e-3f);
  scene.run(1.0f);
  EXPECT_NEAR(scene.body(lift).center.y(), 0.5f, 1e-3f);
  joint.motorLimit = 10.0f;  // half the weight: sinks with half of gravity, to the lower limit
  scene.run(0.25f);
  EXPECT_NEAR(scene.body(lift).velocity.y(), -0.25f * (9.81f - 5.0f), 2e-2f);
  scene.run(2.0f);
  EXPECT_NEAR(scene.body(lift).center.y(), -1.0f, 1e-3f);
}

TEST(JointSlider, RailMayMove) {
  JointScene scene(Vec3::Zero());
  const BodyHandle rail = scene.addBall(Vec3::Zero(), 0.5f, 5.0f);
  const BodyHandle carriage = scene.addBall(Vec3(1.0f, 0.0f, 0.0f), 0.2f, 1.0f);
  scene.join(JointType::Slider, carriage, rail, Vec3(1.0f, 0.0f, 0.0f), Vec3::UnitX());
  scene.body(rail).angularVelocity = Vec3(0.0f, 0.0f, 1.0f);
  scene.step();
  const Vec3d spin = scene.angularMomentum();
  scene.run(2.0f);
  const Vec3 seen = scene.body(rail).pose.toLocal(scene.body(carriage).center);
  EXPECT_GT(seen.x(), 1.2f);  // flung outwards
  EXPECT_LT(std::abs(seen.y()) + std::abs(seen.z()), 1e-3f);
  EXPECT_LT((scene.angularMomentum() - spin).norm(), 0.02 * spin.norm());
}

TEST(JointBall, LeavesAllRotationsFree) {
  JointScene scene(Vec3::Zero());
  const BodyHandle ball = scene.addBall(Vec3::Zero(), 0.2f, 1.0f);
  const JointHandle joint = scene.join(JointType::Ball, ball, {}, Vec3::Zero());
  scene.body(ball).angularVelocity = Vec3(1.0f, 2.0f, 3.0f);
  scene.run(1.0f);
  EXPECT_LT((scene.body(ball).angularVelocity - Vec3(1.0f, 2.0f, 3.0f)).norm(), 1e-5f);
  EXPECT_LT(scene.gap(joint), 1e-6f);
}

TEST(JointBall, ClosesAGapByMovingOnly) {
  JointScene scene(Vec3::Zero());
  const BodyHandle a = scene.addBall(Vec3::Zero(), 0.2f, 1.0f);
  const BodyHandle b = scene.addBall(Vec3(1.0f, 0.0f, 0.0f), 0.2f, 1.0f);
  const JointHandle joint = scene.join(JointType::Ball, a, b, Vec3(0.5f, 0.0f, 0.0f));
  scene.body(b).center += Vec3(0.1f, 0.1f, 0.0f);
  scene.body(b).placeByCenter();
  const Vec3 middle = 0.5f * (scene.body(a).center + scene.body(b).center);
  scene.step();
  EXPECT_LT(scene.gap(joint), 1e-5f);
  EXPECT_EQ(scene.kineticEnergy(), 0.0);
  EXPECT_LT((0.5f * (scene.body(a).center + scene.body(b).center) - middle).norm(), 1e-6f);
}

TEST(Joint, BetweenShapesOfOneBodyIsInert) {
  JointScene scene(Vec3::Zero());
  const BodyHandle body = scene.addBall(Vec3::Zero(), 0.2f, 1.0f);
  const BodyHandle other = scene.addBall(Vec3(1.0f, 0.0f, 0.0f), 0.2f, 1.0f);
  const JointHandle joint = scene.join(JointType::Ball, body, other, Vec3(0.5f, 0.0f, 0.0f));
  scene.joint(joint).linearImpulse = Vec3(1.0f, 2.0f, 3.0f);
  scene.state.shapes[scene.shapeOf(other)].body = body;
  scene.body(body).velocity = Vec3(0.0f, 1.0f, 0.0f);
  scene.step();
  EXPECT_TRUE(scene.state.jointSolver.isEmpty());
  EXPECT_EQ(scene.joint(joint).linearImpulse, Vec3(0.0f, 0.0f, 0.0f));
  EXPECT_EQ(scene.body(body).velocity, Vec3(0.0f, 1.0f, 0.0f));
}

TEST(Joint, ForbidsCollisionOfItsBodiesOnlyIfAsked) {
  JointScene scene;
  const BodyHandle a = scene.addBall(Vec3::Zero(), 0.2f, 1.0f);
  const BodyHandle b = scene.addBall(Vec3(1.0f, 0.0f, 0.0f), 0.2f, 1.0f);
  const BodyHandle c = scene.addBall(Vec3(2.0f, 0.0f, 0.0f), 0.2f, 1.0f);
  EXPECT_FALSE(jointForbidsCollision(scene.state, a, b));
  const JointHandle joint = scene.join(JointType::Ball, a, b, Vec3(0.5f, 0.0f, 0.0f));
  scene.join(JointType::Ball, c, {}, Vec3(2.0f, 0.0f, 0.0f));
  EXPECT_TRUE(jointForbidsCollision(scene.state, a, b));
  EXPECT_TRUE(jointForbidsCollision(scene.state, b, a));
  EXPECT_FALSE(jointForbidsCollision(scene.state, a, c));
  scene.joint(joint).collideConnected = true;
  EXPECT_FALSE(jointForbidsCollision(scene.state, a, b));
}

TEST(Joint, WakesASleeperHeldToAMovingBodyOrTurnedByAMotor) {
  JointScene scene;
  const BodyHandle a = scene.addBox(Vec3::Zero(), Vec3::Constant(0.1f), 1.0f);
  const BodyHandle b = scene.addBox(Vec3(1.0f, 0.0f, 0.0f), Vec3::Constant(0.1f), 1.0f);
  const BodyHandle c = scene.addBox(Vec3(3.0f, 0.0f, 0.0f), Vec3::Constant(0.1f), 1.0f);
  scene.join(JointType::Ball, a, b, Vec3(0.5f, 0.0f, 0.0f));
  const JointHandle hinge = scene.join(JointType::Hinge, c, {}, Vec3(3.0f, 0.0f, 0.0f));
  scene.body(a).awake = scene.body(c).awake = false;
  scene.body(b).restTicks = 5;  // awake, but as good as at rest
  wakeByJoints(scene.state);
  EXPECT_FALSE(scene.body(a).awake);
  EXPECT_FALSE(scene.body(c).awake);
  scene.body(b).restTicks = 0;
  scene.joint(hinge).motor = true;
  scene.joint(hinge).motorSpeed = 1.0f;
  wakeByJoints(scene.state);
  EXPECT_TRUE(scene.body(a).awake);
  EXPECT_TRUE(scene.body(c).awake);
}

TEST(Joint, MovesWithTheOrigin) {
  JointScene scene;
  const BodyHandle a = scene.addBall(Vec3::Zero(), 0.2f, 1.0f);
  const BodyHandle b = scene.addBall(Vec3(1.0f, 0.0f, 0.0f), 0.2f, 1.0f);
  const JointHandle inner = scene.join(JointType::Ball, a, b, Vec3(0.5f, 0.0f, 0.0f));
  const JointHandle outer = scene.join(JointType::Ball, a, {}, Vec3::Zero());
  const Vec3 within = scene.joint(inner).localAnchorB;
  shiftJoints(scene.state, Vec3(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(scene.joint(inner).localAnchorB, within);
  EXPECT_EQ(scene.joint(outer).localAnchorB, Vec3(-1.0f, -2.0f, -3.0f));
}

}  // namespace
}  // namespace brittle::physics::test
