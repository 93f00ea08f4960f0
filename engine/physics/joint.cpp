// The velocity solver of joints: rows prepared once, iterated on, remembered for the next tick.
//
// Anchors turn with their bodies within a tick. Holding J v = 0 with the arms of the tick's beginning would throw away the part of
// the velocity that turns with them: a pendulum would lose w^2 dt/2 of its speed per second and its anchor would drift by
// w^2 r dt^2/2 per tick. So the rows hold the mean velocity over the tick instead: with the rotation vector t = w dt,
//   (R(t) r - r) / dt = w x r + (dt/2) w x (w x r) + O(dt^2),
// and the second term is the row's bias. Impulses still act along the arms of the beginning, halfway between the velocities
// before and after, which makes the method symmetric in time, so that energy does not drift to second order.
// Source: Hairer, Lubich, Wanner, Geometric Numerical Integration, 2006, VII.1.4 (SHAKE and RATTLE).
#include "engine/physics/joint.h"

#include "engine/physics/state.h"

namespace brittle::physics {

namespace {

constexpr float kUnbounded = 3.0e38f;

SolverBody& bodyAt(SolverBody* bodies, std::uint32_t slot, SolverBody& world) {
  return slot == kWorldBody ? world : bodies[slot];
}

/// How far the velocity of the tip of `arm` turns within half a tick; bounded for any spin (the Cayley map's denominator). [m/s]
Vec3 turning(const Vec3& w, const Vec3& arm, float dt) {
  const float scale = 0.5f * dt / (1.0f + 0.25f * dt * dt * w.squaredNorm());
  return w.cross(w.cross(arm)) * scale;
}

/// What the rows' speeds lack of the mean over the tick.
void addTurning(const PreparedJoint& joint, const SolverBody& a, const SolverBody& b, float dt, float* speeds) {
  const JointRows& rows = joint.rows;
  if (rows.linearCount == 3) {
    const Vec3 bias = turning(a.angularVelocity, rows.armA, dt) - turning(b.angularVelocity, rows.armB, dt);
    for (int i = 0; i < 3; ++i) speeds[i] += bias[i];
  }
  if (rows.count == 5 && rows.linearCount == 3) {  // a hinge: its axis turns with both
    const Vec3 bias = rows.axis.cross(turning(a.angularVelocity, rows.axis, dt) - turning(b.angularVelocity, rows.axis, dt));
    speeds[3] += rows.equalities[3].angularA.dot(bias);
    speeds[4] += rows.equalities[4].angularA.dot(bias);
  }
}

/// The same for the distance of a rope's anchors, which also grows by going past each other.
float ropeTurning(const PreparedJoint& joint, const SolverBody& a, const SolverBody& b, float dt) {
  const JointRows& rows = joint.rows;
  const Vec3& direction = rows.coordinateRow.linear;
  const Vec3 speed = a.velocityAt(rows.armA) - b.velocityAt(rows.armB);
  const Vec3 across = speed - direction * direction.dot(speed);
  const float distance = maxOf(rows.coordinate, 1e-6f);
  const float turned = across.squaredNorm() * dt * dt / (distance * distance);
  const float passing = 0.5f * turned * distance / (dt * (1.0f + 0.25f * turned));
  return direction.dot(turning(a.angularVelocity, rows.armA, dt) - turning(b.angularVelocity, rows.armB, dt)) + passing;
}

/// Impulses on both bodies, summed over the equality rows.
void applyEqualities(const JointRows& rows, const float* impulse, SolverBody& a, SolverBody& b) {
  JointRow sum;
  for (std::uint32_t i = 0; i < rows.count; ++i) sum.add(rows.equalities[i], impulse[i]);
  sum.apply(a, b, 1.0f);
}

void loadEqualities(const Joint& joint, PreparedJoint& prepared) {
  for (std::uint32_t i = 0; i < prepared.rows.count; ++i) {
    const JointRow& row = prepared.rows.equalities[i];
    prepared.impulse[i] = i < prepared.rows.linearCount ? row.linear.dot(joint.linearImpulse)
                                                        : row.angularA.dot(joint.angularImpulse);
  }
}

/// Where the two bodies of a joint are; false if it holds nothing: a shape is gone, or both belong to one body.
bool findBodies(const State& state, const Joint& joint, const Body*& a, const Body*& b, PreparedJoint& prepared) {
  const Shape* shapeA = state.shapes.find(joint.a);
  const Shape* shapeB = state.shapes.find(joint.b);
  if (!shapeA || (joint.b && !shapeB) || (shapeB && shapeA->body == shapeB->body)) return false;
  a = &state.bodies[shapeA->body];
  b = shapeB ? &state.bodies[shapeB->body] : nullptr;
  prepared.bodyA = shapeA->body.index;
  prepared.bodyB = shapeB ? shapeB->body.index : kWorldBody;
  return true;
}

bool movesBySolver(const Body* body) { return body && body->isDynamic() && body->awake; }

void prepareLimits(const Joint& joint, float dt, PreparedJoint& prepared) {
  const float x = prepared.rows.coordinate;
  BoundedRow* bounded = prepared.bounded;
  prepared.active[kLower] = joint.limited;
  prepared.active[kUpper] = joint.limited || prepared.isRope;
  prepared.active[kMotor] = joint.motor;
  const float upper = prepared.isRope ? joint.length : joint.upper;
  // A limit still away allows the speed that just reaches it; one overrun stops the motion, positions are corrected apart.
  bounded[kLower].target = -maxOf(x - joint.lower, 0.0f) / dt;
  bounded[kLower].low = 0.0f;
  bounded[kLower].high = kUnbounded;
  bounded[kUpper].target = maxOf(upper - x, 0.0f) / dt;
  bounded[kUpper].low = -kUnbounded;
  bounded[kUpper].high = 0.0f;
  bounded[kMotor].target = joint.motorSpeed;
  bounded[kMotor].low = -joint.motorLimit * dt;
  bounded[kMotor].high = joint.motorLimit * dt;
}

void prepareBounded(const Joint& joint, float dt, bool warm, const SolverBody& a, const SolverBody& b, PreparedJoint& prepared) {
  prepareLimits(joint, dt, prepared);
  for (std::uint32_t kind = 0; kind < kBoundedCount; ++kind) {
    if (!prepared.active[kind]) continue;
    BoundedRow& row = prepared.bounded[kind];
    row.prepare(prepared.rows.coordinateRow, prepared.rows, prepared.block, a, b);
    const float stored = kind == kMotor ? joint.motorImpulse : joint.limitImpulse;
    row.impulse = warm ? clampTo(stored, row.low, row.high) : 0.0f;
  }
}

void solveBounded(PreparedJoint& joint, BoundedRow& row, float speedBias, SolverBody& a, SolverBody& b) {
  const float wanted = row.impulse + (row.target - row.row.speed(a, b) - speedBias) * row.mass;
  const float impulse = clampTo(wanted, row.low, row.high) - row.impulse;
  if (impulse == 0.0f) return;
  row.impulse += impulse;
  row.response.apply(a, b, impulse);
  for (std::uint32_t i = 0; i < joint.rows.count; ++i) joint.impulse[i] += row.answer[i] * impulse;
}

void solveJoint(PreparedJoint& joint, float dt, SolverBody& a, SolverBody& b) {
  const JointRows& rows = joint.rows;
  if (rows.count > 0) {
    float impulse[kMaxEqualities];
    for (std::uint32_t i = 0; i < rows.count; ++i) impulse[i] = rows.equalities[i].speed(a, b);
    addTurning(joint, a, b, dt, impulse);
    joint.block.solve(impulse);
    for (std::uint32_t i = 0; i < rows.count; ++i) {
      impulse[i] = -impulse[i];
      joint.impulse[i] += impulse[i];
    }
    applyEqualities(rows, impulse, a, b);
  }
  const float speedBias = joint.isRope ? ropeTurning(joint, a, b, dt) : 0.0f;
  for (std::uint32_t kind = 0; kind < kBoundedCount; ++kind)
    if (joint.active[kind]) solveBounded(joint, joint.bounded[kind], speedBias, a, b);
}

void forget(Joint& joint) {
  joint.linearImpulse = Vec3::Zero();
  joint.angularImpulse = Vec3::Zero();
  joint.limitImpulse = 0.0f;
  joint.motorImpulse = 0.0f;
}

}  // namespace

void JointSolver::prepare(const State& state, float dt, bool isFirstRound) {
  joints_.clear();
  dt_ = dt;
  backwards_ = false;
  const bool warm = state.accuracy.warmStart || !isFirstRound;
  SolverBody world;
  state.joints.forEach([&](JointHandle handle, const Joint& joint) {
    PreparedJoint prepared;
    const Body* a = nullptr;
    const Body* b = nullptr;
    if (!findBodies(state, joint, a, b, prepared) || (!movesBySolver(a) && !movesBySolver(b))) return;
    prepared.joint = handle.index;
    prepared.isRope = joint.type == JointType::Rope;
    prepared.rows = measureJoint(joint, a->pose, a->center, b ? b->pose : Transform{}, b ? b->center : Vec3(Vec3::Zero()));
    const SolverBody& solverA = state.solverBodies[prepared.bodyA];
    const SolverBody& solverB = b ? state.solverBodies[prepared.bodyB] : world;
    prepared.block.factor(prepared.rows.equalities, prepared.rows.count, solverA, solverB);
    if (warm) loadEqualities(joint, prepared);
    if (prepared.rows.hasCoordinate) prepareBounded(joint, dt, warm, solverA, solverB, prepared);
    joints_.push_back(prepared);
  });
  prepareDrives(state, dt, isFirstRound);
}

void JointSolver::warmStart(SolverBody* bodies) const {
  SolverBody world;
  for (const PreparedJoint& joint : joints_) {
    SolverBody& a = bodyAt(bodies, joint.bodyA, world);
    SolverBody& b = bodyAt(bodies, joint.bodyB, world);
    // Stored equality impulses hold what they answered to the bounded rows, so those act along their own row here.
    applyEqualities(joint.rows, joint.impulse, a, b);
    for (std::uint32_t kind = 0; kind < kBoundedCount; ++kind)
      if (joint.active[kind]) joint.bounded[kind].row.apply(a, b, joint.bounded[kind].impulse);
  }
}

void JointSolver::solve(SolverBody* bodies) {
  SolverBody world;
  // Chains: forwards and backwards in turn, so that a pull reaches both ends equally fast.
  const std::size_t count = joints_.size();
  for (std::size_t i = 0; i < count; ++i) {
    PreparedJoint& joint = joints_[backwards_ ? count - 1 - i : i];
    solveJoint(joint, dt_, bodyAt(bodies, joint.bodyA, world), bodyAt(bodies, joint.bodyB, world));
  }
  backwards_ = !backwards_;
  for (PreparedDrive& drive : drives_) solveDrive(drive, bodies[drive.body.index]);
}

void JointSolver::store(State& state) const {
  state.joints.forEach([&](JointHandle, Joint& joint) {
    PreparedJoint unused;
    const Body* a = nullptr;
    const Body* b = nullptr;
    if (!findBodies(state, joint, a, b, unused)) forget(joint);
  });
  for (const PreparedJoint& prepared : joints_) {
    if (!state.joints.isAlive(prepared.joint)) continue;
    Joint& joint = state.joints.at(prepared.joint);
    forget(joint);
    for (std::uint32_t i = 0; i < prepared.rows.count; ++i) {
      const JointRow& row = prepared.rows.equalities[i];
      if (i < prepared.rows.linearCount)
        joint.linearImpulse += row.linear * prepared.impulse[i];
      else
        joint.angularImpulse += row.angularA * prepared.impulse[i];
    }
    if (prepared.active[kLower]) joint.limitImpulse += prepared.bounded[kLower].impulse;
    if (prepared.active[kUpper]) joint.limitImpulse += prepared.bounded[kUpper].impulse;
    if (prepared.active[kMotor]) joint.motorImpulse = prepared.bounded[kMotor].impulse;
  }
}

bool jointForbidsCollision(const State& state, BodyHandle a, BodyHandle b) {
  if (state.joints.size() == 0) return false;
  bool forbidden = false;
  state.joints.forEach([&](JointHandle, const Joint& joint) {
    if (joint.collideConnected || forbidden) return;
    const Shape* shapeA = state.shapes.find(joint.a);
    const Shape* shapeB = state.shapes.find(joint.b);
    if (!shapeA || !shapeB) return;
    forbidden = (shapeA->body == a && shapeB->body == b) || (shapeA->body == b && shapeB->body == a);
  });
  return forbidden;
}

}  // namespace brittle::physics
