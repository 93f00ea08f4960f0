// Where joints go when the shape that holds their anchor is split, and World's doors to joints.
#include <gtest/gtest.h>

#include "engine/geometry/split.h"
#include "engine/physics/state.h"
#include "tests/engine/physics/scene.h"

namespace brittle::physics {
namespace {

WorldDef weightless() {
  WorldDef def;
  def.gravity = Vec3::Zero();
  return def;
}

/// A box of 2 x 1 x 1 m, jointed to the world at `anchor`, then cut at x = 0 by hand.
struct CutBox {
  World world{weightless()};
  BodyHandle body;
  ShapeHandle source, pieces[2];
  JointHandle joint;

  explicit CutBox(const Vec3& anchor) {
    body = world.createBody(bodyAt(Vec3(3.0f, 0.0f, 0.0f)));
    const geometry::Convex box = geometry::makeBox<float>(Vec3(1.0f, 0.5f, 0.5f));
    source = world.addConvex(body, shapeDef(), box.view());
    JointDef def;
    def.a = source;
    def.anchorA = Vec3(3.0f, 0.0f, 0.0f) + anchor;
    joint = world.createJoint(def);
    geometry::SplitScratch scratch;
    geometry::Convex above, below;
    geometry::split(box.view(), planeThrough(Vec3::Zero(), Vec3::UnitX()), {}, scratch, above, below);
    pieces[0] = world.addConvex(body, shapeDef(), below.view());
    pieces[1] = world.addConvex(body, shapeDef(), above.view());
  }
  std::uint32_t move(std::uint32_t first, std::uint32_t count, float slop = 1e-3f) {
    return moveJoints(world.state(), source, pieces + first, count, slop);
  }
  ShapeHandle owner() const { return world.joint(joint).a; }
};

TEST(MoveJoints, GoWithThePieceThatContainsTheAnchor) {
  CutBox left(Vec3(-0.4f, 0.1f, 0.2f)), right(Vec3(0.4f, 0.1f, 0.2f));
  EXPECT_EQ(left.move(0, 2), 0u);
  EXPECT_EQ(right.move(0, 2), 0u);
  EXPECT_EQ(left.owner(), left.pieces[0]);
  EXPECT_EQ(right.owner(), right.pieces[1]);
}

TEST(MoveJoints, OnTheCutPlaneTheFirstPieceHoldsThem) {
  CutBox box(Vec3(0.0f, 0.1f, 0.2f));
  EXPECT_EQ(box.move(0, 2), 0u);
  EXPECT_EQ(box.owner(), box.pieces[0]);
}

TEST(MoveJoints, CarvedOutAreGoneUnlessAPieceIsWithinTheSlop) {
  CutBox far(Vec3(-0.4f, 0.0f, 0.0f)), near(Vec3(-0.0005f, 0.0f, 0.0f));
  EXPECT_EQ(far.move(1, 1), 1u);
  EXPECT_FALSE(far.world.isAlive(far.joint));
  EXPECT_EQ(near.move(1, 1), 0u);
  EXPECT_EQ(near.owner(), near.pieces[1]);
}

TEST(MoveJoints, AnAnchorBesideItsShapeStaysAsFarBesideThePiece) {
  CutBox box(Vec3(-1.2f, 0.0f, 0.0f));
  EXPECT_NEAR(box.world.joint(box.joint).gapA, 0.2f, 1e-5f);
  EXPECT_EQ(box.move(0, 2), 0u);
  EXPECT_EQ(box.owner(), box.pieces[0]);
  CutBox other(Vec3(-1.2f, 0.0f, 0.0f));
  EXPECT_EQ(other.move(1, 1), 1u);  // the other half is 1.2 m away
}

TEST(MoveJoints, OfAShapeThatIsGoneAreRemoved) {
  CutBox box(Vec3::Zero());
  box.world.removeShape(box.source);
  EXPECT_FALSE(box.world.isAlive(box.joint));
}

TEST(CreateJoint, TakesTheShapeThatHoldsTheAnchor) {
  World world(weightless());
  const BodyHandle body = world.createBody(bodyAt(Vec3::Zero()));
  const ShapeHandle hub = world.addConvex(body, shapeDef(), geometry::makeBox<float>(Vec3::Constant(0.1f)).view());
  const ShapeHandle arm = world.addConvex(
      body, shapeDef(), geometry::makeBox<float>(Vec3(0.5f, 0.1f, 0.1f), Vec3(0.6f, 0.0f, 0.0f)).view());
  JointDef def;
  def.a = hub;
  def.anchorA = Vec3(0.8f, 0.0f, 0.0f);
  EXPECT_EQ(world.joint(world.createJoint(def)).a, arm);
  def.anchorA = Vec3(0.1f, 0.0f, 0.0f);  // on both
  EXPECT_EQ(world.joint(world.createJoint(def)).a, hub);
  def.a = arm;
  EXPECT_EQ(world.joint(world.createJoint(def)).a, arm);
}

int failures = 0;
void countFailure(const char*, const char*, int) {
  ++failures;
}

TEST(CreateJoint, RefusesWrongDefinitions) {
  World world(weightless());
  const BodyHandle body = addBox(world, bodyAt(Vec3::Zero()), Vec3::Constant(0.5f));
  JointDef right;
  right.a = world.body(body).firstShape;
  JointDef wrong[8];
  for (JointDef& def : wrong) def = right;
  wrong[0].a = {};
  wrong[1].b = right.a;
  wrong[2].anchorA.x() = std::numeric_limits<float>::quiet_NaN();
  wrong[3].axis = Vec3(1.0f, 1.0f, 0.0f);
  wrong[4].motor = true;  // a ball
  wrong[5].lower = 1.0f;
  wrong[6].type = JointType::Hinge;
  wrong[6].limited = true;
  wrong[6].upper = 4.0f;
  wrong[7].motorLimit = -1.0f;
  const AssertHandler before = setAssertHandler(countFailure);
  for (const JointDef& def : wrong) {
    failures = 0;
    EXPECT_FALSE(world.createJoint(def)) << (&def - wrong);
    EXPECT_EQ(failures, 1) << (&def - wrong);
  }
  DriveDef drive;
  drive.strength = 0.0f;
  failures = 0;
  EXPECT_FALSE(world.createDrive(drive));
  EXPECT_EQ(failures, 1);
  setAssertHandler(before);
  EXPECT_TRUE(world.isAlive(world.createJoint(right)));
}

TEST(SetMotor, StartsAndStopsAWheelThatSleeps) {
  World world(weightless());
  const BodyHandle wheel = addBox(world, bodyAt(Vec3::Zero()), Vec3(0.5f, 0.1f, 0.5f));
  JointDef def;
  def.type = JointType::Hinge;
  def.a = world.body(wheel).firstShape;
  const JointHandle hinge = world.createJoint(def);
  for (int i = 0; i < 60; ++i) world.step(kTick);
  ASSERT_FALSE(world.body(wheel).awake);
  world.setMotor(hinge, true, 3.0f, 1e6f);
  for (int i = 0; i < 60; ++i) world.step(kTick);
  EXPECT_NEAR(world.body(wheel).angularVelocity.y(), 3.0f, 1e-4f);
  EXPECT_LT(world.body(wheel).center.norm(), 1e-5f);
  world.destroyJoint(hinge);
  EXPECT_FALSE(world.isAlive(hinge));
}

TEST(Joint, GoesOnAfterASnapshotAsWithoutOne) {
  World a, b;
  const BodyHandle first = addBox(a, bodyAt(Vec3(0.0f, 5.0f, 0.0f)), Vec3(0.4f, 0.1f, 0.1f));
  const BodyHandle second = addBox(a, bodyAt(Vec3(1.0f, 5.0f, 0.0f)), Vec3(0.4f, 0.1f, 0.1f));
  JointDef def;
  def.a = a.body(first).firstShape;
  def.anchorA = Vec3(-0.5f, 5.0f, 0.0f);
  a.createJoint(def);
  def.b = a.body(second).firstShape;
  def.anchorA = Vec3(0.5f, 5.0f, 0.0f);
  a.createJoint(def);
  DriveDef drive;
  drive.assembly = a.body(second).assembly;
  drive.drivePosition = true;
  drive.strength = 0.4f;
  a.createDrive(drive);
  for (int i = 0; i < 30; ++i) a.step(kTick);
  ByteWriter out;
  a.save(out);
  ByteReader in(out.bytes());
  ASSERT_TRUE(b.restore(in));
  for (int i = 0; i < 60; ++i) {
    a.step(kTick);
    b.step(kTick);
    ASSERT_EQ(a.stateHash(), b.stateHash()) << "tick " << i;
  }
}

/// How far a driven plate of 5 kg is behind its place after a ball of 1 kg at 10 m/s struck it, at most. [m]
float knockedBy(float strength) {
  World world(weightless());
  const BodyHandle plate = addBox(world, bodyAt(Vec3::Zero()), Vec3(0.5f, 0.5f, 0.05f), shapeDef(50.0f));
  DriveDef drive;
  drive.assembly = world.body(plate).assembly;
  drive.drivePosition = drive.driveRotation = true;
  drive.strength = strength;
  world.createDrive(drive);
  addBall(world, Vec3(0.0f, 0.0f, 1.0f), Vec3(0.0f, 0.0f, -10.0f), 0.1f, 1.0f);
  float farthest = 0.0f;
  for (int i = 0; i < 240; ++i) {
    world.step(kTick);
    farthest = maxOf(farthest, world.body(plate).center.norm());
  }
  return farthest;
}

TEST(Drive, ABallKnocksASoftPlateAsideButNotARigidOne) {
  const float common = 10.0f / 6.0f;  // speed of both after the hit, without the drive
  EXPECT_GT(knockedBy(0.5f), 0.5f * common * common / 20.0f);
  EXPECT_LT(knockedBy(10.0f), 0.03f);
  EXPECT_LT(knockedBy(100.0f), 1e-3f);
}

TEST(Drive, MovesBothPartsOfABrokenAssembly) {
  World world;
  BodyDef def = bodyAt(Vec3(0.0f, 3.0f, 0.0f));
  def.breakable.strength = 1.0f;
  const BodyHandle plate = addBox(world, def, Vec3(1.0f, 0.1f, 0.02f), shapeDef(2500.0f));
  DriveDef drive;
  drive.assembly = world.body(plate).assembly;
  drive.drivePosition = drive.driveRotation = true;
  drive.position = Vec3(0.0f, 3.0f, 0.0f);
  drive.strength = 5.0f;
  world.createDrive(drive);
  world.breakBody(plate, Vec3(0.0f, 3.0f, 0.02f), -Vec3::UnitZ(), 10.0f, 0.05f);
  for (int i = 0; i < 60; ++i) world.step(kTick);
  std::vector<BodyHandle> bodies;
  world.bodiesOf(drive.assembly, bodies);
  EXPECT_GT(bodies.size(), 2u);
  for (const BodyHandle body : bodies)
    EXPECT_LT((world.body(body).pose.position - drive.position).norm(), 1e-3f) << body.index;
}

/// A hub of steel with an arm of glass, turned by a motor. The arm breaks off and flies where it went.
TEST(Joint, ABrokenRotorArmFliesOffTangentially) {
  World world(weightless());
  BodyDef rotor = bodyAt(Vec3::Zero());
  rotor.breakable.strength = 1.0f;
  const BodyHandle body = world.createBody(rotor);
  const ShapeHandle hub = world.addConvex(body, shapeDef(), geometry::makeBox<float>(Vec3::Constant(0.1f)).view());
  world.addConvex(body, shapeDef(), geometry::makeBox<float>(Vec3(0.5f, 0.05f, 0.05f), Vec3(0.6f, 0.0f, 0.0f)).view());
  JointDef def;
  def.type = JointType::Hinge;
  def.a = hub;
  def.motor = true;
  def.motorSpeed = 4.0f;
  def.motorLimit = 1e4f;
  const JointHandle hinge = world.createJoint(def);
  for (int i = 0; i < 90; ++i) world.step(kTick);
  const Body before = world.body(body);
  ASSERT_NEAR(before.angularVelocity.y(), 4.0f, 1e-3f);
  const Vec3 middle = before.pose.toWorld(Vec3(0.5f, 0.0f, 0.0f));
  world.breakBody(body, middle, Vec3(0.0f, -1.0f, 0.0f), 10.0f, 0.02f);
  world.step(kTick);
  ASSERT_TRUE(world.isAlive(hinge));
  const BodyHandle turning = world.bodyOf(world.joint(hinge).a);
  int flying = 0;
  world.forEachBody([&](BodyHandle handle, const Body& piece) {
    if (handle == turning) return;
    ++flying;
    const Vec3 start = piece.center - piece.velocity * kTick;
    EXPECT_LT((piece.velocity - before.velocityAt(start)).norm(), 1e-4f * before.velocityAt(start).norm() + 1e-4f)
        << handle.index;
    EXPECT_LT((piece.angularVelocity - before.angularVelocity).norm(), 1e-3f) << handle.index;
  });
  EXPECT_GT(flying, 1);
  for (int i = 0; i < 30; ++i) world.step(kTick);
  EXPECT_NEAR(world.body(world.bodyOf(world.joint(hinge).a)).angularVelocity.y(), 4.0f, 1e-2f);
}

}  // namespace
}  // namespace brittle::physics
