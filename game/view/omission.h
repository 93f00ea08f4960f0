// game/view/omission.h - what is only seen or heard and is left out: because it is behind the camera, or because there
// is so much of it. The more light debris the accuracy's preset allows, the more of the rest there may be at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/tally.h"
#include "engine/render/frame.h"
#include "game/sim/frame_packet.h"

namespace brittle::view {

enum class Omission : std::uint8_t {
  BehindCamera,  // a glow, streak, puff or crumb, or all of what an event threw
  Glow,          // of a picture: SeenBudget, as the next four
  Streak,
  Puff,
  Ripple,
  Shadow,
  Lamp,          // of a mirror: render::kMostMirroredLamps
  BakedMesh,     // given back, to be baked again if it is seen again
  QuietSound,    // beyond the loudest of a tick
  CoveredSound,  // by what was heard just before
  Count
};
const char* nameOf(Omission omission);

/// How many of each kind a picture shows at once.
struct SeenBudget {
  std::size_t glows = 0, streaks = 0, puffs = 0, ripples = 0, shadows = 0;
};
/// `maxDebris`: physics::Accuracy's.
SeenBudget seenBudget(std::int32_t maxDebris);

/// What the parts of a picture keep to, and what they left out so far.
struct Bounds {
  SeenBudget budget = seenBudget(sim::FramePacket().maxDebris);
  Tally<Omission> omissions;
};

/// Of what was added from `first` on, oldest first, keeps the latest `most`. Returns how many went.
template <class Thing>
std::size_t keepLatest(std::vector<Thing>& things, std::size_t first, std::size_t most) {
  if (things.size() <= first + most) return 0;
  const std::size_t gone = things.size() - first - most;
  const auto begin = things.begin() + static_cast<std::ptrdiff_t>(first);
  things.erase(begin, begin + static_cast<std::ptrdiff_t>(gone));
  return gone;
}

/// Wholly behind the camera's plane; a mirror shows none of it either.
inline bool isBehind(const render::Camera& camera, const Vec3& center, float radius) {
  return (camera.rotation * -Vec3::UnitZ()).dot(center - camera.position) + radius < 0.0f;
}

/// Takes out of a picture what is behind its camera, and of the shadows those beyond the budget that are farthest.
void keepWithin(render::Frame& frame, Bounds& bounds);

}  // namespace brittle::view
