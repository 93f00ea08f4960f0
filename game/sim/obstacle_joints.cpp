// The calls of obstacle scripts that join bodies.
#include "engine/physics/world.h"
#include "game/sim/obstacle_api.h"
#include "game/sim/room.h"

namespace brittle::sim {

namespace {

/// Bodies of arguments 1 and 2, either of which may be 0 for the world; then A is the one that is not.
bool readEnds(script::Call& call, Obstacle& obstacle, physics::BodyHandle& a, physics::BodyHandle& b, bool& swapped) {
  const ScriptBody* first = call.integer(1) == 0 ? nullptr : readBody(call, obstacle, 1);
  const ScriptBody* second = call.integer(2) == 0 ? nullptr : readBody(call, obstacle, 2);
  if (call.failed()) return false;
  a = first != nullptr ? currentBody(obstacle, *first) : physics::BodyHandle{};
  b = second != nullptr ? currentBody(obstacle, *second) : physics::BodyHandle{};
  swapped = !a;
  if (swapped) std::swap(a, b);
  if (!a) call.fail("expected at least one body that has a shape");
  if (a && a == b) call.fail("expected two bodies, got one twice");
  return !call.failed();
}

void create(script::Call& call, Obstacle& obstacle, physics::JointDef def, physics::BodyHandle a,
            physics::BodyHandle b) {
  physics::World& world = obstacle.room->world();
  if (obstacle.joints.size() >= rules::kMaxBodiesPerObstacle) return refuseMore(call, obstacle, "too many joints");
  def.a = world.body(a).firstShape;  // the world picks the shape of the body that holds the anchor
  if (b) def.b = world.body(b).firstShape;
  if (!def.a) return call.fail("a joint needs a body with a shape");
  obstacle.room->demand(effects::Effect::Joints, call.where());
  const bool runs = obstacle.room->runs(effects::Effect::Joints);
  obstacle.joints.push_back(runs ? world.createJoint(def) : physics::JointHandle{});
  call.result(static_cast<int>(obstacle.joints.size()));
}

template <physics::JointType type>
void createPlain(script::Call& call, Obstacle& obstacle) {
  physics::BodyHandle a, b;
  bool swapped = false;
  const Vec3 point = readVector(call, 3, rules::kFarthest);
  const Vec3 axis = readVector(call, 6, rules::kFarthest, Vec3::UnitY());
  if (!readEnds(call, obstacle, a, b, swapped)) return;
  physics::JointDef def;
  def.type = type;
  def.anchorA = def.anchorB = obstacle.pose().toWorld(point);
  def.axis = obstacle.pose().rotate(normalizedOr(axis, Vec3::UnitY()));
  create(call, obstacle, def, a, b);
}

void createRope(script::Call& call, Obstacle& obstacle) {
  physics::BodyHandle a, b;
  bool swapped = false;
  const Vec3 from = readVector(call, 3, rules::kFarthest);
  const Vec3 to = readVector(call, 6, rules::kFarthest);
  const float stretch = call.real(9, 0.0f);
  if (!readEnds(call, obstacle, a, b, swapped)) return;
  physics::JointDef def;
  def.type = physics::JointType::Rope;
  def.anchorA = obstacle.pose().toWorld(swapped ? to : from);
  def.anchorB = obstacle.pose().toWorld(swapped ? from : to);
  def.length = maxOf(0.01f, (from - to).norm() * (1.0f + clampTo(stretch, -0.9f, 10.0f)));
  create(call, obstacle, def, a, b);
}

/// The parameter given to the joint, or null with the call failed.
const physics::JointHandle* readJoint(script::Call& call, Obstacle& obstacle) {
  const int number = call.integer(1);
  if (call.failed()) return nullptr;
  if (number >= 1 && number <= static_cast<int>(obstacle.joints.size()))
    return &obstacle.joints[static_cast<std::size_t>(number) - 1];
  call.fail("no joint " + std::to_string(number));
  return nullptr;
}

void getJointBodies(script::Call& call, Obstacle& obstacle) {
  const physics::JointHandle* joint = readJoint(call, obstacle);
  if (joint == nullptr) return;
  const physics::World& world = obstacle.room->world();
  int numbers[2] = {0, 0};
  if (world.isAlive(*joint)) {
    const physics::Joint state = world.joint(*joint);
    numbers[0] = obstacle.numberOf(world.bodyOf(state.a));
    if (state.b) numbers[1] = obstacle.numberOf(world.bodyOf(state.b));
  }
  call.result(numbers[0]);
  call.result(numbers[1]);
}

void isConnected(script::Call& call, Obstacle& obstacle) {
  const ScriptBody* first = readBody(call, obstacle, 1);
  const ScriptBody* second = readBody(call, obstacle, 2);
  if (call.failed()) return;
  const physics::World& world = obstacle.room->world();
  const physics::BodyHandle a = currentBody(obstacle, *first);
  const physics::BodyHandle b = currentBody(obstacle, *second);
  call.charge(10 * static_cast<std::int64_t>(obstacle.joints.size()));
  bool connected = a && a == b;
  for (const physics::JointHandle joint : obstacle.joints) {
    if (!world.isAlive(joint) || !world.joint(joint).b) continue;
    const physics::BodyHandle c = world.bodyOf(world.joint(joint).a);
    const physics::BodyHandle d = world.bodyOf(world.joint(joint).b);
    connected = connected || (c == a && d == b) || (c == b && d == a);
  }
  call.result(connected);
}

}  // namespace

void addJointCalls(script::Library& library) {
  addCall(library, "mgCreateHingeJoint", createPlain<physics::JointType::Hinge>);
  addCall(library, "mgCreateBallJoint", createPlain<physics::JointType::Ball>);
  addCall(library, "mgCreateSliderJoint", createPlain<physics::JointType::Slider>);
  addCall(library, "mgCreateRope", createRope);
  addCall(library, "mgGetJointBodies", getJointBodies);
  addCall(library, "mgIsConnected", isConnected);
}

}  // namespace brittle::sim
