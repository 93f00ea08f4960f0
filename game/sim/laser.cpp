#include "engine/physics/world.h"
#include "game/sim/obstacle_api.h"
#include "game/sim/room.h"

namespace brittle::sim {

void castLaser(script::Call& call, Obstacle& obstacle) {
  const Vec3 from = readVector(call, 1, rules::kFarthest);
  const Vec3 way = readVector(call, 4, rules::kFarthest);
  if (call.failed()) return;
  BeamView beam;
  beam.from = obstacle.pose().toWorld(from);
  const Vec3 direction = obstacle.pose().rotate(normalizedOr(way, Vec3::UnitX()));
  beam.to = beam.from + direction * rules::kLaserReach;
  chargeForRay(call, obstacle, beam.from, beam.to);
  const physics::RayResult ray = obstacle.room->world().castRay(beam.from, beam.to);
  beam.hits = ray.hit;
  if (ray.hit) beam.to = ray.point;
  const Vec3 eye = obstacle.room->viewpoint().position;
  const Vec3 line = beam.to - beam.from;
  const float along = clampTo((eye - beam.from).dot(line) / maxOf(line.squaredNorm(), 1e-12f), 0.0f, 1.0f);
  if ((beam.from + line * along - eye).norm() < rules::kCameraRadius) obstacle.laser = true;
  obstacle.beams.push_back(beam);
}

}  // namespace brittle::sim
