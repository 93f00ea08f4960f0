// Drives: their force law in closed form, and who they keep awake.
#include <gtest/gtest.h>

#include "tests/engine/physics/joint_scene.h"

namespace brittle::physics::test {
namespace {

DriveDef positionDrive(const JointScene& scene, BodyHandle body, const Vec3& position, float strength) {
  DriveDef def;
  def.assembly = scene.state.bodies[body].assembly;
  def.drivePosition = true;
  def.position = position;
  def.strength = strength;
  return def;
}

TEST(Drive, ReachesItsTargetWithoutOvershootAndNoFasterThanAllowed) {
  for (const float strength : {0.5f, 10.0f, 100.0f}) {
    JointScene scene;
    const BodyHandle door = scene.addBox(Vec3::Zero(), Vec3::Constant(0.5f), 20.0f);
    DriveDef def = positionDrive(scene, door, Vec3(2.0f, 0.0f, 0.0f), strength);
    def.maxSpeed = 0.8f;
    scene.drive(def);
    for (int i = 0; i < 240; ++i) {
      scene.step();
      ASSERT_LT(scene.body(door).velocity.norm(), 0.8f + 1e-5f);
      ASSERT_LT(scene.body(door).center.x(), 2.0f + 1e-5f);
      ASSERT_NEAR(scene.body(door).center.y(), 0.0f, 1e-5f);  // it carries the weight
    }
    EXPECT_NEAR(scene.body(door).center.x(), 2.0f, 1e-5f) << strength;
  }
}

TEST(Drive, PushesWithItsForceAndNoMore) {
  JointScene scene(Vec3::Zero());
  const BodyHandle body = scene.addBox(Vec3::Zero(), Vec3::Constant(0.5f), 7.0f);
  scene.drive(positionDrive(scene, body, Vec3(5.0f, 0.0f, 0.0f), 0.5f));
  for (int i = 1; i <= 30; ++i) {
    scene.step();
    ASSERT_NEAR(scene.body(body).velocity.x(), 0.5f * 20.0f * static_cast<float>(i) * scene.dt, 1e-4f);
  }
}

/// How far a body at its target gives way when struck to `speed`.
float givesWay(float strength, float speed) {
  JointScene scene(Vec3::Zero());
  const BodyHandle body = scene.addBox(Vec3::Zero(), Vec3::Constant(0.5f), 7.0f);
  scene.drive(positionDrive(scene, body, Vec3::Zero(), strength));
  scene.body(body).velocity = Vec3(0.0f, 0.0f, speed);
  float farthest = 0.0f;
  for (int i = 0; i < 600; ++i) {
    scene.step();
    farthest = maxOf(farthest, scene.body(body).center.z());
  }
  EXPECT_LT(scene.body(body).center.norm(), 1e-4f) << "back at its place";
  return farthest;
}

TEST(Drive, SoftIsKnockedAsideFirmHardlyRigidNot) {
  EXPECT_NEAR(givesWay(1.0f, 4.0f), 16.0f / 40.0f, 0.04f);  // v^2 / 2a
  EXPECT_NEAR(givesWay(10.0f, 4.0f), 16.0f / 400.0f, 0.04f);
  EXPECT_EQ(givesWay(100.0f, 4.0f), 0.0f);
}

TEST(Drive, TurnsToItsTargetTheShortWay) {
  JointScene scene;
  scene.state.gravity = Vec3::Zero();
  const BodyHandle body = scene.addBox(Vec3::Zero(), Vec3(0.5f, 0.1f, 0.3f), 7.0f);
  DriveDef def;
  def.assembly = scene.body(body).assembly;
  def.driveRotation = true;
  def.rotation = rotationAbout(Vec3::UnitZ(), -2.0f);
  def.maxAngularSpeed = 3.0f;
  scene.drive(def);
  scene.step();
  EXPECT_LT(scene.body(body).angularVelocity.z(), 0.0f);
  scene.run(2.0f);
  EXPECT_LT((scene.body(body).pose.rotation.coeffs() - def.rotation.coeffs()).norm(), 1e-4f);
  EXPECT_LT(scene.body(body).angularVelocity.norm(), 1e-4f);
}

TEST(Drive, PiecesOfAnAssemblyKeepGoingToTheSameFrame) {
  JointScene scene(Vec3::Zero());
  const BodyHandle first = scene.addBox(Vec3::Zero(), Vec3::Constant(0.2f), 1.0f);
  Body piece = scene.body(first);
  piece.localCenter = Vec3(0.7f, 0.0f, 0.0f);  // a piece keeps its parent's frame
  piece.placeByPose();
  const BodyHandle second = scene.add(piece);
  const BodyHandle stranger = scene.addBox(Vec3(0.0f, 3.0f, 0.0f), Vec3::Constant(0.2f), 1.0f);
  DriveDef def = positionDrive(scene, first, Vec3(0.0f, 1.0f, 0.0f), 10.0f);
  def.driveRotation = true;
  def.rotation = rotationAbout(Vec3::UnitZ(), 1.0f);
  scene.drive(def);
  scene.run(2.0f);
  for (const BodyHandle body : {first, second}) {
    EXPECT_LT((scene.body(body).pose.position - def.position).norm(), 1e-4f);
    EXPECT_LT((scene.body(body).pose.rotation.coeffs() - def.rotation.coeffs()).norm(), 1e-4f);
  }
  EXPECT_EQ(scene.body(stranger).center, Vec3(0.0f, 3.0f, 0.0f));
}

TEST(Drive, ALaterRoundOfTheSameTickSpendsNoSecondLimit) {
  JointScene scene(Vec3::Zero());
  const BodyHandle body = scene.addBox(Vec3::Zero(), Vec3::Constant(0.5f), 7.0f);
  scene.drive(positionDrive(scene, body, Vec3(5.0f, 0.0f, 0.0f), 0.5f));
  State& state = scene.state;
  state.solverBodies.assign(1, SolverBody{});
  state.solverBodies[0].invMass = 1.0f / 7.0f;
  for (const bool isFirst : {true, false, false}) {
    state.driveSolver.prepare(state, scene.dt, isFirst);
    for (int i = 0; i < 10; ++i) state.driveSolver.solve(state.solverBodies.data());
    EXPECT_NEAR(state.solverBodies[0].velocity.x(), 10.0f * scene.dt, 1e-5f);
  }
}

TEST(Drive, WakesASleeperThatIsNotAtItsTarget) {
  JointScene scene;
  const BodyHandle there = scene.addBox(Vec3::Zero(), Vec3::Constant(0.5f), 1.0f);
  const BodyHandle away = scene.addBox(Vec3(5.0f, 0.0f, 0.0f), Vec3::Constant(0.5f), 1.0f);
  scene.drive(positionDrive(scene, there, Vec3::Zero(), 1.0f));
  scene.drive(positionDrive(scene, away, Vec3::Zero(), 1.0f));
  scene.body(there).awake = scene.body(away).awake = false;
  wakeByDrives(scene.state);
  EXPECT_FALSE(scene.body(there).awake);
  EXPECT_TRUE(scene.body(away).awake);
}

TEST(Drive, ItsTargetMovesWithTheOrigin) {
  JointScene scene;
  const DriveHandle drive = scene.drive({});
  shiftDrives(scene.state, Vec3(1.0f, 2.0f, 3.0f));
  EXPECT_EQ(scene.state.drives[drive].def.position, Vec3(-1.0f, -2.0f, -3.0f));
}

}  // namespace
}  // namespace brittle::physics::test
