// What the obstacles of a room may take together: instructions, bodies, shapes, contacts. What its plan may hold is in
// segment_placing.cpp.
#include <algorithm>

#include "game/sim/room.h"

namespace brittle::sim {

/// Once they have used up the tick's time the scripts of the others do nothing in it.
void Room::runScripts(std::int64_t (Obstacle::*run)(bool)) {
  std::int64_t left = rules::kRoomInstructions;
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_) {
    if (obstacle->stage != Stage::Alive) continue;
    if (left <= 0) {
      session_.omissions.add(Omission::IdleScript);
      session_.reportMissing("the scripts of a room", obstacle->def->where,
                             "more than " + std::to_string(rules::kRoomInstructions) +
                                 " instructions in a tick: the rest do nothing in it");
    }
    left -= (obstacle.get()->*run)(left > 0);
  }
}

bool Room::hasPlaceForBody() const {
  std::size_t count = 0;
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_)
    if (obstacle->stage == Stage::Alive) count += obstacle->bodies.size();
  return count < rules::kMaxBodiesPerRoom;
}

std::uint32_t Room::scriptShapes() const {
  std::size_t count = 0;
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_)
    if (obstacle->stage == Stage::Alive) count += obstacle->shapes.size();
  return static_cast<std::uint32_t>(count);
}

bool Room::hasPlaceForShape() const {
  return scriptShapes() < rules::kMaxShapesPerRoom;
}

std::uint32_t Room::crowdBetween(const Vec3& from, const Vec3& to) const {
  return plan_.crowd.between(shift_ - from.z(), shift_ - to.z()) + scriptShapes();
}

/// By the number of the obstacle that they belong to: how often its shapes take part in a contact.
std::vector<std::uint32_t> Room::countContacts() const {
  std::vector<std::uint32_t> counts(obstacles_.size() + 1, 0);
  world_->forEachBody([&](physics::BodyHandle, const physics::Body& body) {
    if (body.userData >= counts.size()) return;  // a ball
    for (physics::ShapeHandle s = body.firstShape; s; s = world_->shape(s).next)
      counts[body.userData] += world_->shape(s).contactCount;
  });
  counts[0] = 0;  // of segments
  return counts;
}

/// Things on one spot have as many contacts as the square of their number, and no rule of physics pulls them apart in
/// time: the obstacles that have the most are taken out until the rest is bearable.
void Room::thinOut() {
  if (world_->counters().contacts <= rules::kMaxContactsPerRoom) return;
  std::vector<std::uint32_t> counts = countContacts();
  for (std::uint32_t left = 2 * world_->counters().contacts; left > 2 * rules::kMaxContactsPerRoom;) {
    const auto worst = std::max_element(counts.begin(), counts.end());
    if (*worst == 0) return;
    left -= std::min(left, *worst);
    *worst = 0;
    takeOut(*obstacles_[static_cast<std::size_t>(worst - counts.begin()) - 1]);
  }
}

void Room::takeOut(Obstacle& obstacle) {
  std::vector<physics::BodyHandle> doomed;
  world_->forEachBody([&](physics::BodyHandle handle, const physics::Body& body) {
    if (body.userData == obstacle.number) doomed.push_back(handle);
  });
  for (const physics::BodyHandle handle : doomed) world_->destroyBody(handle);
  retire(obstacle);
  session_.omissions.add(Omission::RemovedObstacle);
  session_.reportMissing(
      "obstacle " + obstacle.def->type, obstacle.def->where,
      "more than " + std::to_string(rules::kMaxContactsPerRoom) + " contacts in a room: it is taken out");
}

void Room::retire(Obstacle& obstacle) {
  obstacle.stage = Stage::Gone;
  obstacle.script.reset();
  obstacle.beams.clear();
  obstacle.decals.clear();
}

}  // namespace brittle::sim
