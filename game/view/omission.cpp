#include "game/view/omission.h"

#include <iterator>

#include <algorithm>

namespace brittle::view {
namespace {

/// A share of `maxDebris` in 64ths.
std::size_t share(std::int32_t maxDebris, std::size_t parts) {
  return static_cast<std::size_t>(maxOf(maxDebris, 0)) * parts / 64;
}

}  // namespace

const char* nameOf(Omission omission) {
  constexpr const char* names[] = {
      "seen things behind", "glows",          "streaks",      "puffs of smoke", "ripples", "shadows",
      "lamps mirrored",     "meshes unbaked", "quiet sounds", "covered sounds"};
  static_assert(std::size(names) == static_cast<std::size_t>(Omission::Count));
  return names[static_cast<int>(omission)];
}

SeenBudget seenBudget(std::int32_t maxDebris) {
  return {share(maxDebris, 256), share(maxDebris, 128), share(maxDebris, 25), share(maxDebris, 3),
          share(maxDebris, 64)};
}

void keepWithin(render::Frame& frame, Bounds& bounds) {
  const render::Camera& camera = frame.camera;
  const auto drop = [&](auto& things, const auto& isGone) {
    bounds.omissions.add(Omission::BehindCamera, std::erase_if(things, isGone));
  };
  const auto isBall = [&](const auto& thing) { return isBehind(camera, thing.position, thing.radius); };
  drop(frame.glows, isBall);
  drop(frame.puffs, isBall);
  drop(frame.crumbs, isBall);
  drop(frame.beams, [&](const render::Beam& beam) {
    return isBehind(camera, beam.from, beam.radius) && isBehind(camera, beam.to, beam.radius);
  });
  if (frame.shadows.size() <= bounds.budget.shadows) return;
  std::stable_sort(frame.shadows.begin(), frame.shadows.end(), [&](const render::Shadow& a, const render::Shadow& b) {
    return (a.position - camera.position).squaredNorm() < (b.position - camera.position).squaredNorm();
  });
  bounds.omissions.add(Omission::Shadow, frame.shadows.size() - bounds.budget.shadows);
  frame.shadows.resize(bounds.budget.shadows);
}

}  // namespace brittle::view
