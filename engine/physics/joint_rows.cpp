// The factorisation, and the rows of each type of joint.
#include "engine/physics/joint_rows.h"

#include "engine/physics/state.h"

namespace brittle::physics {

namespace {

// A pivot below this fraction of its row's own inverse mass is rounding: the row depends on those before it. [-]
constexpr float kDependent = 2e-6f;

void addLinear(JointRows& rows, const Vec3& direction, const Vec3& armA, const Vec3& armB, float error) {
  rows.equalities[rows.count] = {direction, armA.cross(direction), armB.cross(direction)};
  rows.error[rows.count++] = error;
  ++rows.linearCount;
}

void addAngular(JointRows& rows, const Vec3& direction, float error) {
  rows.equalities[rows.count] = {Vec3::Zero(), direction, direction};
  rows.error[rows.count++] = error;
}

/// How A is turned away from where B and the reference want it, as a rotation in the world.
Quat rotationError(const Joint& joint, const Quat& a, const Quat& b) {
  const Quat wanted = b * joint.referenceRotation.conjugate();
  Quat error = a * wanted.conjugate();
  if (error.w() < 0.0f) error.coeffs() = -error.coeffs();
  return error;
}

void lockRotation(JointRows& rows, const Quat& error) {
  const Vec3 angles = 2.0f * error.vec();
  for (int i = 0; i < 3; ++i) addAngular(rows, Vec3::Unit(i), angles[i]);
}

/// The angle about `axis`, in the turn about the middle of the limits so that overshooting one never jumps to the
/// other.
float hingeAngle(const Joint& joint, const Quat& error, const Vec3& axis) {
  float angle = 2.0f * arcTangent(error.vec().dot(axis), error.w());
  const float middle = joint.limited ? 0.5f * (joint.lower + joint.upper) : 0.0f;
  if (angle > middle + kPi) angle -= 2.0f * kPi;
  if (angle < middle - kPi) angle += 2.0f * kPi;
  return angle;
}

void measureHinge(const Joint& joint, const Quat& a, const Quat& b, JointRows& rows) {
  const Vec3 axisA = a * joint.localAxisA;
  const Vec3 axisB = b * joint.localAxisB;
  const Vec3 n1 = perpendicular(axisB);
  const Vec3 n2 = axisB.cross(n1);
  const Vec3 error = axisB.cross(axisA);
  addAngular(rows, n1, n1.dot(error));
  addAngular(rows, n2, n2.dot(error));
  rows.axis = axisB;
  rows.hasCoordinate = true;
  rows.coordinateRow = {Vec3::Zero(), axisB, axisB};
  rows.coordinate = hingeAngle(joint, rotationError(joint, a, b), axisB);
}

/// B is the rail: A's anchor is seen as a point of B, wherever it has slid to.
void measureSlider(const Joint& joint, const Transform& poseA, const Transform& poseB, const Vec3& between,
                   JointRows& rows) {
  const Vec3 axis = poseB.rotate(joint.localAxisB);
  const Vec3 n1 = perpendicular(axis);
  const Vec3 n2 = axis.cross(n1);
  const Vec3 railArm = rows.armB + between;
  addLinear(rows, n1, rows.armA, railArm, n1.dot(between));
  addLinear(rows, n2, rows.armA, railArm, n2.dot(between));
  lockRotation(rows, rotationError(joint, poseA.rotation, poseB.rotation));
  rows.hasCoordinate = true;
  rows.coordinateRow = {axis, rows.armA.cross(axis), railArm.cross(axis)};
  rows.coordinate = axis.dot(between);
}

}  // namespace

float inverseMassBetween(const JointRow& row, const JointRow& other, const SolverBody& a, const SolverBody& b) {
  const Vec3 turnA = a.invInertia * other.angularA;
  const Vec3 turnB = b.invInertia * other.angularB;
  return (row.linear.dot(other.linear) * (a.invMass + b.invMass) + row.angularA.dot(turnA)) + row.angularB.dot(turnB);
}

void EqualityBlock::factor(const JointRow* rows, std::uint32_t count, const SolverBody& a, const SolverBody& b) {
  count_ = count;
  float diagonal[kMaxEqualities];
  for (std::uint32_t j = 0; j < count; ++j) {
    const float own = inverseMassBetween(rows[j], rows[j], a, b);
    float pivot = own;
    for (std::uint32_t k = 0; k < j; ++k) pivot -= lower_[j][k] * lower_[j][k] * diagonal[k];
    const bool isFree = pivot > kDependent * own;
    diagonal[j] = isFree ? pivot : 0.0f;
    inverseDiagonal_[j] = isFree ? 1.0f / pivot : 0.0f;
    for (std::uint32_t i = j + 1; i < count; ++i) {
      float value = inverseMassBetween(rows[i], rows[j], a, b);
      for (std::uint32_t k = 0; k < j; ++k) value -= lower_[i][k] * lower_[j][k] * diagonal[k];
      lower_[i][j] = value * inverseDiagonal_[j];
    }
  }
}

void EqualityBlock::solve(float* values) const {
  for (std::uint32_t i = 0; i < count_; ++i)
    for (std::uint32_t k = 0; k < i; ++k) values[i] -= lower_[i][k] * values[k];
  for (std::uint32_t i = 0; i < count_; ++i) values[i] *= inverseDiagonal_[i];
  for (std::uint32_t i = count_; i-- > 0;)
    for (std::uint32_t k = i + 1; k < count_; ++k) values[i] -= lower_[k][i] * values[k];
}

void BoundedRow::prepare(const JointRow& from, const JointRows& rows, const EqualityBlock& block, const SolverBody& a,
                         const SolverBody& b) {
  row = from;
  response = from;
  for (std::uint32_t i = 0; i < rows.count; ++i) answer[i] = inverseMassBetween(rows.equalities[i], from, a, b);
  block.solve(answer);
  for (std::uint32_t i = 0; i < rows.count; ++i) {
    answer[i] = -answer[i];
    response.add(rows.equalities[i], answer[i]);
  }
  const float own = inverseMassBetween(row, row, a, b);
  const float left = inverseMassBetween(row, response, a, b);
  mass = left > kDependent * own ? 1.0f / left : 0.0f;
}

JointRows measureJoint(const State& state, const Joint& joint, std::uint32_t bodyA, std::uint32_t bodyB) {
  JointRows rows;
  const Transform& poseA = state.bodies.at(bodyA).pose;
  const Transform poseB = bodyB == kWorldBody ? Transform{} : state.bodies.at(bodyB).pose;
  const Vec3 centerB = bodyB == kWorldBody ? Vec3(Vec3::Zero()) : state.bodies.at(bodyB).center;
  const Vec3 anchorA = poseA.toWorld(joint.localAnchorA);
  const Vec3 anchorB = poseB.toWorld(joint.localAnchorB);
  rows.armA = anchorA - state.bodies.at(bodyA).center;
  rows.armB = anchorB - centerB;
  const Vec3 between = anchorA - anchorB;
  switch (joint.type) {
    case JointType::Rope: {
      const Vec3 direction = normalizedOr(between, Vec3::UnitY());
      rows.hasCoordinate = true;
      rows.coordinateRow = {direction, rows.armA.cross(direction), rows.armB.cross(direction)};
      rows.coordinate = between.norm();
      break;
    }
    case JointType::Slider:
      measureSlider(joint, poseA, poseB, between, rows);
      break;
    default:
      for (int i = 0; i < 3; ++i) addLinear(rows, Vec3::Unit(i), rows.armA, rows.armB, between[i]);
      if (joint.type == JointType::Hinge) measureHinge(joint, poseA.rotation, poseB.rotation, rows);
      if (joint.type == JointType::Weld) lockRotation(rows, rotationError(joint, poseA.rotation, poseB.rotation));
  }
  return rows;
}

}  // namespace brittle::physics
