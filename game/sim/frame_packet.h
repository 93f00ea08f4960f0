// game/sim/frame_packet.h - all that the picture and the sound need of one tick, copied out: shares nothing with the
// live simulation but immutable looks of segments. Meshes are mirrored from Game::meshes(packet.rooms[i].slot) at the
// same moment.
//
// Coordinates are the current room's local frame of this tick (X right, Y up, -Z forward): near the origin, shifted now
// and then. `originZ` tells by how much, for who must keep something in place over several ticks.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/tally.h"
#include "engine/effects/effect.h"
#include "engine/math/transform.h"
#include "engine/math/types.h"
#include "game/sim/charge.h"
#include "game/sim/constants.h"
#include "game/sim/event.h"
#include "game/sim/power_up.h"

namespace brittle::sim {

struct Camera {
  Vec3 position = Vec3(0.0f, 1.0f, 0.0f);  // [m]
  Quat rotation = Quat::Identity();        // looks along -Z; rolls in rotating rooms
  Vec3 velocity = Vec3::Zero();            // [m/s]
  float halfWidthTangent = 0.0f;  // tangent of half the angle from left to right; height follows the picture's aspect
  float near = 0.0f, far = 0.0f;  // [m]

  /// In a picture of this shape, width over height: the same in all but those narrower than rules::kNarrowestPicture.
  float halfWidthTangentIn(float aspect) const {
    return halfWidthTangent * minOf(1.0f, aspect / rules::kNarrowestPicture);
  }
};

/// A box of a segment as its mesh is baked from. In the segment's frame: x, y as in the room, z from 0 (its start) to
/// -length.
struct LookBox {
  Vec3 center = Vec3::Zero();                                  // [m]
  Vec3 halfExtents = Vec3::Ones();                             // [m]
  Vec3 color[3] = {Vec3::Ones(), Vec3::Ones(), Vec3::Ones()};  // x, y and z faces, sRGB as authored
  std::int32_t tile[3] = {0, 0, 0};                            // in the 8 x 8 atlas
  float tileSize[3] = {1.0f, 1.0f, 1.0f};                      // [m]
  std::int32_t tileRotation[3] = {0, 0, 0};                    // quarter turns
  bool reflects = false;
  float glow = 0.0f;
  bool isStone = false;  // an obstacle that is only seen: meshes that files carry do not hold it
};

struct LookDecal {
  Vec3 position = Vec3::Zero();
  Quat rotation = Quat::Identity();
  Vec2 size = Vec2::Ones();  // half extents [m]
  std::int32_t tile = 0;
  Vec4 color = Vec4::Ones();
  float blend = 1.0f;  // 1: normal, 0: additive
};

/// A picture on a body, in the body's frame.
struct BodyDecal {
  std::uint32_t body = 0;  // index into RoomView::bodies
  LookDecal look;
};

/// What a segment looks like: made once when it is placed, never changed.
struct SegmentLook {
  std::string name;            // of its file, or of what it consists of: looks of one name are alike
  std::vector<LookBox> boxes;  // the visible ones
  std::vector<LookDecal> decals;
  float length = 0.0f;                  // [m]
  float light[6] = {1, 1, 1, 1, 1, 1};  // left (-X faces), right, top, bottom, front (+Z), back
  float softShadow = 0.6f;
};

struct PlacedSegment {
  std::uint64_t id = 0;        // unique in a game: a baked mesh can be kept under it
  Vec3 origin = Vec3::Zero();  // of the segment's frame [m]
  std::shared_ptr<const SegmentLook> look;
};

/// The pose of a body slot; vertices of the mesh pool name shapes, shapes name body slots.
struct BodyPose {
  Transform pose;
  std::uint32_t generation = 0;  // 0: the slot is free. A change means another body: do not interpolate
};

struct BallView {
  std::uint32_t id = 0;
  Transform pose;       // of the centre
  float radius = 0.0f;  // [m]
  Charge charge = Charge::None;
};

/// A power-up that waits to be hit: its body stands still, whoever shows it may let it turn.
struct PickupView {
  PowerUp kind = PowerUp::BallFrenzy;
  std::uint32_t body = 0;        // index into RoomView::bodies
  Vec3 position = Vec3::Zero();  // [m]
};

/// A kind of power-up in the inventory.
struct PowerUpView {
  PowerUp kind = PowerUp::BallFrenzy;
  std::int32_t count = 0;  // still to be used
  bool runs = false;
  float left = 0.0f;  // of what runs, 1 to 0; 1 where it waits for a throw
};

struct CrumbView {
  Vec3 position = Vec3::Zero();
  float radius = 0.0f;               // [m]
  std::uint32_t color = 0xffffffff;  // RGBA8, R lowest
};

/// A taut or slack rope between two points. [m]
struct RopeView {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

/// A laser.
struct BeamView {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // [m]
  bool hits = false;                            // something stands where it ends
};

/// A level surface of water.
struct WaterView {
  Vec3 center = Vec3::Zero();           // [m]
  Vec2 halfExtents = Vec2::Ones();      // in x and z [m]
  std::array<int, 2> cells = {32, 32};  // along x and z
};

/// One of the at most two rooms alive: the one the camera is in and the next one.
struct RoomView {
  std::uint64_t number = 0;  // counts up through the game
  std::int32_t ticks = 0;    // since the camera entered it, negative before: what its music is played by
  std::uint32_t slot = 0;    // 0 or 1: Game::meshes(slot); a new number in a slot means another pool: upload everything
  Vec3 fogBottom = Vec3::Zero(), fogTop = Vec3::Zero();  // sRGB as authored, may leave [0, 1]
  float reverb[3] = {0, 0, 0};                           // volume, time [s], low-pass
  float echo[4] = {0, 0, 0, 0};                          // volume, delay [s], feedback, low-pass
  float lowPass = 0.0f;
  effects::EffectMask effects;   // that run in it
  float focus[3] = {0, 0, 0};    // sharp up to [m], blurred after so much more [m], strength
  std::string music, particles;  // names; empty: none
  std::vector<PlacedSegment> segments;
  std::vector<BodyPose> bodies;    // by body slot
  Vec3 bodyOffset = Vec3::Zero();  // added already to every pose of this room
  std::vector<CrumbView> crumbs;
  std::vector<RopeView> ropes;
  std::vector<BeamView> beams;  // lasers
  std::vector<WaterView> waters;
  std::vector<BodyDecal> bodyDecals;
  std::vector<PickupView> pickups;
};

/// Where a game stands. A level runs from its title to the checkpoint at its end, unless the balls run out before.
enum class Phase : std::uint8_t {
  Title,  // the camera waits at the first door for a touch, which throws nothing
  Playing,
  Checkpoint,  // the level's last room is passed: the camera stands in its last door
  GameOver     // out of balls: the camera stands where it was
};

/// "title", "playing", "checkpoint", "game over".
const char* nameOf(Phase phase);

struct Hud {
  Phase phase = Phase::Playing;
  std::uint32_t phaseTicks = 0;  // since the phase began
  bool countsBalls = true;       // false: they are free (zen), show no number
  std::int32_t balls = 0;
  std::int32_t streak = 0;
  std::int32_t ballsPerThrow = 1;
  std::int32_t room = 0;              // which of the level's, from 0
  std::int32_t rooms = 0;             // how many the level has
  std::int32_t checkpointBalls = 0;   // with which the game would begin again at the last checkpoint
  float distance = 0.0f;              // displayed, in the level's units
  float roomProgress = 0.0f;          // 0 to 1
  float pain = 0.0f;                  // red border, 1 to 0
  std::vector<PowerUpView> powerUps;  // held or running, in their places
  bool throwsAreFree = false;         // a held pointer may throw and throw
};

struct FramePacket {
  std::uint64_t tick = 0;
  double time = 0.0;       // of the game: ticks, less what slow motion took of them [ticks]
  float timeShare = 1.0f;  // of the last tick that passed of the game's time
  Camera camera;
  double originZ = 0.0;                  // local z + originZ is the place along the whole game [m]
  float fogNear = 0.0f, fogFull = 0.0f;  // depths [m]
  float shake = 0.0f;                    // camera shake asked for by scripts, 0 to 1
  std::vector<RoomView> rooms;           // the current one first
  std::vector<BallView> balls;
  std::vector<Event> events;
  std::vector<std::string> soundNames;  // that scripts play
  Hud hud;
  std::vector<NamedCount> omissions;  // Game::omissions
  std::int32_t maxDebris = 512;       // light pieces alive at once: physics::Accuracy's

  /// Whether an effect runs in any of its rooms.
  bool runs(effects::Effect effect) const {
    return std::any_of(rooms.begin(), rooms.end(), [=](const RoomView& room) { return room.effects.has(effect); });
  }
};

}  // namespace brittle::sim
