// game/sim/room_plan.h - a room as its script laid it out: segments, obstacles and settings. A function of the content,
// the room's seed and the global strings, so a snapshot need not hold it.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/effects/effect_set.h"
#include "engine/math/types.h"
#include "game/sim/crowd.h"
#include "game/sim/frame_packet.h"
#include "game/sim/obstacle.h"
#include "game/sim/session.h"

namespace brittle::sim {

struct SolidBox {
  Vec3 center = Vec3::Zero();  // segment frame [m]
  Vec3 halfExtents = Vec3::Ones();
};

struct PlannedSegment {
  std::shared_ptr<const SegmentLook> look;
  std::vector<SolidBox> solids;
  float start = 0.0f;  // of its frame, from the room's start along -Z [m]
};

/// The surface of a segment's water; what lies below it within its outline is in the water.
struct PlannedWater {
  Vec3 center = Vec3::Zero();           // room frame [m]
  Vec2 halfExtents = Vec2::Ones();      // in x and z [m]
  std::array<int, 2> cells = {32, 32};  // of its picture
};

struct RoomSettings {
  float length = 0.0f;  // as declared [m]
  Vec3 fogBottom = Vec3(0.2f, 0.25f, 0.3f), fogTop = Vec3(0.6f, 0.7f, 0.8f);
  float reverb[3] = {0, 0, 0};
  float echo[4] = {0, 0, 0, 0};
  float lowPass = 0.0f;
  float focus[3] = {0, 0, 0};  // sharp up to here [m], blurred after so much more [m], how much
  std::string music, particles;
  float gravity = 1.0f;    // times rules::kGravity
  float turns = 0.0f;      // camera roll over the room [turns]
  float turnAngle = 0.0f;  // 0: spins; else it swings between plus and minus this [rad]
  float difficulty = 0.5f;
};

/// A power-up that waits at its place.
struct PlannedPickup {
  PowerUp kind = PowerUp::BallFrenzy;
  Vec3 position = Vec3::Zero();  // room frame [m]
};

struct RoomPlan {
  RoomSettings settings;
  std::vector<PlannedSegment> segments;
  std::vector<PlannedWater> waters;
  std::uint32_t boxes = 0;  // and decals, of all of them
  Crowd crowd;
  std::deque<ObstacleDef> obstacles;  // addresses stay
  std::vector<PlannedPickup> pickups;
  bool hasOtherModes = false;  // some obstacles are for other modes than the game's
  effects::EffectSet effects;  // what its script demands
};

/// One room of a level as its file names it; `attributes` are readable from the script.
struct RoomEntry {
  std::string type;              // rooms/TYPE.lua
  float displayLength = 100.0f;  // what it counts for in the displayed distance
  bool endsAtCheckpoint = false;
  std::map<std::string, std::string> attributes;
  std::string where;  // "file:line"
};

/// Runs the room's script. What fails is reported to the session and the rest of the room stays empty.
RoomPlan planRoom(Session& session, const RoomEntry& entry, std::uint64_t seed,
                  std::map<std::string, std::string>& globals);

/// Appends a segment of the content at `start` [m] with the obstacles it holds; its length, or 0 if it cannot be read,
/// which is reported to be wanted at `where`. What the room cannot hold is left out, and reported once.
float placeSegment(Session& session, const std::string& name, float start, const std::string& where, RoomPlan& plan);

/// Appends a single box given in the room's frame, under the same bounds.
void placeBox(Session& session, const LookBox& box, bool isSolid, const std::string& where, RoomPlan& plan);

/// Appends an obstacle; false, and reported once, if the room is full of them.
bool placeObstacle(Session& session, ObstacleDef def, RoomPlan& plan);

/// Appends a power-up, named as in level files, that is asked for at `where`, with the effect it needs. One that does
/// not exist, or whose effect is not compiled in, is reported and left out.
void placePowerUp(Session& session, const std::string& type, const Vec3& position, const std::string& where,
                  RoomPlan& plan);

/// The community's "stone": a box that is seen and does not collide. Three of four obstacles are stones, so they cost
/// no script.
inline constexpr const char* kStone = "stone";
LookBox stoneLook(const ObstacleDef& stone);

}  // namespace brittle::sim
