// The calls of obstacle scripts that move bodies: drives towards a pose, and velocities.
#include <vector>

#include "engine/physics/world.h"
#include "game/sim/obstacle_api.h"
#include "game/sim/room.h"

namespace brittle::sim {

namespace {

/// An animated body goes where it is told, no faster than the drive allows.
void animate(Obstacle& obstacle, const ScriptBody& body) {
  physics::World& world = obstacle.room->world();
  const physics::BodyHandle handle = currentBody(obstacle, body);
  if (!handle) return;
  const Transform now = world.body(handle).pose;
  const ScriptDrive& drive = body.drive;
  Transform target = now;
  if (drive.moves) {
    const Vec3 way = obstacle.pose().toWorld(drive.position) - now.position;
    const float most = drive.maxSpeed * rules::kTickSeconds;
    const float length = way.norm();
    target.position = length > most ? Vec3(now.position + way * (most / length)) : Vec3(now.position + way);
  }
  if (drive.turns) {
    const Quat wanted = obstacle.pose().rotation * drive.rotation;
    Quat turn = wanted * now.rotation.conjugate();
    if (turn.w() < 0.0f) turn.coeffs() = -turn.coeffs();
    const float angle = 2.0f * arcCosine(turn.w());
    const float most = drive.maxAngularSpeed * rules::kTickSeconds;
    const Vec3 axis = normalizedOr(turn.vec(), Vec3::UnitY());
    target.rotation = angle > most ? Quat((rotationAbout(axis, most) * now.rotation).normalized()) : wanted;
  }
  world.animate(body.assembly, target);
}

/// A dynamic body is pulled softly: it can be knocked out of its way.
void pull(Obstacle& obstacle, ScriptBody& body, const std::string& who) {
  physics::World& world = obstacle.room->world();
  ScriptDrive& drive = body.drive;
  physics::DriveDef def;
  def.assembly = body.assembly;
  def.drivePosition = drive.moves;
  def.position = obstacle.pose().toWorld(drive.position);
  def.driveRotation = drive.turns;
  def.rotation = obstacle.pose().rotation * drive.rotation;
  def.strength = drive.strength;
  def.maxSpeed = drive.maxSpeed;
  def.maxAngularSpeed = drive.maxAngularSpeed;
  if (drive.handle) {
    world.setDrive(drive.handle, def);
    return;
  }
  obstacle.room->demand(effects::Effect::Drives, who);
  if (obstacle.room->runs(effects::Effect::Drives)) drive.handle = world.createDrive(def);
}

void apply(script::Call& call, Obstacle& obstacle, ScriptBody& body) {
  const physics::World& world = obstacle.room->world();
  const physics::BodyHandle handle = currentBody(obstacle, body);
  if (!handle) return;
  call.charge(100);  // what it belongs to is looked for among all bodies
  const physics::BodyType type = world.body(handle).type;
  if (type == physics::BodyType::Animated) animate(obstacle, body);
  if (type == physics::BodyType::Dynamic) pull(obstacle, body, call.where());
}

void move(script::Call& call, Obstacle& obstacle) {
  ScriptBody* body = readBody(call, obstacle, 1);
  const Vec3 position = readVector(call, 2, rules::kFarthest);
  const float strength = call.real(5, 100.0f);
  const float maxSpeed = call.real(6, 50.0f);
  if (call.failed()) return;
  body->drive.moves = true;
  body->drive.position = position;
  body->drive.strength = clampTo(strength, 0.001f, 1000.0f);
  body->drive.maxSpeed = clampTo(maxSpeed, 0.0f, 100.0f);
  apply(call, obstacle, *body);
}

void rotate(script::Call& call, Obstacle& obstacle) {
  ScriptBody* body = readBody(call, obstacle, 1);
  const Vec3 angles = readVector(call, 2, rules::kMostAngle);
  const float strength = call.real(5, 100.0f);
  const float maxSpeed = call.real(6, 50.0f);
  if (call.failed()) return;
  body->drive.turns = true;
  body->drive.rotation = rotationXyz(angles);
  body->drive.strength = clampTo(strength, 0.001f, 1000.0f);
  body->drive.maxAngularSpeed = clampTo(maxSpeed, 0.0f, 100.0f);
  apply(call, obstacle, *body);
}

void releaseMotion(script::Call& call, Obstacle& obstacle) {
  ScriptBody* body = readBody(call, obstacle, 1);
  if (call.failed()) return;
  if (body->drive.handle) obstacle.room->world().destroyDrive(body->drive.handle);
  body->drive = ScriptDrive{};
}

/// Of the body alone, not of what has broken off: mgGetShapeBody names the body that holds a certain shape.
template <bool angular>
void setVelocity(script::Call& call, Obstacle& obstacle) {
  ScriptBody* body = readBody(call, obstacle, 1);
  const Vec3 value = readVector(call, 2, rules::kMostSpeed);
  if (call.failed()) return;
  physics::World& world = obstacle.room->world();
  const physics::BodyHandle handle = currentBody(obstacle, *body);
  if (!handle || !world.body(handle).isDynamic()) return;
  const Vec3 velocity = obstacle.pose().rotate(value);
  const physics::Body& now = world.body(handle);
  world.setVelocity(handle, angular ? now.velocity : velocity, angular ? velocity : now.angularVelocity);
}

void clonePose(script::Call& call, Obstacle& obstacle) {
  const ScriptBody* to = readBody(call, obstacle, 1);
  const ScriptBody* from = readBody(call, obstacle, 2);
  if (call.failed()) return;
  physics::World& world = obstacle.room->world();
  const physics::BodyHandle target = currentBody(obstacle, *to);
  const physics::BodyHandle source = currentBody(obstacle, *from);
  if (!target || !source) return;
  chargeForShapes(call, obstacle, *to, 500, 300);
  const Transform& pose = world.body(source).pose;
  if (pose.position.cwiseAbs().maxCoeff() <= rules::kFarthest) world.setPose(target, pose);
}

}  // namespace

void addMotionCalls(script::Library& library) {
  addCall(library, "mgMove", move);
  addCall(library, "mgRotate", rotate);
  addCall(library, "mgReleaseMotion", releaseMotion);
  addCall(library, "mgSetVel", setVelocity<false>);
  addCall(library, "mgSetAngVel", setVelocity<true>);
  addCall(library, "mgClonePose", clonePose);
}

}  // namespace brittle::sim
