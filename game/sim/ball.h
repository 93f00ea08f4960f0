// game/sim/ball.h - the steel balls: how a throw leaves the camera, and what is remembered of a ball.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/math/transform.h"
#include "engine/physics/ids.h"
#include "engine/physics/world.h"
#include "engine/replay/input_frame.h"
#include "game/sim/frame_packet.h"

namespace brittle::sim {

/// Set in Body::userData of balls; the rest is the ball's number.
inline constexpr std::uint32_t kBallBit = 0x80000000u;

inline constexpr std::uint32_t kChargeShift = 28;

struct Ball {
  physics::BodyHandle body;
  std::uint32_t number = 0;  // counts up in its room; its charge stands in bits 28 and 29
  Charge charge() const { return static_cast<Charge>(number >> kChargeShift & 3u); }
  template <class Archive>
  void serialize(Archive& a) {
    a(body);
    a(number);
  }
};

/// How one ball starts, in the frame of `camera`'s pose.
struct BallStart {
  Vec3 position = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
  Charge charge = Charge::None;
};

/// The `count` balls of one throw, side by side. Each is lobbed so that, under `gravity` [m/s2] downwards, it crosses
/// the aimed line at rules::kAimDistance from where it starts.
std::vector<BallStart> throwBalls(const Camera& camera, const replay::Throw& aim, int count, float gravity);

/// A steel ball in a world, awake.
physics::BodyHandle makeBall(physics::World& world, const BallStart& start, std::uint32_t number);

}  // namespace brittle::sim
