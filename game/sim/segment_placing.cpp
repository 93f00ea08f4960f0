// From a segment file to what a room is made of: its solid boxes, its look, its obstacles in the room's frame.
#include "game/content/number.h"
#include "game/sim/room_plan.h"

namespace brittle::sim {

namespace {

LookBox lookOf(const content::Box& box) {
  LookBox look;
  look.center = box.position;
  look.halfExtents = box.halfExtents;
  for (std::size_t i = 0; i < 3; ++i) {
    look.color[i] = box.color[i];
    look.tile[i] = box.tile[i];
    look.tileSize[i] = box.tileSize[i];
    look.tileRotation[i] = box.tileRotation[i];
  }
  look.reflects = box.reflection;
  look.glow = box.glow;
  return look;
}

float numberOf(const content::Obstacle& obstacle, const char* key, float otherwise) {
  const std::string* text = obstacle.find(key);
  const auto number = text != nullptr ? content::parseNumber(*text) : std::nullopt;
  return number && *number > 0.001 && *number < 1000.0 ? static_cast<float>(*number) : otherwise;
}

/// The community's "stone": a box that is seen and does not collide. Three of four obstacles are stones, so they cost no script.
LookBox stoneOf(const content::Obstacle& obstacle) {
  LookBox look;
  look.center = obstacle.position;
  look.halfExtents = Vec3(numberOf(obstacle, "sizeX", 0.5f), numberOf(obstacle, "sizeY", 0.5f), numberOf(obstacle, "sizeZ", 0.5f));
  const std::string* color = obstacle.find("color");
  const auto values = color != nullptr ? content::parseNumbers(*color) : std::nullopt;
  const bool colored = values && values->size() >= 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (colored) look.color[i] = Vec3(static_cast<float>((*values)[0]), static_cast<float>((*values)[1]), static_cast<float>((*values)[2]));
    look.tile[i] = static_cast<std::int32_t>(numberOf(obstacle, "tile", 0.0f));
  }
  return look;
}

std::shared_ptr<const SegmentLook> makeLook(const std::string& name, const content::Segment& segment) {
  auto look = std::make_shared<SegmentLook>();
  look->name = name;
  look->length = segment.size.z();
  for (std::size_t i = 0; i < 6; ++i) look->light[i] = segment.light[i];
  look->softShadow = segment.softShadow;
  for (const content::Box& box : segment.boxes)
    if (box.visible && !box.hidden) look->boxes.push_back(lookOf(box));
  for (const content::Obstacle& obstacle : segment.obstacles)
    if (obstacle.type == "stone" && !obstacle.hidden) look->boxes.push_back(stoneOf(obstacle));
  for (const content::Decal& decal : segment.decals) {
    if (decal.hidden) continue;
    LookDecal made;
    made.position = decal.position;
    made.rotation = rotationXyz(decal.rotation);
    made.size = decal.size;
    made.tile = decal.tile;
    made.color = decal.color;
    made.blend = decal.blend;
    look->decals.push_back(made);
  }
  return look;
}

std::uint32_t modeBit(Mode mode) {
  switch (mode) {
    case Mode::Training: return content::kTraining;
    case Mode::Classic:
    case Mode::Zen: return content::kClassicAndZen;
    case Mode::Mayhem: return content::kMayhem;
    case Mode::Versus: return content::kVersus;
    case Mode::Coop: return content::kCoop;
  }
  return content::kAllModes;
}

bool isWanted(const Session& session, const content::Obstacle& obstacle, float difficulty) {
  if (obstacle.hidden || obstacle.type == "stone" || (obstacle.modes & modeBit(session.def.mode)) == 0) return false;
  return obstacle.difficultyMin <= difficulty && difficulty <= obstacle.difficultyMax;
}

}  // namespace

float placeSegment(Session& session, const std::string& name, float start, RoomPlan& plan) {
  const std::shared_ptr<const content::Segment> segment = session.files.segment(name);
  session.takeFileProblems();
  if (!segment) return 0.0f;
  PlannedSegment placed;
  placed.start = start;
  placed.look = makeLook(name, *segment);
  for (const content::Box& box : segment->boxes)
    if (!box.hidden) placed.solids.push_back({box.position, box.halfExtents});
  plan.segments.push_back(std::move(placed));
  for (const content::Obstacle& obstacle : segment->obstacles) {
    if (!isWanted(session, obstacle, plan.settings.difficulty)) continue;
    if (plan.obstacles.size() >= rules::kMaxObstaclesPerRoom) break;
    ObstacleDef def;
    def.type = obstacle.type;
    def.position = obstacle.position - Vec3(0.0f, 0.0f, start);
    def.rotation = obstacle.rotation;
    for (const content::Param& param : obstacle.params) def.parameters[param.key] = param.value;
    def.where = segment->file + ":" + std::to_string(obstacle.line);
    plan.obstacles.push_back(std::move(def));
  }
  if (!segment->powerUps.empty()) session.report(segment->file + ": power-ups are not supported");
  if (!segment->waters.empty()) session.report(segment->file + ": water is not supported");
  return segment->size.z();
}

}  // namespace brittle::sim
