// Does the camera fit? A geometric test of the camera's volume against what stands in the way, not a flag: a hole that
// was shot is a way.
#include "engine/geometry/gjk.h"
#include "game/sim/room.h"

namespace brittle::sim {

namespace {

struct Obstruction {
  physics::BodyHandle body;
  std::uint32_t owner = 0;
  Vec3 point = Vec3::Zero();  // where it is nearest to the camera
};

}  // namespace

Vec3 Room::nearestPoint(physics::ShapeHandle handle, const Vec3& to) const {
  const physics::Shape& shape = world_->shape(handle);
  geometry::SimplexCache cache;
  const geometry::Proxy eye{{}, Vec3::Zero(), 0.001f};
  const Transform& pose = world_->body(shape.body).pose;
  const geometry::Proxy proxy = physics::proxyOf(shape, world_->meshes());
  return geometry::separation(eye, {to, Quat::Identity()}, proxy, pose, cache).pointB;
}

bool Room::blocks(physics::ShapeHandle handle) const {
  const physics::Shape& shape = world_->shape(handle);
  const physics::Body& body = world_->body(shape.body);
  if ((body.userData & kBallBit) != 0 || shape.surface.mask == 0) return false;
  if (!shape.isPiece) return true;
  if (body.isDynamic()) return body.mass >= rules::kCrashPieceMass;
  return shape.massProperties.volume * shape.surface.density >= rules::kCrashRimMass;
}

// The camera's whole way through the obstacle at once: a ball along a segment.
bool Room::canPass(const Obstacle& obstacle) const {
  geometry::Vertex ends[2];
  ends[0].point = viewpoint_.position;
  ends[1].point = viewpoint_.position;
  Aabb bounds;
  world_->forEachBody([&](physics::BodyHandle, const physics::Body& body) {
    if (body.userData == obstacle.number) bounds.include(Aabb{body.center, body.center}.grownBy(body.radius));
  });
  if (bounds.isEmpty()) return true;
  ends[0].point.z() = bounds.high.z();
  ends[1].point.z() = bounds.low.z();
  const geometry::Proxy way{{ends, {}, {}}, Vec3::Zero(), 0.0f};
  bool free = true;
  world_->forEachBody([&](physics::BodyHandle, const physics::Body& body) {
    if (body.userData != obstacle.number) return;
    for (physics::ShapeHandle s = body.firstShape; free && s; s = world_->shape(s).next)
      free = !blocks(s) || !geometry::overlaps(way, Transform{}, physics::proxyOf(world_->shape(s), world_->meshes()),
                                               body.pose, rules::kCameraRadius);
  });
  return free;
}

void Room::crashTest() {
  if (session_.score.free || !session_.score.canCrash()) return;
  std::vector<Obstruction> found;
  world_->overlapSphere(viewpoint_.position, rules::kCameraRadius, ~0u, [&](physics::ShapeHandle handle) {
    if (!blocks(handle)) return true;
    const physics::BodyHandle body = world_->bodyOf(handle);
    const std::uint32_t owner = world_->body(body).userData;
    const Obstacle* obstacle = obstacleOf(owner);
    if (obstacle == nullptr || !obstacle->touched)
      found.push_back({body, owner, nearestPoint(handle, viewpoint_.position)});
    return true;
  });
  const bool isBurnt = checkLasers();
  if (found.empty() && !isBurnt) return;
  Event event;
  event.type = EventType::Crash;
  event.point = viewpoint_.position;
  event.speed = viewpoint_.speed;
  event.value = session_.score.crash();
  emit(event);
  for (const Obstruction& obstruction : found) {
    if (Obstacle* obstacle = obstacleOf(obstruction.owner)) obstacle->touched = true;
    breakByCamera(obstruction.body, obstruction.point);
  }
}

void Room::breakByCamera(physics::BodyHandle handle, const Vec3& point) {
  if (!world_->isAlive(handle) || !world_->body(handle).breakable) return;
  const physics::Body& body = world_->body(handle);
  physics::BreakEvent broken;
  broken.body = handle;
  broken.assembly = body.assembly;
  broken.userData = body.userData;
  broken.point = point;
  broken.normal = -Vec3::UnitZ();
  broken.speed = viewpoint_.speed;
  broken.impulse = body.breaking.strength;
  world_->breakBody(handle, point, broken.normal, rules::kCrashSpeed, rules::kCameraRadius);
  readBreak(broken);
}

bool Room::checkLasers() const {
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_)
    if (obstacle->stage == Stage::Alive && obstacle->laser) return true;
  return false;
}

}  // namespace brittle::sim
