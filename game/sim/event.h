// game/sim/event.h - what happened in one tick, for the picture, the sound and the smoke tests. Positions are in the
// local frame of the tick (see FramePacket). Nothing in the simulation reads events back.
#pragma once

#include <cstdint>

#include "engine/math/types.h"

namespace brittle::sim {

/// What a shape looks and sounds like; also MeshInfo::material of its mesh.
enum class Look : std::uint16_t { Static = 0, Glass, Metal, Wood, Stone, Crystal, Ball, Door, PowerUp };

enum class EventType : std::uint8_t {
  Throw,          // a ball left the camera; direction: its velocity
  Break,          // something broke
  Hit,            // two things met, faster than 0.5 m/s
  Crystal,        // value: balls won
  CrystalMissed,  // passed unbroken: the streak is gone
  Crash,          // value: balls lost
  Cleared,        // an obstacle is dealt with; value: which of the 12 notes
  DoorOpens,
  RoomEntered,  // value: the room's number
  Multiball,    // value: the new number of balls per throw
  Sound,        // a script asked for one; value: index into FramePacket::soundNames; size: how loud, 0 to 1
  GameOver,
  LevelDone,         // the last room of the level is passed
  Begin,             // the title is left
  Checkpoint,        // a room that ends at a checkpoint is passed; value: the balls now stored for it
  Smoke,             // a script lets out a puff; direction: where it drifts [m/s]
  Glow,              // a script lights a point, for this tick
  PowerUpCollected,  // by a ball; value: which PowerUp
  PowerUpUsed,       // value: which
  PowerUpEnded,      // has run out; value: which
  Explosion,         // size: how far it pushes [m]; value: things broken; impulse: given to what is loose [N s]
  Splash             // something fell into water; direction: its velocity [m/s]; value: 1 if it was a ball
};

struct Event {
  EventType type = EventType::Hit;
  Look look = Look::Glass;        // of what broke or was hit
  Look striker = Look::Static;    // Hit: of what hit it; a ball if there is one, else the smaller of the two
  Vec3 point = Vec3::Zero();      // [m]
  Vec3 direction = Vec3::Zero();  // the way the striker went, unit (Hit: normal of the contact; Throw: velocity [m/s])
  float speed = 0.0f;             // approach speed [m/s]
  float size = 0.0f;              // of what broke, Hit: of the striker; cube root of its volume [m]
  float impulse = 0.0f;           // [N s]
  std::int32_t value = 0;
  std::uint32_t pieces = 0;  // Break: new bodies
};

}  // namespace brittle::sim
