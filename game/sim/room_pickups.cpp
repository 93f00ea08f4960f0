// Power-ups that wait in a room: small solids that float in their place, touch nothing, and are collected by the first
// ball whose way comes near.
#include <algorithm>

#include "engine/geometry/make.h"
#include "game/sim/room.h"

namespace brittle::sim {

namespace {

constexpr std::uint32_t kPickupBit = 0x40000000u;      // in Body::userData: neither an obstacle's nor a ball's
constexpr float kSize = 0.75f * rules::kPickupRadius;  // of what is seen [m]

/// The corners (x, y, z) with both signs of y and z, and what turning the axes makes of them.
std::vector<Vec3> cornersOf(float y, float z) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 12; ++i) {
    const float second = (i & 1) != 0 ? y : -y, third = (i & 2) != 0 ? z : -z;
    Vec3 corner = Vec3::Zero();
    corner[(i / 4 + 1) % 3] = second;
    corner[(i / 4 + 2) % 3] = third;
    corners.push_back(corner);
  }
  return corners;
}

/// Two pyramids of six sides, base on base.
std::vector<Vec3> spindle() {
  std::vector<Vec3> corners = {Vec3(0.0f, 1.25f * kSize, 0.0f), Vec3(0.0f, -1.25f * kSize, 0.0f)};
  for (int i = 0; i < 6; ++i) {
    const float angle = kPi / 3.0f * static_cast<float>(i);
    corners.push_back(Vec3(0.72f * kSize * cosine(angle), 0.0f, 0.72f * kSize * sine(angle)));
  }
  return corners;
}

/// A solid for each kind: an icosahedron, a spindle, a cuboctahedron, a barrel.
geometry::Convex solidOf(PowerUp kind) {
  if (kind == PowerUp::Barrel) return geometry::makeCylinder(0.7f * kSize, kSize, 10, false);
  constexpr float onSphere = 0.525731f;  // times 1 and the golden ratio: corners at distance 1
  const std::vector<Vec3> corners = kind == PowerUp::BallFrenzy
                                        ? cornersOf(onSphere * kSize, 1.618034f * onSphere * kSize)
                                    : kind == PowerUp::NitroBalls ? cornersOf(0.707107f * kSize, 0.707107f * kSize)
                                                                  : spindle();
  const Result<geometry::Convex> hull = geometry::makeHull(corners);
  BR_ASSERT(static_cast<bool>(hull));
  return *hull;
}

std::uint32_t colorOf(PowerUp kind) {
  constexpr float colors[][3] = {
      {0.36f, 0.95f, 0.46f}, {0.95f, 0.36f, 0.90f}, {1.0f, 0.86f, 0.26f}, {1.0f, 0.46f, 0.20f}};
  const float* color = colors[static_cast<std::size_t>(kind)];
  return packColor(color[0], color[1], color[2], 1.0f);
}

}  // namespace

void Room::startPickups(float distance) {
  ballsBefore_.clear();
  bool isAnyAlive = false;
  for (std::size_t i = 0; i < pickups_.size(); ++i) {
    Pickup& pickup = pickups_[i];
    if (pickup.stage == Stage::Waiting && -plan_.pickups[i].position.z() < distance + rules::kSpawnAhead)
      startPickup(i);
    if (pickup.stage == Stage::Alive && !world_->isAlive(pickup.body)) pickup.stage = Stage::Gone;  // left behind
    isAnyAlive = isAnyAlive || pickup.stage == Stage::Alive;
  }
  if (!isAnyAlive) return;
  for (const Ball& ball : balls_) ballsBefore_.push_back(world_->body(ball.body).center);
}

void Room::startPickup(std::size_t index) {
  const PlannedPickup& planned = plan_.pickups[index];
  const std::optional<effects::Effect> effect = effectOf(planned.kind);
  pickups_[index].stage = Stage::Gone;
  if (effect && !plan_.effects.runs(*effect)) return;  // the player does without it
  physics::BodyDef def;
  def.type = physics::BodyType::Static;
  def.pose.position = planned.position + Vec3(0.0f, 0.0f, shift_);
  def.userData = kPickupBit | static_cast<std::uint32_t>(index);
  physics::ShapeDef shape;
  shape.surface.category = shape.surface.mask = 0;  // nothing meets it, no ray sees it
  shape.drawMaterial = static_cast<std::uint16_t>(Look::PowerUp);
  pickups_[index] = {Stage::Alive, world_->createBody(def)};
  const physics::ShapeHandle made = world_->addConvex(pickups_[index].body, shape, solidOf(planned.kind));
  world_->meshes().setColor(world_->shape(made).mesh, colorOf(planned.kind));
}

/// Whether a ball came near `place` in this tick: its way is taken to be straight.
bool Room::isHit(const Vec3& place) const {
  constexpr float near = rules::kPickupRadius + rules::kBallRadius;
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    if (!world_->isAlive(balls_[i].body)) continue;  // quarantined in this tick
    const Vec3 from = ballsBefore_[i], way = world_->body(balls_[i].body).center - from;
    const float along = clampTo((place - from).dot(way) / maxOf(way.squaredNorm(), 1e-12f), 0.0f, 1.0f);
    if ((from + way * along - place).squaredNorm() < near * near) return true;
  }
  return false;
}

void Room::collectPickups() {
  if (ballsBefore_.empty()) return;
  for (std::size_t i = 0; i < pickups_.size(); ++i) {
    if (pickups_[i].stage != Stage::Alive) continue;
    Event event;
    event.type = EventType::PowerUpCollected;
    event.look = Look::PowerUp;
    event.point = world_->body(pickups_[i].body).center;
    event.value = static_cast<std::int32_t>(plan_.pickups[i].kind);
    if (!isHit(event.point)) continue;
    world_->destroyBody(pickups_[i].body);
    pickups_[i] = {Stage::Gone, {}};
    session_.inventory.collect(plan_.pickups[i].kind);
    emit(event);
  }
}

void Room::demandFor(PowerUp kind) {
  const std::optional<effects::Effect> effect = effectOf(kind);
  if (effect) demandOnce(*effect, "by the game: a power-up of another room");
}

/// Whether each that waits has a body of its own, and nobody else's.
bool Room::hasOwnPickups() const {
  for (std::size_t i = 0; i < pickups_.size(); ++i) {
    if (pickups_[i].stage != Stage::Alive || !world_->isAlive(pickups_[i].body)) continue;
    if (world_->body(pickups_[i].body).userData != (kPickupBit | static_cast<std::uint32_t>(i))) return false;
  }
  return true;
}

void Room::copyPickups(RoomView& view) const {
  view.pickups.clear();
  for (std::size_t i = 0; i < pickups_.size(); ++i) {
    if (pickups_[i].stage != Stage::Alive || !world_->isAlive(pickups_[i].body)) continue;
    const Vec3 place = world_->body(pickups_[i].body).center + frameOffset_;
    view.pickups.push_back({plan_.pickups[i].kind, pickups_[i].body.index, place});
  }
}

}  // namespace brittle::sim
