#include "game/view/lamps.h"

namespace brittle::view {
namespace {

constexpr float kHalo = 0.75f;  // radius [m]
constexpr float kHaloLight = 0.10f;
constexpr float kPlaces[] = {-0.667f, 0.0f, 0.667f};  // of halos along a lamp

}  // namespace

void addHalos(const sim::SegmentLook& look, const Vec3& origin, std::vector<render::Glow>& glows) {
  for (const sim::LookBox& box : look.boxes) {
    if (box.glow <= 0.0f) continue;
    Eigen::Index longest = 0;
    box.halfExtents.maxCoeff(&longest);
    for (const float place : kPlaces) {
      Vec3 point = origin + box.center;
      point[longest] += place * box.halfExtents[longest];
      glows.push_back({point, kHalo, render::packRgba(box.color[1], kHaloLight)});
    }
  }
}

}  // namespace brittle::view
