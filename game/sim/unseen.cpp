#include "game/sim/unseen.h"

#include <cmath>

#include "game/sim/constants.h"

namespace brittle::sim {
namespace {

constexpr float kMargin = 0.3f;     // pictures between two ticks, and a shaken camera, see from elsewhere [m]
constexpr float kWidening = 1.08f;  // of the tangents: a shaken camera rolls by up to 0.03 rad
constexpr float kStill = 0.05f;     // slower is no way to anywhere [m/s]: a sixth of the margin in a second

/// `out`: from the middle of the picture to the side in question; `speed`: that way.
bool isLeavingBy(float tangent, float out, float speed, float depth, const Mover& mover) {
  const float clearance = out - tangent * depth;
  if (clearance <= (mover.radius + kMargin) * std::sqrt(1.0f + tangent * tangent)) return false;
  const float ahead = maxOf(-mover.velocity.z(), 0.0f);  // the view widens that way
  return mover.rests || speed >= tangent * ahead - kStill;
}

}  // namespace

WidestView widestView(const Vec3& eye, bool rolls, float gravity) {
  const float aside = kWidening * rules::kHalfWidthTangent;
  const float below = aside / rules::kNarrowestPicture;
  const float corner = std::sqrt(aside * aside + below * below);
  return {eye, rolls ? corner : aside, rolls ? corner : below, gravity >= 0.0f};
}

bool isLeaving(const WidestView& view, const Mover& mover) {
  const Vec3 from = mover.center - view.eye;
  const float depth = -from.z();
  const float side = from.x() < 0.0f ? -1.0f : 1.0f;
  if (isLeavingBy(view.aside, side * from.x(), side * mover.velocity.x(), depth, mover)) return true;
  return (view.fallsDown || mover.rests) && isLeavingBy(view.below, -from.y(), -mover.velocity.y(), depth, mover);
}

void goOn(std::span<const physics::BodyHandle> bodies, std::uint32_t ticks, std::vector<Unseen>& unseen) {
  std::vector<Unseen> now;
  now.reserve(bodies.size());
  std::size_t before = 0;
  for (const physics::BodyHandle body : bodies) {
    while (before < unseen.size() && unseen[before].body.index < body.index) ++before;
    const bool isKnown = before < unseen.size() && unseen[before].body == body;
    now.push_back({body, isKnown ? unseen[before].ticks + ticks : 0});
  }
  unseen = std::move(now);
}

}  // namespace brittle::sim
