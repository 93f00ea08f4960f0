// game/sim/sight.h - what a player who looks ahead can see: for scripted players, which aim by it, and for whoever
// wants to show it. Looking changes nothing.
#pragma once

#include <cstdint>
#include <string>

#include "engine/math/types.h"

namespace brittle::sim {

enum class SightKind : std::uint8_t {
  Crystal,  // one to win
  Threat,   // something of an obstacle on the camera's way, or near it
  Button,   // not pressed yet
  PowerUp   // to collect
};

/// Axes as the camera stands without roll: X right, Y up, Z ahead (positive).
struct Sight {
  SightKind kind = SightKind::Crystal;
  std::uint64_t id = 0;  // of the obstacle, unique in a game
  std::string type;      // of the obstacle, or which power-up
  Vec3 position =
      Vec3::Zero();            // from the camera, what to aim at; of a threat its point nearest to the camera's way [m]
  Vec3 center = Vec3::Zero();  // of the thing [m]
  Vec3 velocity = Vec3::Zero();  // its own, not the camera's [m/s]
  float mass = 0.0f;             // [kg]
  float aside = 0.0f;            // of a threat: from the camera's way; below rules::kCameraRadius it is a crash [m]
  bool gives = false;            // a ball can break it or push it aside
  bool clear = false;            // nothing else is on the line to it
  std::int32_t worth = 0;        // of a crystal [balls]
};

}  // namespace brittle::sim
