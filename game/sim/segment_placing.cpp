// From a segment file to what a room is made of: its solid boxes, its look, its obstacles in the room's frame.
#include <algorithm>

#include "engine/core/hash.h"
#include "game/content/number.h"
#include "game/sim/room_plan.h"
#include "game/sim/unread.h"

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

/// "file:line" of one of its elements.
template <class Element>
std::string placeOf(const content::Segment& segment, const Element& element) {
  return segment.file + ":" + std::to_string(element.line);
}

ObstacleDef defOf(const content::Obstacle& obstacle, const content::Segment& segment) {
  ObstacleDef def;
  def.type = obstacle.type;
  def.position = obstacle.position;
  def.rotation = obstacle.rotation;
  for (const content::Param& param : obstacle.params) {
    def.parameters[param.key] = param.value;
    if (param.isShared)
      def.shared.insert(param.key);
    else
      def.shared.erase(param.key);
  }
  def.where = placeOf(segment, obstacle);
  return def;
}

float numberOf(const ObstacleDef& obstacle, const char* key, float otherwise) {
  const auto text = obstacle.parameters.find(key);
  const auto number = text != obstacle.parameters.end() ? content::parseNumber(text->second) : std::nullopt;
  return number && *number > 0.001 && *number < 1000.0 ? static_cast<float>(*number) : otherwise;
}

std::shared_ptr<const SegmentLook> makeLook(Session& session, const std::string& name,
                                            const content::Segment& segment) {
  auto look = std::make_shared<SegmentLook>();
  look->name = name;
  look->length = segment.size.z();
  for (std::size_t i = 0; i < 6; ++i) look->light[i] = segment.light[i];
  look->softShadow = segment.softShadow;
  for (const content::Box& box : segment.boxes)
    if (box.visible && !box.hidden) look->boxes.push_back(lookOf(box));
  for (const content::Obstacle& obstacle : segment.obstacles) {
    if (obstacle.type != kStone || obstacle.hidden) continue;
    const ObstacleDef stone = defOf(obstacle, segment);
    reportUnread(session, stone);
    look->boxes.push_back(stoneLook(stone));
  }
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

/// What only its look calls for: once a segment, by the first of its elements that asks.
void demandEffects(const content::Segment& segment, const SegmentLook& look, effects::EffectSet& effects) {
  const auto demandBy = [&](effects::Effect effect, const auto& elements, auto asks) {
    const auto first = std::find_if(elements.begin(), elements.end(), asks);
    if (first != elements.end()) effects.demand(effect, placeOf(segment, *first));
  };
  const auto isSeen = [](const content::Box& box) { return box.visible && !box.hidden; };
  demandBy(effects::Effect::Bloom, segment.boxes, [=](const auto& box) { return isSeen(box) && box.glow > 0.0f; });
  demandBy(effects::Effect::Mirror, segment.boxes, [=](const auto& box) { return isSeen(box) && box.reflection; });
  demandBy(effects::Effect::Decals, segment.decals, [](const auto& decal) { return !decal.hidden; });
  if (look.softShadow > 0.0f) effects.demand(effects::Effect::Shadows, placeOf(segment, segment));
}

/// No file's: the colon leads out of the assets.
std::string nameOfBox(const LookBox& box) {
  StateHash hash;
  for (const Vec3& part : {box.center, box.halfExtents, box.color[0], box.color[1], box.color[2]})
    for (const float number : part) hash.add(number);
  for (const std::int32_t tile : box.tile) hash.add(tile);
  return "box:" + std::to_string(hash.value());
}

std::uint32_t modeBit(Mode mode) {
  switch (mode) {
    case Mode::Training:
      return content::kTraining;
    case Mode::Classic:
    case Mode::Zen:
      return content::kClassicAndZen;
    case Mode::Mayhem:
      return content::kMayhem;
    case Mode::Versus:
      return content::kVersus;
    case Mode::Coop:
      return content::kCoop;
  }
  return content::kAllModes;
}

bool isWanted(const Session& session, const content::Obstacle& obstacle, RoomPlan& plan) {
  if (obstacle.hidden || obstacle.type == kStone) return false;
  const bool isOfMode = (obstacle.modes & modeBit(session.def.mode)) != 0;
  plan.hasOtherModes = plan.hasOtherModes || !isOfMode;
  const float difficulty = plan.settings.difficulty;
  return isOfMode && obstacle.difficultyMin <= difficulty && difficulty <= obstacle.difficultyMax;
}

bool isFull(const RoomPlan& plan) {
  return plan.obstacles.size() >= rules::kMaxObstaclesPerRoom;
}

/// What is beyond a bound is left out: each thing counts, and it is said once a game. Always false.
bool refuse(Session& session, std::uint64_t count, const std::string& things, std::uint32_t most, const char* in,
            const std::string& where) {
  session.omissions.add(Omission::RefusedContent, count);
  session.reportMissing("more than " + std::to_string(most) + " " + things + " " + in, where, "the rest is left out");
  return false;
}

/// What goes with a segment that has no place: its other obstacles have a bound of their own.
std::uint64_t countParts(const content::Segment& segment) {
  const auto isShown = [](const auto& element) { return !element.hidden; };
  const auto isStone = [](const auto& obstacle) { return !obstacle.hidden && obstacle.type == kStone; };
  return static_cast<std::uint64_t>(std::count_if(segment.boxes.begin(), segment.boxes.end(), isShown) +
                                    std::count_if(segment.decals.begin(), segment.decals.end(), isShown) +
                                    std::count_if(segment.obstacles.begin(), segment.obstacles.end(), isStone));
}

/// Whether another segment, of so many boxes and other things, has a place in the room. If not, `parts` are left out.
bool admits(Session& session, const RoomPlan& plan, std::size_t things, std::uint64_t parts, const std::string& where) {
  if (plan.segments.size() >= rules::kMaxSegmentsPerRoom)
    return refuse(session, parts, "segments", rules::kMaxSegmentsPerRoom, "in a room", where);
  if (plan.boxes + things > rules::kMaxBoxesPerRoom)
    return refuse(session, parts, "boxes and decals", rules::kMaxBoxesPerRoom, "in a room", where);
  return true;
}

/// Whether a box about `middle` [m] from the room's start has a place there; if not, `parts` are left out.
bool admitAt(Session& session, RoomPlan& plan, std::uint64_t parts, float middle, float halfLength,
             const std::string& where) {
  return plan.crowd.add(middle - halfLength, middle + halfLength) ||
         refuse(session, parts, "boxes", rules::kMaxBoxesPerCell, "within 8 m", where);
}

}  // namespace

LookBox stoneLook(const ObstacleDef& stone) {
  LookBox look;
  look.isStone = true;
  look.center = stone.position;
  look.halfExtents =
      Vec3(numberOf(stone, "sizeX", 0.5f), numberOf(stone, "sizeY", 0.5f), numberOf(stone, "sizeZ", 0.5f));
  const auto color = stone.parameters.find("color");
  const auto values = color != stone.parameters.end() ? content::parseNumbers(color->second) : std::nullopt;
  const bool colored = values && values->size() >= 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (colored)
      look.color[i] =
          Vec3(static_cast<float>((*values)[0]), static_cast<float>((*values)[1]), static_cast<float>((*values)[2]));
    look.tile[i] = static_cast<std::int32_t>(numberOf(stone, "tile", 0.0f));
  }
  return look;
}

void placeBox(Session& session, const LookBox& box, bool isSolid, const std::string& where, RoomPlan& plan) {
  PlannedSegment made;
  made.start = -(box.center.z() + box.halfExtents.z());
  if (!admits(session, plan, 1, 1, where) || !admitAt(session, plan, 1, -box.center.z(), box.halfExtents.z(), where))
    return;
  ++plan.boxes;
  auto look = std::make_shared<SegmentLook>();
  look->length = 2.0f * box.halfExtents.z();
  look->boxes.push_back(box);
  look->boxes.back().center.z() = -box.halfExtents.z();
  look->name = nameOfBox(look->boxes.back());
  if (isSolid) made.solids.push_back({look->boxes.back().center, box.halfExtents});
  made.look = look;
  plan.segments.push_back(std::move(made));
}

bool placeObstacle(Session& session, ObstacleDef def, RoomPlan& plan) {
  const std::string where = def.where;
  const bool isPlaced = !isFull(plan);
  if (isPlaced) plan.obstacles.push_back(std::move(def));
  return isPlaced || refuse(session, 1, "obstacles", rules::kMaxObstaclesPerRoom, "in a room", where);
}

void placePowerUp(Session& session, const std::string& type, const Vec3& position, const std::string& where,
                  RoomPlan& plan) {
  const std::optional<PowerUp> kind = powerUpNamed(type);
  if (!kind) return session.reportMissing("power-up " + type, where, "there is none");
  const std::optional<effects::Effect> effect = effectOf(*kind);
  if (effect && !effects::isBuilt(*effect))
    return session.reportMissing("power-up " + type, where,
                                 std::string("this program is built without its effect, ") + effects::nameOf(*effect));
  if (plan.pickups.size() >= rules::kMaxPickupsPerRoom) {
    refuse(session, 1, "power-ups", rules::kMaxPickupsPerRoom, "in a room", where);
    return;
  }
  plan.pickups.push_back({*kind, position});
  if (effect) plan.effects.demand(*effect, where);
  plan.effects.demand(effects::Effect::Splinters, where);  // it sparkles when it is hit
}

namespace {

void placePowerUps(Session& session, const content::Segment& segment, float start, RoomPlan& plan) {
  for (const content::PowerUp& powerUp : segment.powerUps)
    if (!powerUp.hidden)
      placePowerUp(session, powerUp.type, powerUp.position - Vec3(0.0f, 0.0f, start), placeOf(segment, powerUp), plan);
}

void placeObstacles(Session& session, const content::Segment& segment, float start, RoomPlan& plan) {
  std::uint64_t refused = 0;
  std::string where;  // the first of them
  for (const content::Obstacle& obstacle : segment.obstacles) {
    if (!isWanted(session, obstacle, plan)) continue;
    if (isFull(plan)) {
      if (refused++ == 0) where = placeOf(segment, obstacle);
      continue;
    }
    plan.obstacles.push_back(defOf(obstacle, segment));
    plan.obstacles.back().position.z() -= start;
  }
  if (refused > 0) refuse(session, refused, "obstacles", rules::kMaxObstaclesPerRoom, "in a room", where);
}

void placeWaters(Session& session, const content::Segment& segment, float start, RoomPlan& plan) {
  std::uint64_t refused = 0;
  std::string where;  // the first of them
  for (const content::Water& water : segment.waters) {
    if (water.hidden) continue;
    if (plan.waters.size() >= rules::kMaxWatersPerRoom) {
      if (refused++ == 0) where = placeOf(segment, water);
      continue;
    }
    plan.waters.push_back({water.position - Vec3(0.0f, 0.0f, start), water.halfExtents, water.resolution});
    plan.effects.demand(effects::Effect::Water, placeOf(segment, water));
  }
  if (refused > 0) refuse(session, refused, "waters", rules::kMaxWatersPerRoom, "in a room", where);
}

void placeBoxes(Session& session, const std::string& name, const content::Segment& segment, float start,
                const std::string& where, RoomPlan& plan) {
  const std::size_t things = segment.boxes.size() + segment.decals.size() + segment.obstacles.size();
  const std::uint64_t parts = countParts(segment);
  if (!admits(session, plan, things, parts, where)) return;
  const auto crowdBefore = plan.crowd;
  for (const content::Box& box : segment.boxes) {
    if (box.hidden || admitAt(session, plan, parts, start - box.position.z(), box.halfExtents.z(), where)) continue;
    plan.crowd = crowdBefore;  // all of a segment or nothing
    return;
  }
  plan.boxes += static_cast<std::uint32_t>(things);
  PlannedSegment placed;
  placed.start = start;
  placed.look = makeLook(session, name, segment);
  demandEffects(segment, *placed.look, plan.effects);
  for (const content::Box& box : segment.boxes)
    if (!box.hidden) placed.solids.push_back({box.position, box.halfExtents});
  plan.segments.push_back(std::move(placed));
}

}  // namespace

float placeSegment(Session& session, const std::string& name, float start, const std::string& where, RoomPlan& plan) {
  const auto found = session.files.segment(name);
  session.takeFileProblems();
  if (!found) session.reportMissing("segment " + name, where, found.error().message);
  if (!found) return 0.0f;
  const std::shared_ptr<const content::Segment> segment = *found;
  placeBoxes(session, name, *segment, start, where, plan);
  placeObstacles(session, *segment, start, plan);
  placePowerUps(session, *segment, start, plan);
  placeWaters(session, *segment, start, plan);
  return segment->size.z();
}

}  // namespace brittle::sim
