#include "game/view/interpolate.h"

namespace brittle::view {
namespace {

/// Farther than this in one tick is another crumb or rope in the same place of the list [m]; 36 m/s.
constexpr float kFarthestStep = 0.6f;

float mix(float a, float b, float t) {
  return a + (b - a) * t;
}

Vec3 mix(const Vec3& a, const Vec3& b, float t) {
  return a + (b - a) * t;
}

/// Along the chord, the short way round: within 0.1 degree of the arc for the up to 40 degrees that things turn in a
/// tick.
Quat mix(const Quat& a, const Quat& b, float t) {
  const float sign = a.dot(b) < 0.0f ? -1.0f : 1.0f;
  return Quat(a.coeffs() * (sign * (1.0f - t)) + b.coeffs() * t).normalized();
}

/// Blends towards one packet's values from those of the packet before it.
class Blend {
 public:
  /// `moved`: from the frame before to the frame now.
  Blend(const Vec3& moved, float alpha) : moved_(moved), alpha_(alpha) {}

  void blend(const Transform& before, Transform& seen) const {
    seen.position = mix(Vec3(before.position + moved_), seen.position, alpha_);
    seen.rotation = mix(before.rotation, seen.rotation, alpha_);
  }

  void blend(const sim::RoomView& before, sim::RoomView& seen) const {
    for (std::size_t i = 0; i < seen.bodies.size() && i < before.bodies.size(); ++i) {
      const bool isSame = seen.bodies[i].generation == before.bodies[i].generation && seen.bodies[i].generation != 0;
      if (isSame) blend(before.bodies[i].pose, seen.bodies[i].pose);
    }
    for (std::size_t i = 0; i < seen.crumbs.size() && i < before.crumbs.size(); ++i)
      if (seen.crumbs[i].radius == before.crumbs[i].radius)
        blendNear(before.crumbs[i].position, seen.crumbs[i].position);
    blend(before.ropes, seen.ropes);
    blend(before.beams, seen.beams);
  }

  void blend(const std::vector<sim::BallView>& before, std::vector<sim::BallView>& seen) const {
    for (sim::BallView& ball : seen)
      for (const sim::BallView& old : before)
        if (old.id == ball.id) blend(old.pose, ball.pose);
  }

 private:
  template <class Line>
  void blend(const std::vector<Line>& before, std::vector<Line>& seen) const {
    if (before.size() != seen.size()) return;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      blendNear(before[i].from, seen[i].from);
      blendNear(before[i].to, seen[i].to);
    }
  }

  void blendNear(const Vec3& before, Vec3& seen) const {
    const Vec3 old = before + moved_;
    if ((seen - old).squaredNorm() < kFarthestStep * kFarthestStep) seen = mix(old, seen, alpha_);
  }

  Vec3 moved_;
  float alpha_;
};

}  // namespace

void interpolate(const sim::FramePacket& before, const sim::FramePacket& now, float alpha, sim::FramePacket& seen) {
  seen = now;
  if (alpha >= 1.0f || before.tick + 1 != now.tick) return;
  const float t = maxOf(alpha, 0.0f);
  const Vec3 moved(0.0f, 0.0f, static_cast<float>(before.originZ - now.originZ));
  const Blend blend(moved, t);
  seen.camera.position = mix(Vec3(before.camera.position + moved), now.camera.position, t);
  seen.camera.rotation = mix(before.camera.rotation, now.camera.rotation, t);
  seen.shake = mix(before.shake, now.shake, t);
  seen.hud.pain = mix(before.hud.pain, now.hud.pain, t);
  seen.hud.distance = mix(before.hud.distance, now.hud.distance, t);
  if (before.hud.roomProgress <= now.hud.roomProgress)
    seen.hud.roomProgress = mix(before.hud.roomProgress, now.hud.roomProgress, t);
  for (sim::RoomView& room : seen.rooms)
    for (const sim::RoomView& old : before.rooms)
      if (old.number == room.number) blend.blend(old, room);
  blend.blend(before.balls, seen.balls);
}

}  // namespace brittle::view
