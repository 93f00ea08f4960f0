// What a room makes of its world's events: broken things, hit buttons, crystals; and of obstacles that are passed.
#include <algorithm>

#include "game/sim/room.h"

namespace brittle::sim {

Obstacle* Room::obstacleOf(std::uint32_t userData) {
  return userData > 0 && userData <= obstacles_.size() ? obstacles_[userData - 1].get() : nullptr;
}

void Room::readEvents() {
  for (const physics::BreakEvent& broken : world_->events().breaks) readBreak(broken);
  for (const physics::HitEvent& hit : world_->events().hits) readHit(hit);
  for (std::size_t i = 0; i < world_->events().quarantined.size(); ++i) ++session_.score.quarantined;
}

void Room::readBreak(const physics::BreakEvent& broken) {
  Event event;
  event.type = EventType::Break;
  event.point = broken.point;
  event.direction = broken.normal;
  event.speed = broken.speed;
  event.impulse = broken.impulse;
  event.pieces = broken.pieces;
  ++session_.score.breaks;
  Obstacle* obstacle = obstacleOf(broken.userData);
  if (obstacle != nullptr) {
    for (ScriptBody& body : obstacle->bodies) {
      if (body.assembly != broken.assembly) continue;
      ++body.breaks;
      event.look = body.look;
      event.size = static_cast<float>(power(body.volume, 1.0 / 3.0));
      break;
    }
  }
  emit(event);
  if (obstacle == nullptr || obstacle->crystal == 0 || obstacle->crystalDone) return;
  obstacle->crystalDone = true;
  const int before = session_.score.ballsPerThrow();
  session_.score.winCrystal(obstacle->crystal, session_.ballCap());
  event.type = EventType::Crystal;
  event.value = obstacle->crystal;
  emit(event);
  if (session_.score.ballsPerThrow() == before) return;
  event.type = EventType::Multiball;
  event.value = session_.score.ballsPerThrow();
  emit(event);
}

Room::Party Room::partyOf(physics::BodyHandle handle) {
  Party party;
  if (!world_->isAlive(handle)) return party;
  const physics::Body& body = world_->body(handle);
  party.isBall = (body.userData & kBallBit) != 0;
  if (party.isBall) party.look = Look::Ball;
  const Obstacle* obstacle = obstacleOf(body.userData);
  if (obstacle == nullptr) return party;
  for (const ScriptBody& made : obstacle->bodies)
    if (made.assembly == body.assembly) party.look = made.look;
  if (body.mass > 0.0f && body.firstShape) {
    const float density = maxOf(world_->shape(body.firstShape).surface.density, 1e-3f);
    party.size = static_cast<float>(power(static_cast<double>(body.mass / density), 1.0 / 3.0));
  }
  return party;
}

void Room::pressButton(physics::BodyHandle handle) {
  Obstacle* obstacle = world_->isAlive(handle) ? obstacleOf(world_->body(handle).userData) : nullptr;
  if (obstacle == nullptr) return;
  for (ScriptButton& button : obstacle->buttons) {
    if (obstacle->bodies[button.body - 1].handle != handle) continue;
    button.justPressed = !button.down;
    obstacle->setDown(button, true);
  }
}

void Room::readHit(const physics::HitEvent& hit) {
  Party struck = partyOf(hit.a), striker = partyOf(hit.b);
  const bool isSmaller = struck.size > 0.0f && (striker.size == 0.0f || struck.size < striker.size);
  if (struck.isBall || (!striker.isBall && isSmaller)) std::swap(struck, striker);
  if (striker.isBall) {
    pressButton(hit.a);
    pressButton(hit.b);
  }
  Event event;
  event.type = EventType::Hit;
  event.point = hit.point;
  event.direction = hit.normal;
  event.speed = hit.speed;
  event.impulse = hit.impulse;
  event.look = struck.look;
  event.striker = striker.look;
  event.size = striker.size;
  event.value = striker.isBall ? 1 : 0;
  if (striker.isBall && struck.look == Look::Static)
    demandOnce(effects::Effect::Decals, "by the game: the mark of a ball");
  emit(event);
}

void Room::settleObstacles(const std::vector<std::uint32_t>& bodiesOf) {
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_) {
    if (obstacle->stage != Stage::Alive) continue;
    const bool isBehind = obstacle->pose().position.z() > viewpoint_.position.z() + rules::kBehindCamera;
    if (obstacle->crystal > 0 && !obstacle->crystalDone && isBehind) {
      obstacle->crystalDone = true;
      session_.score.missCrystal();
      Event event;
      event.type = EventType::CrystalMissed;
      event.look = Look::Crystal;
      event.point = obstacle->pose().position;
      emit(event);
    }
    if (isBehind && bodiesOf[obstacle->number] == 0) retire(*obstacle);
  }
}

void Room::clearObstacle(Obstacle& obstacle) {
  if (obstacle.cleared) return;
  obstacle.cleared = true;
  Event event;
  event.type = obstacle.def->type.rfind("doors/", 0) == 0 ? EventType::DoorOpens : EventType::Cleared;
  event.point = obstacle.pose().position;
  event.value = static_cast<std::int32_t>(session_.score.cleared++ % rules::kClearedNotes);
  emit(event);
}

}  // namespace brittle::sim
