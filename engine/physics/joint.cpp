// The velocity solver of joints: rows prepared once, iterated on, remembered for the next tick.
//
// Anchors turn with their bodies within a tick. Holding J v = 0 with the arms of the tick's beginning would throw away
// the part of the velocity that turns with them: a pendulum would lose w^2 dt/2 of its speed per second and its anchor
// would drift by w^2 r dt^2/2 per tick. So the rows hold the mean velocity over the tick instead: with the rotation
// vector t = w dt,
//   (R(t) r - r) / dt = w x r + (dt/2) w x (w x r) + O(dt^2),
// and the second term is the row's bias c. Impulses still act along the arms of the beginning, halfway between the
// velocities before and after, which makes the method symmetric in time, so that energy does not drift to second order.
// Where motion is not smooth (a whip's crack, a blow) that would add energy: impulses p between the relative speeds u
// before the tick and -c after it do the work p . (u - c) / 2 = -(u K^-1 u - c K^-1 c) / 2, so c is never let grow
// longer than u. Source: Hairer, Lubich, Wanner, Geometric Numerical Integration, 2006, VII.1.4 (SHAKE and RATTLE).
#include "engine/physics/joint.h"

#include <cmath>

#include "engine/physics/state.h"

namespace brittle::physics {

namespace {

constexpr float kUnbounded = 3.0e38f;

SolverBody& bodyAt(SolverBody* bodies, std::uint32_t slot, SolverBody& world) {
  return slot == kWorldBody ? world : bodies[slot];
}

/// How far the velocity of the tip of `arm` turns within half a tick; bounded for any spin (the Cayley map's
/// denominator). [m/s]
Vec3 turning(const Vec3& w, const Vec3& arm, float dt) {
  const float scale = 0.5f * dt / (1.0f + 0.25f * dt * dt * w.squaredNorm());
  return w.cross(w.cross(arm)) * scale;
}

Vec3 shortened(const Vec3& v, float longest) {
  const float length = v.norm();
  return length > longest ? Vec3(v * (longest / length)) : v;
}

/// What the rows' speeds lack of the mean over the tick.
void addTurning(const PreparedJoint& joint, const SolverBody& a, const SolverBody& b, float dt, float* speeds) {
  const JointRows& rows = joint.rows;
  if (rows.linearCount == 3) {
    const Vec3 bias = turning(a.angularVelocity, rows.armA, dt) - turning(b.angularVelocity, rows.armB, dt);
    const Vec3 allowed = shortened(bias, joint.mostTurning);
    for (int i = 0; i < 3; ++i) speeds[i] += allowed[i];
  }
  if (rows.count == 5 && rows.linearCount == 3) {  // a hinge: its axis turns with both
    const Vec3 bias =
        rows.axis.cross(turning(a.angularVelocity, rows.axis, dt) - turning(b.angularVelocity, rows.axis, dt));
    const Vec3 allowed = shortened(bias, joint.mostAxisTurning);
    speeds[3] += rows.equalities[3].angularA.dot(allowed);
    speeds[4] += rows.equalities[4].angularA.dot(allowed);
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
  const float bias =
      direction.dot(turning(a.angularVelocity, rows.armA, dt) - turning(b.angularVelocity, rows.armB, dt)) + passing;
  return clampTo(bias, -joint.mostTurning, joint.mostTurning);
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
    prepared.impulse[i] =
        i < prepared.rows.linearCount ? row.linear.dot(joint.linearImpulse) : row.angularA.dot(joint.angularImpulse);
  }
}

/// Between which bodies a joint acts; false if it holds nothing: a shape is gone, or both belong to one body.
bool findBodies(const State& state, const Joint& joint, ActiveJoint& active) {
  const Shape* shapeA = state.shapes.find(joint.a);
  const Shape* shapeB = state.shapes.find(joint.b);
  if (!shapeA || (joint.b && !shapeB) || (shapeB && shapeA->body == shapeB->body)) return false;
  active.bodyA = shapeA->body.index;
  active.bodyB = shapeB ? shapeB->body.index : kWorldBody;
  return true;
}

bool isFree(const State& state, std::uint32_t slot) {
  return slot != kWorldBody && state.bodies.at(slot).isDynamic() && state.bodies.at(slot).awake;
}

/// Rows `first` to `last`: the length of their speeds.
float speedOf(const JointRows& rows, std::uint32_t first, std::uint32_t last, const SolverBody& a,
              const SolverBody& b) {
  float sum = 0.0f;
  for (std::uint32_t i = first; i < last; ++i) {
    const float speed = rows.equalities[i].speed(a, b);
    sum += speed * speed;
  }
  return std::sqrt(sum);
}

void boundTurning(PreparedJoint& joint, const SolverBody& a, const SolverBody& b) {
  const JointRows& rows = joint.rows;
  joint.mostTurning =
      joint.isRope ? maxOf(rows.coordinateRow.speed(a, b), 0.0f) : speedOf(rows, 0, rows.linearCount, a, b);
  joint.mostAxisTurning = speedOf(rows, rows.linearCount, rows.count, a, b);
}

void prepareLimits(const Joint& joint, float dt, PreparedJoint& prepared) {
  const float x = prepared.rows.coordinate;
  BoundedRow* bounded = prepared.bounded;
  prepared.active[kLower] = joint.limited;
  prepared.active[kUpper] = joint.limited || prepared.isRope;
  prepared.active[kMotor] = joint.motor;
  const float upper = prepared.isRope ? joint.length : joint.upper;
  // A limit still away allows the speed that just reaches it; one overrun stops the motion, positions are corrected
  // apart.
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

void prepareBounded(const Joint& joint, float dt, bool warm, const SolverBody& a, const SolverBody& b,
                    PreparedJoint& prepared) {
  prepareLimits(joint, dt, prepared);
  prepared.block.factor(prepared.rows.equalities, prepared.rows.count, a, b);
  for (std::uint32_t kind = 0; kind < kBoundedCount; ++kind) {
    if (!prepared.active[kind]) continue;
    BoundedRow& row = prepared.bounded[kind];
    row.prepare(prepared.rows.coordinateRow, prepared.rows, prepared.block, a, b);
    const float stored = kind == kMotor ? joint.motorImpulse : joint.limitImpulse;
    row.impulse = warm ? clampTo(stored, row.low, row.high) : 0.0f;
  }
}

void solveRow(PreparedJoint& joint, BoundedRow& row, float speedBias, SolverBody& a, SolverBody& b) {
  const float wanted = row.impulse + (row.target - row.row.speed(a, b) - speedBias) * row.mass;
  const float impulse = clampTo(wanted, row.low, row.high) - row.impulse;
  if (impulse == 0.0f) return;
  row.impulse += impulse;
  row.response.apply(a, b, impulse);
  for (std::uint32_t i = 0; i < joint.rows.count; ++i) joint.impulse[i] += row.answer[i] * impulse;
}

void solveBounded(PreparedJoint& joint, SolverBody& a, SolverBody& b, float dt) {
  const float speedBias = joint.isRope ? ropeTurning(joint, a, b, dt) : 0.0f;
  for (std::uint32_t kind = 0; kind < kBoundedCount; ++kind)
    if (joint.active[kind]) solveRow(joint, joint.bounded[kind], speedBias, a, b);
}

void forget(Joint& joint) {
  joint.linearImpulse = Vec3::Zero();
  joint.angularImpulse = Vec3::Zero();
  joint.limitImpulse = 0.0f;
  joint.motorImpulse = 0.0f;
}

}  // namespace

void JointSolver::findActive(const State& state) {
  state.joints.forEach([&](JointHandle handle, const Joint& joint) {
    ActiveJoint active;
    if (!findBodies(state, joint, active)) return;
    if (!isFree(state, active.bodyA) && !isFree(state, active.bodyB)) return;
    active.joint = handle.index;
    active_.push_back(active);
  });
  if (roots_.size() < state.bodies.capacity()) roots_.resize(state.bodies.capacity());
  groupJoints(active_, state.solverBodies.data(), roots_.data(), groups_);
}

void JointSolver::prepare(const State& state, float dt, bool isFirstPass) {
  dt_ = dt;
  active_.clear();
  groups_.clear();
  joints_.clear();
  if (state.joints.size() == 0) return;
  const bool warm = state.accuracy.warmStart || !isFirstPass;
  findActive(state);
  SolverBody world;
  for (const ActiveJoint& active : active_) {
    const Joint& joint = state.joints.at(active.joint);
    const SolverBody& a = state.solverBodies[active.bodyA];
    const SolverBody& b = active.bodyB == kWorldBody ? world : state.solverBodies[active.bodyB];
    joints_.emplace_back();
    PreparedJoint& prepared = joints_.back();
    prepared.joint = active.joint;
    prepared.bodyA = active.bodyA;
    prepared.bodyB = active.bodyB;
    prepared.isRope = joint.type == JointType::Rope;
    prepared.rows = measureJoint(state, joint, active.bodyA, active.bodyB);
    boundTurning(prepared, a, b);
    if (warm) loadEqualities(joint, prepared);
    if (prepared.rows.hasCoordinate) prepareBounded(joint, dt, warm, a, b, prepared);
  }
  if (systems_.size() < groups_.size()) systems_.resize(groups_.size());
  for (std::size_t i = 0; i < groups_.size(); ++i)
    systems_[i].factor(joints_.data() + groups_[i].first, groups_[i].count, state.solverBodies.data());
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

void JointSolver::solveGroup(std::size_t index, SolverBody* bodies) {
  SolverBody world;
  const JointGroup& group = groups_[index];
  PreparedJoint* const first = joints_.data() + group.first;
  residual_.clear();
  for (PreparedJoint* joint = first; joint != first + group.count; ++joint) {
    const SolverBody& a = bodyAt(bodies, joint->bodyA, world);
    const SolverBody& b = bodyAt(bodies, joint->bodyB, world);
    float speeds[kMaxEqualities];
    for (std::uint32_t i = 0; i < joint->rows.count; ++i) speeds[i] = joint->rows.equalities[i].speed(a, b);
    addTurning(*joint, a, b, dt_, speeds);
    for (std::uint32_t i = 0; i < joint->rows.count; ++i) residual_.push_back(-speeds[i]);
  }
  systems_[index].solve(residual_.data());
  const double* next = residual_.data();
  for (PreparedJoint* joint = first; joint != first + group.count; ++joint) {
    float impulse[kMaxEqualities];
    for (std::uint32_t i = 0; i < joint->rows.count; ++i) {
      impulse[i] = static_cast<float>(*next++);
      joint->impulse[i] += impulse[i];
    }
    applyEqualities(joint->rows, impulse, bodyAt(bodies, joint->bodyA, world), bodyAt(bodies, joint->bodyB, world));
  }
}

void JointSolver::solve(SolverBody* bodies) {
  SolverBody world;
  for (std::size_t i = 0; i < groups_.size(); ++i) solveGroup(i, bodies);
  for (PreparedJoint& joint : joints_)
    solveBounded(joint, bodyAt(bodies, joint.bodyA, world), bodyAt(bodies, joint.bodyB, world), dt_);
}

void JointSolver::store(State& state) const {
  state.joints.forEach([&](JointHandle, Joint& joint) {
    ActiveJoint unused;
    if (!findBodies(state, joint, unused)) forget(joint);
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
