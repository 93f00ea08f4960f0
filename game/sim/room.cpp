#include "game/sim/room.h"

#include "engine/core/profile.h"
#include "engine/core/random.h"
#include "engine/effects/has/explosions.h"
#include "engine/effects/has/water.h"
#include "engine/geometry/make.h"
#include "game/sim/level.h"
#include "game/sim/pace.h"

namespace brittle::sim {

namespace {

physics::WorldDef worldDef(const Session& session, std::uint64_t seed, float gravity) {
  physics::WorldDef def;
  def.gravity = Vec3(0.0f, -rules::kGravity * gravity, 0.0f);
  def.accuracy = accuracyOf(session);
  def.seed = seed;
  return def;
}

}  // namespace

physics::Accuracy accuracyOf(const Session& session) {
  physics::Accuracy accuracy = session.def.accuracy;
  if (session.def.without.has(effects::Effect::Debris)) accuracy.maxDebris = 0;
  if (session.def.without.has(effects::Effect::Stacks)) accuracy.stacks = false;
  return accuracy;
}

Room::Room(Session& session, const RoomEntry& entry, std::uint64_t number, std::uint32_t slot)
    : session_(session),
      entry_(entry),
      number_(number),
      slot_(slot),
      seed_(roomSeed(session, entry, number)),
      globalsBefore_(session.globals),
      plan_(planRoom(session, entry_, seed_, session.globals)),
      world_(std::make_unique<physics::World>(worldDef(session, seed_, plan_.settings.gravity))),
      built_(plan_.segments.size()),
      pickups_(plan_.pickups.size()) {
  for (const ObstacleDef& def : plan_.obstacles) {
    auto obstacle = std::make_unique<Obstacle>();
    obstacle->def = &def;
    obstacle->number = static_cast<std::uint32_t>(obstacles_.size()) + 1;
    obstacle->room = this;
    obstacle->pen.material = *findMaterial(session.files.materials(), "glass");
    obstacles_.push_back(std::move(obstacle));
  }
}

void Room::tick(float distance, float speed, std::int32_t ticks, const TimeStep& time, float tickPart) {
  BR_ZONE("room");
  time_ = time;
  updateShift(distance);
  viewpoint_.position = Vec3(0.0f, rules::kCameraHeight, shift_ - distance);
  viewpoint_.speed = speed;
  viewpoint_.ticks = ticks;
  viewpoint_.tickPart = tickPart;
  shake_ = shake_ > 0.01f ? shake_ * 0.92f : 0.0f;
  buildSegments(distance);
  startObstacles(distance);
  startPickups(distance);
  runScripts(&Obstacle::tickScript);
  if constexpr (effects::kHasWater)
    if (runs(effects::Effect::Water))
      waters_.slow(*world_, plan_.waters, shift_, plan_.settings.gravity, time.seconds());
  world_->step(time.seconds());
  readEvents();
  if (world_->counters().tallest > 0) demandOnce(effects::Effect::Stacks, "by the game: what stands on one another");
  collectPickups();
  if constexpr (effects::kHasExplosions)
    if (runs(effects::Effect::Explosions)) explodeBalls();
  if constexpr (effects::kHasWater)
    if (runs(effects::Effect::Water)) readSplashes();
  removeBehind();
  thinOut();
  runScripts(&Obstacle::drawScript);
  if (time.isWhole()) ++ticks_;
}

void Room::updateShift(float distance) {
  const float wanted = distance <= 0.0f
                           ? 0.0f
                           : static_cast<float>(static_cast<int>(distance / rules::kShiftEvery)) * rules::kShiftEvery;
  if (wanted == shift_) return;
  world_->shiftOrigin(Vec3(0.0f, 0.0f, shift_ - wanted));
  shift_ = wanted;
}

void Room::buildSegments(float distance) {
  for (std::size_t i = 0; i < built_.size(); ++i) {
    BuiltSegment& built = built_[i];
    const PlannedSegment& segment = plan_.segments[i];
    if (!built.built && segment.start < distance + rules::kBuildAhead) buildSegment(i);
    if (built.built && !built.dropped && segment.start + segment.look->length < distance - rules::kSegmentBehind) {
      if (built.body) world_->destroyBody(built.body);
      built.body = {};
      built.dropped = true;
    }
  }
}

void Room::buildSegment(std::size_t index) {
  const PlannedSegment& segment = plan_.segments[index];
  BuiltSegment& built = built_[index];
  built.built = true;
  if (segment.solids.empty()) return;
  physics::BodyDef def;
  def.type = physics::BodyType::Static;
  def.pose.position = Vec3(0.0f, 0.0f, shift_ - segment.start);
  built.body = world_->createBody(def);
  physics::ShapeDef shape;
  shape.surface.category = rules::kCategoryRoom | rules::kCategoryDefault;
  shape.surface.friction = 0.6f;
  shape.drawMaterial = static_cast<std::uint16_t>(Look::Static);
  for (const SolidBox& box : segment.solids)
    world_->addConvex(built.body, shape, geometry::makeBox<float>(box.halfExtents, box.center));
}

/// As many in a tick as its time allows: the others wait for the next.
void Room::startObstacles(float distance) {
  std::int64_t left = rules::kRoomInstructions;
  for (const std::unique_ptr<Obstacle>& obstacle : obstacles_) {
    if (obstacle->stage != Stage::Waiting) continue;
    const bool isElevator = obstacle->def->type.find("elevator") != std::string::npos;
    const float ahead = isElevator ? rules::kSpawnAheadElevator : rules::kSpawnAhead;
    if (-obstacle->def->position.z() >= distance + ahead) continue;
    if (left > 0)
      left -= obstacle->start();
    else
      session_.omissions.add(Omission::DeferredObstacle);
  }
}

void Room::throwBalls(const Camera& camera, const replay::Throw& aim, int count, Charge charge) {
  int number = 0;
  for (BallStart start : sim::throwBalls(camera, aim, count, rules::kGravity * plan_.settings.gravity)) {
    if (charge != Charge::Barrel || number == count / 2) start.charge = charge;
    ++number;
    addBall(start);
    Event event;
    event.type = EventType::Throw;
    event.look = Look::Ball;
    event.point = start.position;
    event.direction = start.velocity;
    event.speed = start.velocity.norm();
    emit(event);
  }
}

void Room::addBall(const BallStart& start) {
  const std::uint32_t number = nextBall_++ | static_cast<std::uint32_t>(start.charge) << kChargeShift;
  if (start.charge != Charge::None) demandFor(PowerUp::NitroBalls);
  balls_.push_back({makeBall(*world_, start, number), number});
}

std::vector<BallStart> Room::takeLeavingBalls() {
  std::vector<BallStart> leaving;
  const float length = allowedLength(plan_.settings.length);
  std::vector<Ball> staying;
  for (const Ball& ball : balls_) {
    const physics::Body& body = world_->body(ball.body);
    if (body.center.z() > shift_ - length) {
      staying.push_back(ball);
      continue;
    }
    leaving.push_back({Vec3(body.center - Vec3(0.0f, 0.0f, shift_ - length)), body.velocity, ball.charge()});
    world_->destroyBody(ball.body);
  }
  balls_ = staying;
  return leaving;
}

Result<std::string> Room::readScript(const std::string& path) {
  return session_.files.text(path);
}

void Room::emit(Event event) {
  event.point += frameOffset_;
  session_.events.push_back(event);
}

}  // namespace brittle::sim
