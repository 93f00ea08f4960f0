// The calls of obstacle scripts that look: rays, poses, what broke, the camera.
#include <vector>

#include "engine/geometry/gjk.h"
#include "engine/physics/world.h"
#include "game/sim/obstacle_api.h"
#include "game/sim/room.h"

namespace brittle::sim {

namespace {

/// Answers the body (false if nothing was hit) and the point where the ray ends.
void raycast(script::Call& call, Obstacle& obstacle) {
  const Vec3 from = readVector(call, 1, rules::kFarthest);
  const Vec3 to = readVector(call, 4, rules::kFarthest);
  const int mask = call.integer(7, 0x7fffffff);
  if (call.failed()) return;
  const physics::World& world = obstacle.room->world();
  const Transform pose = obstacle.pose();
  const Vec3 start = pose.toWorld(from), end = pose.toWorld(to);
  chargeForRay(call, obstacle, start, end);
  const physics::RayResult ray = world.castRay(start, end, static_cast<std::uint32_t>(mask));
  if (!ray.hit) {
    call.result(false);
    return answer(call, to);
  }
  call.result(obstacle.numberOf(world.bodyOf(ray.shape)));
  answer(call, pose.toLocal(ray.point));
}

/// The body's frame as seen from the obstacle; as asked for while it has none.
Transform poseOf(const Obstacle& obstacle, const ScriptBody& body) {
  const physics::BodyHandle handle = currentBody(obstacle, body);
  if (!handle) return body.pose;
  return relativeTo(obstacle.pose(), obstacle.room->world().body(handle).pose);
}

void getPosition(script::Call& call, Obstacle& obstacle) {
  const ScriptBody* body = readBody(call, obstacle, 1);
  if (!call.failed()) answer(call, poseOf(obstacle, *body).position);
}

void getRotation(script::Call& call, Obstacle& obstacle) {
  const ScriptBody* body = readBody(call, obstacle, 1);
  if (!call.failed()) answer(call, anglesOf(poseOf(obstacle, *body).rotation));
}

template <bool isPoint>
void bodyToWorld(script::Call& call, Obstacle& obstacle) {
  const ScriptBody* body = readBody(call, obstacle, 1);
  const Vec3 value = readVector(call, 2, rules::kFarthest);
  if (call.failed()) return;
  const Transform pose = poseOf(obstacle, *body);
  answer(call, isPoint ? pose.toWorld(value) : pose.rotate(value));
}

void bodyContainsPoint(script::Call& call, Obstacle& obstacle) {
  const ScriptBody* body = readBody(call, obstacle, 1);
  const Vec3 point = readVector(call, 2, rules::kFarthest);
  if (call.failed()) return;
  chargeForShapes(call, obstacle, *body, 0, 20);
  const physics::World& world = obstacle.room->world();
  const physics::BodyHandle handle = currentBody(obstacle, *body);
  bool inside = false;
  if (handle) {
    const Transform pose = world.body(handle).pose;
    for (physics::ShapeHandle s = world.body(handle).firstShape; s; s = world.shape(s).next)
      inside = inside || geometry::containsPoint(physics::proxyOf(world.shape(s), world.meshes()), pose,
                                                 obstacle.pose().toWorld(point));
  }
  call.result(inside);
}

const ScriptShape* readShape(script::Call& call, Obstacle& obstacle) {
  const int number = call.integer(1);
  if (call.failed()) return nullptr;
  if (number >= 1 && number <= static_cast<int>(obstacle.shapes.size()))
    return &obstacle.shapes[static_cast<std::size_t>(number) - 1];
  call.fail("no shape " + std::to_string(number));
  return nullptr;
}

/// A shape's body changes when a piece splits off: the usual test for "is it broken off". 0 once nothing of the shape
/// is left whole.
void getShapeBody(script::Call& call, Obstacle& obstacle) {
  const ScriptShape* shape = readShape(call, obstacle);
  if (call.failed()) return;
  const physics::World& world = obstacle.room->world();
  call.result(world.isAlive(shape->handle) ? obstacle.numberOf(world.bodyOf(shape->handle)) : 0);
}

void shapeIsBroken(script::Call& call, Obstacle& obstacle) {
  const ScriptShape* shape = readShape(call, obstacle);
  if (call.failed()) return;
  const physics::World& world = obstacle.room->world();
  call.result(!world.isAlive(shape->handle) || world.shape(shape->handle).isPiece);
}

void bodyIsBroken(script::Call& call, Obstacle& obstacle) {
  const ScriptBody* body = readBody(call, obstacle, 1);
  if (!call.failed()) call.result(body->breaks > 0);
}

void getCameraPosition(script::Call& call, Obstacle& obstacle) {
  answer(call, obstacle.pose().toLocal(obstacle.room->viewpoint().position));
}

void addCameraCalls(script::Library& library) {
  addCall(library, "mgGetCameraPos", getCameraPosition);
  addCall(library, "mgGetCameraSpeed", [](script::Call& call, Obstacle& o) { call.result(o.room->viewpoint().speed); });
  addCall(library, "mgCameraDistance", [](script::Call& call, Obstacle& o) {
    call.result(o.room->viewpoint().position.z() - o.pose().position.z());
  });
  addCall(library, "mgGetGravity", [](script::Call& call, Obstacle& o) { call.result(o.room->gravity()); });
  addCall(library, "mgCanPass", [](script::Call& call, Obstacle& o) {
    call.charge(2000 + 50 * static_cast<std::int64_t>(o.shapes.size()));
    call.result(o.room->canPass(o));
  });
  addCall(library, "mgHasBoss", [](script::Call& call, Obstacle&) { call.result(false); });
  addCall(library, "mgIsClosestBoss", [](script::Call& call, Obstacle&) { call.result(false); });
}

}  // namespace

void addQueryCalls(script::Library& library) {
  addCall(library, "mgRaycast", raycast);
  addCall(library, "mgGetPos", getPosition);
  addCall(library, "mgGetRot", getRotation);
  addCall(library, "mgBodyPointToWorld", bodyToWorld<true>);
  addCall(library, "mgBodyVecToWorld", bodyToWorld<false>);
  addCall(library, "mgBodyContainsPoint", bodyContainsPoint);
  addCall(library, "mgGetShapeBody", getShapeBody);
  addCall(library, "mgShapeIsBroken", shapeIsBroken);
  addCall(library, "mgBodyIsBroken", bodyIsBroken);
  addCameraCalls(library);
}

}  // namespace brittle::sim
