// A world of joints only: bodies without contacts, and the tick of physics reduced to what joints take part in, so that
// closed forms can be compared with JointSolver alone.
#pragma once

#include "engine/physics/state.h"

namespace brittle::physics::test {

struct JointScene {
  State state;
  int iterations = 10;
  int positionIterations = 3;
  float dt = 1.0f / 60.0f;

  explicit JointScene(const Vec3& gravity = Vec3(0.0f, -9.81f, 0.0f)) { state.gravity = gravity; }

  /// A box without a mesh (its shape is a tiny sphere that stands for the handle).
  BodyHandle addBox(const Vec3& center, const Vec3& half, float mass, const Quat& rotation = Quat::Identity()) {
    Body body;
    body.type = BodyType::Dynamic;
    body.awake = true;
    body.pose = {center, rotation};
    body.center = center;
    body.mass = mass;
    body.invMass = 1.0f / mass;
    const Vec3 square = half.cwiseProduct(half);
    const Vec3 inertia = mass / 3.0f * Vec3(square.y() + square.z(), square.x() + square.z(), square.x() + square.y());
    body.localInertia = inertia.asDiagonal();
    body.localInvInertia = inertia.cwiseInverse().asDiagonal();
    body.assembly = state.nextAssembly++;
    return add(body);
  }
  BodyHandle addBall(const Vec3& center, float radius, float mass) {
    const BodyHandle handle = addBox(center, Vec3::Constant(radius), mass);
    Body& body = state.bodies[handle];
    body.localInertia = Mat3::Identity() * (0.4f * mass * radius * radius);
    body.localInvInertia = Mat3::Identity() / (0.4f * mass * radius * radius);
    refresh(body);
    return handle;
  }
  BodyHandle add(Body body) {
    refresh(body);
    const BodyHandle handle = state.bodies.insert(body);
    Shape shape;
    shape.body = handle;
    shape.radius = 0.01f;
    state.bodies[handle].firstShape = state.shapes.insert(shape);
    return handle;
  }
  Body& body(BodyHandle handle) { return state.bodies[handle]; }
  ShapeHandle shapeOf(BodyHandle handle) { return state.bodies[handle].firstShape; }

  /// Joins `a` to `b` (null: the world) at world anchors.
  JointHandle join(JointType type, BodyHandle a, BodyHandle b, const Vec3& anchor, const Vec3& axis = Vec3::UnitY(),
                   const Vec3& anchorB = Vec3::Zero()) {
    const Transform poseA = body(a).pose;
    const Transform poseB = b ? body(b).pose : Transform{};
    Joint joint;
    joint.type = type;
    joint.a = shapeOf(a);
    if (b) joint.b = shapeOf(b);
    joint.localAnchorA = poseA.toLocal(anchor);
    joint.localAnchorB = poseB.toLocal(type == JointType::Rope ? anchorB : anchor);
    joint.localAxisA = poseA.unrotate(axis);
    joint.localAxisB = poseB.unrotate(axis);
    joint.referenceRotation = poseA.rotation.conjugate() * poseB.rotation;
    joint.length = (anchor - anchorB).norm();
    return state.joints.insert(joint);
  }
  Joint& joint(JointHandle handle) { return state.joints[handle]; }
  DriveHandle drive(const DriveDef& def) { return state.drives.insert({def}); }

  /// Distance of a joint's anchors. [m]
  float gap(JointHandle handle) {
    const Joint& j = joint(handle);
    const Transform a = state.bodyOf(state.shapes[j.a]).pose;
    const Transform b = j.b ? state.bodyOf(state.shapes[j.b]).pose : Transform{};
    return (a.toWorld(j.localAnchorA) - b.toWorld(j.localAnchorB)).norm();
  }
  float widestGap() {
    float widest = 0.0f;
    state.joints.forEach([&](JointHandle handle, Joint&) { widest = maxOf(widest, gap(handle)); });
    return widest;
  }

  void step() {
    integrateVelocities();
    JointSolver& joints = state.jointSolver;
    joints.prepare(state, dt);
    state.driveSolver.prepare(state, dt);
    joints.warmStart(state.solverBodies.data());
    for (int i = 0; i < iterations; ++i) {
      joints.solve(state.solverBodies.data());
      state.driveSolver.solve(state.solverBodies.data());
    }
    joints.store(state);
    integratePositions();
    for (int i = 0; i < positionIterations; ++i) joints.correctPositions(state);
    state.bodies.forEach([](BodyHandle, Body& b) { refresh(b); });
    ++state.tick;
  }
  void run(float seconds) {
    const int ticks = static_cast<int>(seconds / dt + 0.5f);
    for (int i = 0; i < ticks; ++i) step();
  }

  double kineticEnergy() const {
    double sum = 0.0;
    state.bodies.forEach([&](BodyHandle, const Body& b) {
      const Vec3d w = b.pose.rotation.conjugate().cast<double>() * b.angularVelocity.cast<double>();
      sum += 0.5 * b.mass * b.velocity.cast<double>().squaredNorm() + 0.5 * w.dot(b.localInertia.cast<double>() * w);
    });
    return sum;
  }
  double energy() const {
    double sum = kineticEnergy();
    state.bodies.forEach(
        [&](BodyHandle, const Body& b) { sum -= b.mass * state.gravity.cast<double>().dot(b.center.cast<double>()); });
    return sum;
  }
  Vec3d momentum() const {
    Vec3d sum = Vec3d::Zero();
    state.bodies.forEach([&](BodyHandle, const Body& b) { sum += b.mass * b.velocity.cast<double>(); });
    return sum;
  }
  Vec3d angularMomentum() const {
    Vec3d sum = Vec3d::Zero();
    state.bodies.forEach([&](BodyHandle, const Body& b) {
      sum += b.center.cast<double>().cross(Vec3d(b.mass * b.velocity.cast<double>()));
      sum += b.pose.rotation.cast<double>() *
             (b.localInertia.cast<double>() *
              (b.pose.rotation.conjugate().cast<double>() * b.angularVelocity.cast<double>()));
    });
    return sum;
  }

 private:
  static void refresh(Body& b) {
    const Mat3 rotation = b.pose.rotation.toRotationMatrix();
    b.invInertia = rotation * b.localInvInertia * rotation.transpose();
  }
  /// One Newton step of I (w' - w) + dt w' x I w' = 0 in the body's frame. Source: Catto, Numerical Methods (GDC),
  /// 2015.
  void turnFreely(Body& b) const {
    const Vec3 w = b.pose.rotation.conjugate() * b.angularVelocity;
    const Vec3 spin = b.localInertia * w;
    const Mat3 slope = b.localInertia + dt * (crossMatrix(w) * b.localInertia - crossMatrix(spin));
    const Vec3 rows[3] = {slope.row(0), slope.row(1), slope.row(2)};
    const Vec3 right = dt * w.cross(spin);
    // The inverse's columns are the cross products of the rows over the determinant.
    const Vec3 change =
        (rows[1].cross(rows[2]) * right.x() + rows[2].cross(rows[0]) * right.y() + rows[0].cross(rows[1]) * right.z()) /
        rows[0].dot(rows[1].cross(rows[2]));
    b.angularVelocity = b.pose.rotation * Vec3(w - change);
  }
  void integrateVelocities() {
    state.solverBodies.assign(state.bodies.capacity(), SolverBody{});
    state.bodies.forEach([&](BodyHandle handle, Body& b) {
      if (b.isDynamic()) turnFreely(b);
      if (b.isDynamic()) b.velocity += state.gravity * (b.gravityScale * dt);
      SolverBody& s = state.solverBodies[handle.index];
      s.velocity = b.velocity;
      s.angularVelocity = b.angularVelocity;
      s.center = b.center;
      s.invMass = b.isDynamic() ? b.invMass : 0.0f;
      if (b.isDynamic()) s.invInertia = b.invInertia;
    });
  }
  void integratePositions() {
    state.bodies.forEach([&](BodyHandle handle, Body& b) {
      const SolverBody& s = state.solverBodies[handle.index];
      b.velocity = s.velocity;
      b.angularVelocity = s.angularVelocity;
      b.center += b.velocity * dt;
      b.pose.rotation = integrateRotation(b.pose.rotation, b.angularVelocity, dt);
      b.placeByCenter();
    });
  }
};

}  // namespace brittle::physics::test
