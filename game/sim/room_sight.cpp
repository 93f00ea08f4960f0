// What of a room a player can see and may want to throw at.
#include <algorithm>

#include "engine/geometry/gjk.h"
#include "game/sim/room.h"

namespace brittle::sim {

namespace {

/// Into the axes of Sight.
Vec3 ahead(const Vec3& v) {
  return Vec3(v.x(), v.y(), -v.z());
}

/// Within a picture of 16 to 9, not closer than a ball starts and not lost in the fog.
bool isInPicture(const Vec3& position) {
  const float high = rules::kHalfWidthTangent * 9.0f / 16.0f;
  return position.z() > rules::kThrowAhead && position.z() < rules::kFogFull &&
         std::abs(position.x()) < rules::kHalfWidthTangent * position.z() &&
         std::abs(position.y()) < high * position.z();
}

}  // namespace

void Room::look(std::vector<Sight>& sights) const {
  const std::size_t first = sights.size();
  world_->forEachBody([&](physics::BodyHandle handle, const physics::Body& body) {
    const bool isOfObstacle = body.userData > 0 && body.userData <= obstacles_.size();
    if (!isOfObstacle || obstacles_[body.userData - 1]->stage != Stage::Alive) return;
    const Obstacle& obstacle = *obstacles_[body.userData - 1];
    Sight sight;
    sight.id = (number_ << 32) + obstacle.number;
    sight.type = obstacle.def->type;
    sight.center = sight.position = ahead(body.center - viewpoint_.position);
    sight.velocity = ahead(body.velocity);
    sight.mass = body.mass;
    sight.gives = body.breakable || body.isDynamic();
    if (seeAs(obstacle, handle, sight)) sights.push_back(sight);
  });
  // Of each threat what is nearest to the camera's way; crystals and buttons are one body each.
  std::stable_sort(sights.begin() + static_cast<std::ptrdiff_t>(first), sights.end(),
                   [](const Sight& a, const Sight& b) {
                     return a.id != b.id ? a.id < b.id : a.kind != b.kind ? a.kind < b.kind : a.aside < b.aside;
                   });
  const auto isSame = [](const Sight& a, const Sight& b) {
    return a.id == b.id && a.kind == b.kind && a.kind != SightKind::Button;
  };
  sights.erase(std::unique(sights.begin() + static_cast<std::ptrdiff_t>(first), sights.end(), isSame), sights.end());
  lookAtPickups(sights);
}

void Room::lookAtPickups(std::vector<Sight>& sights) const {
  for (std::size_t i = 0; i < pickups_.size(); ++i) {
    if (pickups_[i].stage != Stage::Alive || !world_->isAlive(pickups_[i].body)) continue;
    Sight sight;
    sight.kind = SightKind::PowerUp;
    sight.id = (number_ << 32) + (std::uint64_t{1} << 31) + i;
    sight.type = nameOf(plan_.pickups[i].kind);
    sight.center = sight.position = ahead(world_->body(pickups_[i].body).center - viewpoint_.position);
    sight.clear = isInSight(sight.position, 0);
    if (isInPicture(sight.position)) sights.push_back(sight);
  }
}

bool Room::seeAs(const Obstacle& obstacle, physics::BodyHandle handle, Sight& sight) const {
  const bool isWhole = std::any_of(obstacle.bodies.begin(), obstacle.bodies.end(),
                                   [&](const ScriptBody& body) { return body.handle == handle && body.breaks == 0; });
  if (obstacle.crystal > 0) {
    sight.kind = SightKind::Crystal;
    sight.worth = obstacle.crystal;
    if (obstacle.crystalDone || !isWhole) return false;
  } else if (const ScriptButton* button = buttonOf(obstacle, handle)) {
    sight.kind = SightKind::Button;
    if (button->down) return false;
  } else if (!seeThreat(handle, sight)) {
    return false;
  }
  sight.clear = isInSight(sight.position, obstacle.number);
  return isInPicture(sight.position);
}

const ScriptButton* Room::buttonOf(const Obstacle& obstacle, physics::BodyHandle handle) const {
  for (const ScriptButton& button : obstacle.buttons)
    if (obstacle.bodies[button.body - 1].handle == handle) return &button;
  return nullptr;
}

/// The point of a blocking shape nearest to the camera's way.
bool Room::seeThreat(physics::BodyHandle handle, Sight& sight) const {
  const physics::Body& body = world_->body(handle);
  const Vec3 eye = viewpoint_.position;
  const Vec3 onWay(eye.x(), eye.y(), minOf(body.center.z(), eye.z()));
  sight.kind = SightKind::Threat;
  bool found = false;
  for (physics::ShapeHandle s = body.firstShape; s; s = world_->shape(s).next) {
    if (!blocks(s)) continue;
    const Vec3 point = nearestPoint(s, onWay);
    const float aside = Vec3(point.x() - eye.x(), point.y() - eye.y(), 0.0f).norm();
    if (found && aside >= sight.aside) continue;
    found = true;
    sight.aside = aside;
    sight.position = ahead(point - eye);
  }
  return found;
}

bool Room::isInSight(const Vec3& position, std::uint32_t owner) const {
  const Vec3 eye = viewpoint_.position;
  const physics::RayResult ray = world_->castRay(eye, eye + ahead(position));
  if (!ray.hit) return true;
  const std::uint32_t userData = world_->body(world_->bodyOf(ray.shape)).userData;
  return (userData == owner && owner != 0) || (userData & kBallBit) != 0 || ray.fraction > 0.999f;
}

}  // namespace brittle::sim
