// What a room is made of, in one description for saving, restoring and hashing; and its copy for the view.
#include "game/sim/room.h"

namespace brittle::sim {

template <class Archive>
void Room::serialize(Archive& a) {
  a(ticks_);
  a(shift_);
  a(shake_);
  a(viewpoint_.position);
  a(viewpoint_.speed);
  a(viewpoint_.ticks);
  for (BuiltSegment& segment : built_) a(segment);
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_) a(*obstacle);
  for (Pickup& pickup : pickups_) a(pickup);
  a.vector(balls_);
  a(nextBall_);
  a.vector(unseen_);
  std::uint32_t demanded = plan_.effects.demanded().bits();
  a(demanded);
  plan_.effects.keep(effects::EffectMask::ofBits(demanded), "by the game: a snapshot has it");
}

std::uint64_t Room::stateHash() const {
  HashArchive archive;
  const_cast<Room*>(this)->serialize(archive);  // a hash only reads
  StateHash hash;
  hash.add(archive.value());
  hash.add(world_->stateHash());
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_)
    if (obstacle->script) hash.add(obstacle->scriptHash());
  return hash.value();
}

void Room::save(ByteWriter& out) const {
  out.write(static_cast<std::uint32_t>(globalsBefore_.size()));
  for (const auto& [key, value] : globalsBefore_) {
    out.writeString(key);
    out.writeString(value);
  }
  SaveArchive archive(out);
  const_cast<Room*>(this)->serialize(archive);
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_) obstacle->saveScript(out);
  world_->save(out);
}

bool Room::restore(ByteReader& in) {
  RestoreArchive archive(in);
  serialize(archive);
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_)
    if (!in.ok() || !obstacle->restoreScript(in)) return false;
  return world_->restore(in) && in.ok() && isConsistent();
}

/// What damaged bytes could break beside the world: what is reached without asking whether it is there.
bool Room::isConsistent() const {
  if (!hasOwnPickups()) return false;
  for (const Ball& ball : balls_)
    if (!world_->isAlive(ball.body)) return false;
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_) {
    const std::size_t bodies = obstacle->bodies.size();
    for (const ScriptShape& shape : obstacle->shapes)
      if (shape.body == 0 || shape.body > bodies) return false;
    for (const ScriptButton& button : obstacle->buttons)
      if (button.body == 0 || button.body > bodies) return false;
  }
  return true;
}

void Room::copyView(RoomView& view, std::vector<BallView>& balls) const {
  const RoomSettings& settings = plan_.settings;
  view.number = number_;
  view.ticks = viewpoint_.ticks;
  view.slot = slot_;
  view.fogBottom = settings.fogBottom;
  view.fogTop = settings.fogTop;
  for (int i = 0; i < 3; ++i) view.reverb[i] = settings.reverb[i];
  for (int i = 0; i < 4; ++i) view.echo[i] = settings.echo[i];
  view.lowPass = settings.lowPass;
  for (int i = 0; i < 3; ++i) view.focus[i] = settings.focus[i];
  view.music = settings.music;
  view.particles = settings.particles;
  view.effects = plan_.effects.running();
  view.bodyOffset = frameOffset_;
  copySegments(view);
  for (BodyPose& pose : view.bodies) pose.generation = 0;
  world_->forEachBody([&](physics::BodyHandle handle, const physics::Body& body) {
    if (handle.index >= view.bodies.size()) view.bodies.resize(handle.index + 1);
    view.bodies[handle.index] = {{Vec3(body.pose.position + frameOffset_), body.pose.rotation}, handle.generation};
  });
  for (const Ball& ball : balls_) {
    const Transform& pose = world_->body(ball.body).pose;
    balls.push_back({ball.number + (slot_ << 30),
                     {Vec3(pose.position + frameOffset_), pose.rotation},
                     rules::kBallRadius,
                     ball.charge()});
  }
  view.crumbs.clear();
  for (const physics::Crumb& crumb : world_->debris().crumbs)
    view.crumbs.push_back({Vec3(crumb.position + frameOffset_), crumb.radius, crumb.color});
  copyRopes(view);
  copyPickups(view);
  copyWaters(view);
}

void Room::copyWaters(RoomView& view) const {
  view.waters.clear();
  if (!view.effects.has(effects::Effect::Water)) return;
  const Vec3 moved = Vec3(0.0f, 0.0f, shift_) + frameOffset_;
  for (const PlannedWater& water : plan_.waters)
    view.waters.push_back({water.center + moved, water.halfExtents, water.cells});
}

void Room::copySegments(RoomView& view) const {
  view.segments.clear();
  for (std::size_t i = 0; i < built_.size(); ++i) {
    if (!built_[i].built || built_[i].dropped) continue;
    const PlannedSegment& segment = plan_.segments[i];
    PlacedSegment placed;
    placed.id = (number_ << 16) + i;
    placed.origin = Vec3(0.0f, 0.0f, shift_ - segment.start) + frameOffset_;
    placed.look = segment.look;
    view.segments.push_back(std::move(placed));
  }
}

void Room::copyRopes(RoomView& view) const {
  view.ropes.clear();
  view.beams.clear();
  view.bodyDecals.clear();
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_) {
    if (obstacle->stage != Stage::Alive) continue;
    for (const physics::JointHandle handle : obstacle->joints) {
      if (!world_->isAlive(handle)) continue;
      const physics::Joint& joint = world_->joint(handle);
      if (joint.type != physics::JointType::Rope) continue;
      const Vec3 a = world_->body(world_->bodyOf(joint.a)).pose.toWorld(joint.localAnchorA);
      const Vec3 b =
          joint.b ? world_->body(world_->bodyOf(joint.b)).pose.toWorld(joint.localAnchorB) : joint.localAnchorB;
      view.ropes.push_back({Vec3(a + frameOffset_), Vec3(b + frameOffset_)});
    }
    for (const BeamView& beam : obstacle->beams)
      view.beams.push_back({Vec3(beam.from + frameOffset_), Vec3(beam.to + frameOffset_), beam.hits});
    view.bodyDecals.insert(view.bodyDecals.end(), obstacle->decals.begin(), obstacle->decals.end());
  }
}

}  // namespace brittle::sim
