// What a room throws away: what fell or lies behind, and pieces that nobody can see again.
#include <algorithm>

#include "game/sim/room.h"

namespace brittle::sim {

namespace {

Mover moverOf(const physics::Body& body) {
  return {body.center, body.velocity, body.radius, !body.awake};
}

Mover moverOf(const physics::Crumb& crumb) {
  return {crumb.position, crumb.velocity, crumb.radius, crumb.resting};
}

}  // namespace

void Room::removeBehind() {
  const float behind = viewpoint_.position.z() + rules::kBehindCamera;
  const WidestView view =
      widestView(viewpoint_.position, plan_.effects.runs(effects::Effect::CameraRoll), plan_.settings.gravity);
  std::vector<physics::BodyHandle> doomed, leaving;
  std::vector<std::uint32_t> bodiesOf(obstacles_.size() + 1, 0);
  world_->forEachBody([&](physics::BodyHandle handle, const physics::Body& body) {
    if (body.userData == 0) return;  // of a segment
    const bool fell = body.type != physics::BodyType::Static && body.center.y() + body.radius < rules::kFallDepth;
    if (fell || body.center.z() - body.radius > behind) {
      session_.omissions.add(fell ? Omission::Fallen : Omission::BehindCamera);
      doomed.push_back(handle);
      return;
    }
    if (body.userData < bodiesOf.size()) ++bodiesOf[body.userData];
    if (body.isPiece && isLeaving(view, moverOf(body))) leaving.push_back(handle);
  });
  for (const physics::BodyHandle handle : doomed) world_->destroyBody(handle);
  balls_.erase(
      std::remove_if(balls_.begin(), balls_.end(), [this](const Ball& ball) { return !world_->isAlive(ball.body); }),
      balls_.end());
  goOn(leaving, time_.isWhole() ? 1 : 0, unseen_);
  if (time_.isWhole()) removeUnseen(bodiesOf);
  // Crumbs in flight may bounce back into view.
  world_->removeCrumbs([&](const physics::Crumb& crumb) {
    return crumb.position.z() - crumb.radius > behind || crumb.position.y() + crumb.radius < rules::kFallDepth ||
           (crumb.resting && isLeaving(view, moverOf(crumb)));
  });
  settleObstacles(bodiesOf);
}

/// Pieces that have been out of sight for a while. What lies together goes together or not at all: nothing that is seen
/// moves because something unseen was taken out.
void Room::removeUnseen(std::vector<std::uint32_t>& bodiesOf) {
  physics::Heap heap;
  std::vector<bool> asked;  // by body slot: a heap is gathered once
  for (const Unseen& one : unseen_) {
    // Of what has to stay, each asks once in that time.
    if (one.ticks == 0 || one.ticks % rules::kUnseenTicks != 0 || !world_->isAlive(one.body)) continue;
    if (one.body.index < asked.size() && asked[one.body.index]) continue;
    world_->heapOf(one.body, heap);
    asked.resize(heap.isIn.size());
    for (const physics::BodyHandle body : heap.bodies) asked[body.index] = true;
    if (heap.isCarried || !std::all_of(heap.bodies.begin(), heap.bodies.end(),
                                       [this](physics::BodyHandle body) { return isForgotten(body); }))
      continue;
    for (const physics::BodyHandle body : heap.bodies) {
      --bodiesOf[world_->body(body).userData];
      world_->destroyBody(body);
    }
    session_.omissions.add(Omission::OutOfSight, heap.bodies.size());
  }
}

/// Out of sight long enough, and no script has a number for it.
bool Room::isForgotten(physics::BodyHandle handle) {
  const auto isBefore = [](const Unseen& one, physics::BodyHandle key) { return one.body.index < key.index; };
  const auto found = std::lower_bound(unseen_.begin(), unseen_.end(), handle, isBefore);
  if (found == unseen_.end() || found->body != handle || found->ticks < rules::kUnseenTicks) return false;
  const Obstacle* owner = obstacleOf(world_->body(handle).userData);
  return owner != nullptr && std::none_of(owner->bodies.begin(), owner->bodies.end(),
                                          [=](const ScriptBody& body) { return body.handle == handle; });
}

}  // namespace brittle::sim
